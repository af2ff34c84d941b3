# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/cycles/ladder.md."""
from data import data
from formats import fixed, group, listing, percent, span, table, times
from measurements import BY_BANDWIDTH, CHANNELS, CHARTED, FOUR, POINTS
from pages.frames import cycles, fast_mean, megabytes, of, over, total_bytes, work  # noqa: F401  (the page uses them)
from pages.silicon.silicon import design, kilo  # noqa: F401  (the page uses kilo)

MEASURED = ["model/*", "work/*", "rtl/own", "stores/*", "silicon/*", "bandwidth/*"]
QUADRATIC = design("own", "baseline").configuration
PAPER = {  # speed-up over Baseline, raster / sort
    "baseline": ("1.00", "7.48"),
    "dpc": ("-", "5.71"),
    "tspp": ("2.33", "1.83"),
    "dop": ("2.85", "-"),
}


def scenes():
    """Every design point on four scenes: cycles, and how many times as fast as baseline; MB."""

    def measured(scene, name):
        return any(row.name == name for row in data.model[scene].designs)

    def cell(scene):
        return lambda name: (
            f"{group(cycles(scene, name))} ({times(over(scene, name))})" if measured(scene, name) else "-"
        )

    def moved(name):
        return " / ".join(group(megabytes(scene, name)) if measured(scene, name) else "-" for scene in FOUR)

    return listing(
        "design point",
        [(f"`{name}`", name) for name in POINTS],
        *[(scene, cell(scene)) for scene in FOUR],
        ("paper, up to", lambda name: PAPER.get(name, "-")[0]),
        ("MB of the four", moved),
    )


def rtl(name):
    return of(data.rtl.own, name)


def own():
    """Our own scene by the RTL."""
    return listing(
        "design point",
        [(f"`{name}`", rtl(name)) for name in POINTS],
        ("cycles", "cycles"),
        ("mismatches", "mismatches"),
        ("raster / sort", "raster_over_sort", fixed, 2),
        ("paper", lambda row: PAPER.get(row.name, "--")[1]),
        ("bubbles", "bubbles", percent),
        ("exposed", "exposed_share", percent, 1),
        ("roofline ratio", "cycles_over_largest_bound", fixed, 2),
        ("of", "largest_bound"),
        ("order dB", "psnr_order_db", fixed, 1),
    )


def built_of():
    """What each design point is made of; by the configuration alone, so the same for every scene."""
    return listing(
        "design point",
        [(f"`{name}`", rtl(name)["static"]) for name in POINTS],
        ("lanes power / blend", lambda one: f"{one.row_lanes} / {one.blend_lanes}"),
        ("buffers, KB", lambda one: one.buffer_bytes / 1024, fixed, 1),
    )


def alphas(name):
    """MB of alphas that go to memory and come back, our own scene; what the stream raster writes are pixels."""
    streams = rtl(name).bytes_by_stream
    return (total_bytes({"": streams.alpha_overflow_write}) + streams.raster["read"]) / 1e6


def faster(name, base):
    """Over the four scenes."""
    return span(fixed, [over(scene, name, base) for scene in FOUR], 2)


def stored(scene, name):
    """Of `dop` with other alpha stores."""
    return data.stores[f"{scene}_{name}"].designs[0]


def stores():
    """What the alpha stores of `dop` gain: cycles, over baseline, MB."""

    def cell(scene, row):
        return f"{group(row.cycles)} ({times(cycles(scene, 'baseline') / row.cycles)})"

    machines = {
        "1024, `dop`": None,
        "840, and 512 records in an SU: 428 KB in all, as the paper's": "paper",
        "4096": "lines4096",
    }
    rows = []
    for what, name in machines.items():
        found = {scene: stored(scene, name) if name else of(data.model[scene], "dop") for scene in CHARTED}
        size = " / ".join(group(total_bytes(row.bytes) / 1e6) for row in found.values())
        rows.append([what, *[cell(scene, row) for scene, row in found.items()], size])
    return table(["lines of a store", *CHARTED, "MB of the two"], rows)


def fair(scene):
    """Each design point at the clock that it reaches: for its area, and for a joule."""
    base = design(scene, "baseline")

    def both(key):
        return lambda row: f"{group(row[key])} ({times(row[key] / base[key])})"

    return listing(
        scene,
        [(f"`{name}`", design(scene, name)) for name in ("fast", "baseline", "dop", "exact")],
        ("GHz", "ghz", fixed, 3),
        ("us", lambda row: f"{group(row.us)} ({times(base.us / row.us)})"),
        ("mm2", lambda row: next(one for one in row.rows if one.name == "Total").area_mm2.mid, fixed, 2),
        ("frames/s/mm2", both("fps_per_mm2")),
        ("frames/J, chip", both("frames_per_joule")),
        ("with DRAM", both("frames_per_joule_with_dram")),
    )


def best_over(key):
    """The span over the scenes of what `fast` has over baseline."""
    return span(fixed, [design(scene, "fast")[key] / design(scene, "baseline")[key] for scene in CHARTED], 2)


def swept(scene, name, channels):
    """Cycles with so many channels of LPDDR5-6400, 12.8 GB/s each."""
    return cycles(scene, name) if channels == 4 else of(data.bandwidth[f"{scene}_x{channels}"], name).cycles


def bandwidth():
    """Cycles by bandwidth, and the lowest one from which on more saves less than 5 %."""
    rows = []
    for scene in CHARTED:
        for name in BY_BANDWIDTH:
            at = {channels: swept(scene, name, channels) for channels in sorted((*CHANNELS, 4))}
            enough = min(channels for channels in at if at[channels] <= 1.05 * at[8])
            rows.append([scene, f"`{name}`", *at.values(), fixed(12.8 * enough, 1)])
    gbs = [fixed(12.8 * channels, 1) for channels in sorted((*CHANNELS, 4))]
    return table(["scene", "design point", *gbs[:-1], f"{gbs[-1]} GB/s", "more saves less than 5 % from"], rows)
