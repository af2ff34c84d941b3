# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/numerics/fixed_time.md."""
import statistics

from data import data
from formats import fixed, group, listing, percent, table, thousands
from measurements import BUDGETED, BUDGETS, COARSER, PART, PROXIES  # noqa: F401  (the page uses BUDGETED and PART)
from pages.numerics.time import TITLES, base, share, single

MEASURED = ["budgets/*", "proxies/*", "levels/*", "tradeoff/*"]
UNIT = {"k": 1000, "M": 1000000}
MISS = 0.1  # of the budget: a frame that takes more than so much above it has missed it
STEPS = (0.5, 1, 2, 4)  # pixels: of `study tradeoff`


def budget(scene):
    """Cycles."""
    return int(BUDGETS[scene][:-1]) * UNIT[BUDGETS[scene][-1]]


def walked():
    """The scenes whose walks are measured: the largest one's with class d only."""
    return [scene for scene in BUDGETS if all(f"{scene}_{kind}" in data.budgets for kind in ("free", "held"))]


def frames(scene, kind):
    return data.budgets[f"{scene}_{kind}"].views


def taken(scene, kind):
    """Cycles of each frame."""
    return [one.cycles_alone for one in frames(scene, kind)]


def kept(scene):
    """The share of the frames that take no more than a tenth above the budget."""
    found = taken(scene, "held")
    return sum(cycles <= (1 + MISS) * budget(scene) for cycles in found) / len(found)


def by_pixels():
    """Proxies alone, by how much they may differ."""
    rows = [["none: us, dB, SSIM", *map(whole, TITLES)]]
    for pixels in STEPS:
        found = [single(scene, "proxies", f"below {pixels:g} pixels") for scene in TITLES]
        cells = [
            f"{share(scene, one)}, {fixed(one.psnr_db, 1)}, {fixed(one.ssim, 4)}" for scene, one in zip(TITLES, found)
        ]
        rows.append([f"below {pixels:g}: time, dB, SSIM", *cells])
    return table(["pixels", *TITLES.values()], rows)


def whole(scene):
    return f"{fixed(base(scene).us, 1)}, {fixed(base(scene).psnr_db, 1)}, {fixed(base(scene).ssim, 4)}"


def shown(pixels):
    """How far a picture of this page is from the truth."""
    return f"{fixed(data.proxies[f'own_{pixels}'].psnr_total_db, 1)} dB"


def walks():
    """What frames take, without a budget and with one."""
    return listing(
        "walk, thousands of cycles",
        [(TITLES[scene], scene) for scene in walked()],
        ("without: median", lambda scene: statistics.median(taken(scene, "free")) / 1e3, fixed, 0),
        ("largest", lambda scene: max(taken(scene, "free")) / 1e3, fixed, 0),
        ("budget", lambda scene: thousands(budget(scene))),
        ("median", lambda scene: statistics.median(taken(scene, "held")) / 1e3, fixed, 0),
        ("largest", lambda scene: max(taken(scene, "held")) / 1e3, fixed, 0),
        ("frames within a tenth above it", lambda scene: percent(kept(scene), 1)),
    )


def levels_used():
    """How far a budget goes in its two knobs."""

    def most(scene, key):
        return max(one[key] or 0 for one in frames(scene, "held"))

    return listing(
        "walk",
        [(TITLES[scene], scene) for scene in walked()],
        ("rest: median", lambda scene: percent(statistics.median(one.rest or 0 for one in frames(scene, "held")), 2)),
        ("most", lambda scene: percent(most(scene, "rest"), 1)),
        (
            "frames with proxies",
            lambda scene: percent(sum(bool(one.lod_pixels) for one in frames(scene, "held")) / BUDGETED),
        ),
        ("most pixels", lambda scene: fixed(most(scene, "lod_pixels"), 2)),
    )


def popping():
    """dB between neighbouring frames, without a budget and with one."""

    def steady(scene, kind):
        return [one.steady_db for one in frames(scene, kind)[1:]]

    return listing(
        "walk, dB to the frame before",
        [(TITLES[scene], scene) for scene in walked()],
        *[
            (f"{title}: {rank}", lambda scene, kind=kind, of=of: of(steady(scene, kind)), fixed, 1)
            for title, kind in (("without", "free"), ("within the budget", "held"))
            for rank, of in (("median", statistics.median), ("least", min))
        ],
    )


def levels():
    """One scene by its own levels of detail and by proxies."""

    def title(name):
        kind, number = name.split("_")
        if kind == "proxies":
            return f"proxies below {number} pixel{'s' if number != '1' else ''}"
        return f"its level {number}" if number != "0" else "all of it, its level 0"

    return listing(
        "flowers 0",
        [(title(name), data.levels[f"flowers_{name}"].views[0]) for name in COARSER],
        ("cycles", "cycles_alone", group),
        ("MB", lambda one: (one.bytes_read + one.bytes_written) / 1e6, fixed, 1),
        ("dB", "psnr_db", fixed, 1),
        ("SSIM", "ssim", fixed, 4),
    )
