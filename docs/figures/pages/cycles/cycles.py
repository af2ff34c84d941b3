# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/cycles/cycles.md."""
from data import data
from formats import change, fixed, group, listing, mean, percent, table, thousands, times
from measurements import CHARTED, FOUR, FRAMES, STEPPED, STEPS  # noqa: F401  (the page uses FRAMES)
from pages.frames import VIEWS, bounds, cycles, floor, largest_bound, megabytes, of, over, roofline, total_bytes, work

MEASURED = ["model/*", "work/*", "steps/*", "stores/*", "walks/*", "truth/*", "rtl/*"]


def views():
    """`fast`, scene by scene, beside its bound and the floor."""
    found = [(VIEWS[scene], scene) for scene in FOUR]
    rows = listing(
        "view",
        found,
        ("cycles", lambda scene: cycles(scene, "fast")),
        ("MB", lambda scene: megabytes(scene, "fast"), fixed, 1),
        ("largest bound", lambda scene: "{}, {}".format(largest_bound(scene)[0], thousands(largest_bound(scene)[1]))),
        ("roofline ratio", roofline, fixed, 3),
        ("cycles / floor", lambda scene: cycles(scene, "fast") / floor(scene), fixed, 2),
        ("over `baseline`", lambda scene: over(scene, "fast"), times),
    )
    means = [
        mean(map(one, FOUR)) for one in (roofline, lambda s: cycles(s, "fast") / floor(s), lambda s: over(s, "fast"))
    ]
    return rows + f"\n| mean |  |  |  | {fixed(means[0], 3)} | {fixed(means[1], 2)} | {times(means[2])} |"


RANKS = ("median", "p90", "max")


def walk(scene, quantity, rank):
    return data.walks[scene].percentiles[quantity][rank].value


def walks():
    """What a frame of a walk takes."""
    rows = [
        [VIEWS[scene].split(" (")[0], what, *[form(walk(scene, quantity, rank), *digits) for rank in RANKS]]
        for scene in CHARTED
        for quantity, what, form, *digits in (("cycles", "cycles", group), ("megabytes", "MB", fixed, 1))
    ]
    return table(["walk", "", "median", "90 %", "largest"], rows)


def worst(scene):
    """The most expensive frame over the median."""
    return walk(scene, "cycles", "max") / walk(scene, "cycles", "median")


def step(scene, name):
    """Cycles with all steps up to this one."""
    return data.steps[f"{scene}_{name}"].designs[0].cycles


def steps():
    """Cycles, megabytes and multiple of the floor, step by step."""

    def cell(scene, count, size):
        return f"{group(count)}, {fixed(size, 1)} MB ({fixed(count / floor(scene), 2)})"

    def sums(scene, name):
        size = total_bytes(data.steps[f"{scene}_{name}"].designs[0].bytes)
        return cell(scene, step(scene, name), size / 1e6)

    def end(name):
        return [cell(scene, cycles(scene, name), megabytes(scene, name)) for scene in STEPPED]

    rows = [["`exact`", *end("exact")]]
    rows += [[what, *[sums(scene, name) for scene in STEPPED]] for name, (what, _) in STEPS.items()]
    rows += [["pixels of 32 bits, 1408 records, 1024 nodes, a watermark every 7 chunks: `fast`", *end("fast")]]
    return table(["each step adds to the one before", *[VIEWS[scene].split(" (")[0] for scene in STEPPED]], rows)


def lanes():
    """Cycles of four RUs of sixteen lanes that never wait, by what their lanes work on."""

    def cell(scene, count):
        return f"{thousands(count)} ({fixed(count / floor(scene), 2)})"

    rows = [
        ["whole regions", *[cell(scene, work(scene).work.open_regions) for scene in FOUR]],
        ["living quads", *[cell(scene, work(scene).work.quads / 16) for scene in FOUR]],
        ["floor: blended pairs / 64 lanes", *[thousands(floor(scene)) for scene in FOUR]],
    ]
    return table(["the lanes work on", *FOUR], rows)


def errors(name):
    """Decibels of a design point, scene by scene."""
    return listing(
        f"`{name}`",
        [(VIEWS[scene], work(scene, name)) for scene in FOUR],
        ("numeric dB", "psnr_numeric_db", fixed, 1),
        ("order dB", "psnr_order_db", fixed, 1),
        ("total dB", "psnr_total_db", fixed, 1),
        ("largest error", "max_abs_error", fixed, 4),
    )


def pairs():
    """What `fast` has to do: thousands of pairs, and bounds."""
    counts = ("fetched", "visible", "records", "regions", "open_regions")
    return listing(
        "thousands of",
        [(scene, scene) for scene in FOUR],
        *[(name.replace("_", " "), lambda scene, name=name: work(scene).work[name] / 1e3, group) for name in counts],
        ("blended", lambda scene: work(scene).work.blended / 1e3, group),
        *[(f"bound: {name}", lambda scene, name=name: bounds(scene)[name] / 1e3, group) for name in bounds("own")],
    )


def states():
    """Where the cycles of the units of terrace 0 go, by the RTL, as far as it was run."""

    def share(one, state):
        units, cycles = one
        return percent(sum(unit[state] for unit in units) / (len(units) * cycles), 1)

    frames = [(name, data.rtl[f"terrace_{name}"]) for name in ("fast", "dop")]
    found = [
        (f"`{name}`, {unit.upper()}", (frame.units[unit], frame.cycles))
        for name, frame in frames
        if "units" in frame
        for unit in ("dopu", "pu", "su", "ru")
    ]
    return listing(
        "unit",
        found,
        *[(state, lambda one, state=state: share(one, state)) for state in ("busy", "starved", "blocked", "memory")],
    )


def truth():
    """Our float64 pictures against those of an independent renderer."""
    columns = [("pixels", "pixels"), ("pixels that differ", "differ"), ("largest difference, 8-bit codes", "codes")]
    return listing("view", [(f"{scene} 0", data.truth[scene]) for scene in data.truth], *columns)
