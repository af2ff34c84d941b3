# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/cycles/cycles.md."""
from data import data
from formats import change, fixed, group, mean, table, thousands
from measurements import COSTED, FOUR, LARGE, STEPS, WHAT_IF
from pages.cycles import results, scale, walks

MEASURED = [
    "ladder/*",
    "what_if/*",
    "steps/*",
    "costs/*",
    "large/*",
    "lanes/*",
    "results/statue_0",
    *results.MEASURED,
    *walks.MEASURED,
    *scale.MEASURED,
]
TITLES = {"own": "our own scene", "terrace": "terrace 0", "statue": "statue 0", "flowers": "flowers 0"}
VIEWS = {
    "own": ("60k Gaussians, SH 3", "1024x768"),
    "terrace": ("300k, SH 3", "1236x822"),
    "statue": ("134k, SH 0", "960x1280"),
    "flowers": ("542k, SH 2", "1296x840"),
}


def bound(point):
    """Cycles that the busiest resource needs."""
    return point.cycles / point.cycles_over_largest_bound


def views(name):
    """A design point, scene by scene, beside its bound."""
    rows = []
    for scene in FOUR:
        point, (size, pixels) = data.ladder[scene][name], VIEWS[scene]
        rows.append(
            [
                f"{TITLES[scene]} ({size})",
                pixels,
                point.cycles,
                f"{point.largest_bound}, {thousands(bound(point))}",
                fixed(point.cycles_over_largest_bound, 3),
            ]
        )
    ratio = mean(data.ladder[scene][name].cycles_over_largest_bound for scene in FOUR)
    return table(
        ["view", "pixels", "cycles", "largest bound", "roofline ratio"], [*rows, ["mean", "", "", "", fixed(ratio, 3)]]
    )


def gain(scene, name):
    """Cycles more, as a share, when one thing is changed."""
    return data.what_if[scene][name].cycles / data.ladder[scene].exact.cycles - 1


def what_if():
    """One thing changed."""

    def cell(scene, name):
        more = gain(scene, name)
        cycles = group(data.what_if[scene][name].cycles)
        return f"{cycles} ({change(more)})" if more else cycles

    rows = [["as it is", *[data.ladder[scene].exact.cycles for scene in FOUR]]]
    rows += [[f"`{option}`", *[cell(scene, name) for scene in FOUR]] for name, option in WHAT_IF.items()]
    return table(["", *TITLES.values()], rows)


def megabytes(point):
    return point.bytes / 1e6


def steps():
    """Cycles, megabytes and multiple of the floor, step by step."""

    def cell(scene, point):
        floor = data.lanes[scene].blended / 64
        return f"{group(point.cycles)}, {fixed(megabytes(point), 1)} MB ({fixed(point.cycles / floor, 2)})"

    rows = [["`exact`", *[cell(scene, data.ladder[scene].exact) for scene in FOUR]]]
    rows += [[what, *[cell(scene, data.steps[scene][name]) for scene in FOUR]] for name, (what, _) in STEPS.items()]
    over = [data.ladder[scene].baseline.cycles / data.steps[scene].fast.cycles for scene in FOUR]
    rows += [["times as fast as `baseline`", *[fixed(ratio, 2) for ratio in over]]]
    return table(["each step adds to the one before", *TITLES.values()], rows)


def costs():
    """Our own scene: area, longest path and energy, step by step; steps that were measured."""
    rows = [
        [
            what,
            fixed(point.mm2, 3),
            fixed(point.path_ps, 0),
            group(point.chip_uj),
            group(point.dram_uj),
            group(point.frames_per_joule),
            group(point.frames_per_joule_with_dram),
        ]
        for name, (what, _) in COSTED.items()
        if name in data.costs
        for point in [data.costs[name]]
    ]
    head = ["mm2", "longest path, ps", "uJ of the chip", "uJ of DRAM", "frames/J", "with DRAM"]
    return table(["each step adds to the one before", *head], rows)


def large():
    """A large scene: cycles, megabytes, and those of records that found no room in the SUs."""
    rows = [
        [what, group(point.cycles), fixed(megabytes(point), 0), fixed(point.sort / 1e6, 0)]
        for name, (what, _) in LARGE.items()
        for point in [data.large.showroom[name]]
    ]
    return table(["showroom 0 (3.0 M Gaussians)", "cycles", "MB", "of them records and keys that found no room"], rows)


def fast_mean():
    """How many times as fast as baseline, mean of the four scenes."""
    return mean(data.ladder[scene].baseline.cycles / data.steps[scene].fast.cycles for scene in FOUR)


def lanes():
    """Cycles of four RUs of sixteen lanes, by what their lanes work on; blended pairs are the floor of 64 lanes."""

    def cell(scene, cycles):
        floor = data.lanes[scene].blended / 64
        return f"{thousands(cycles)} ({fixed(cycles / floor, 2)})"

    rows = [
        ["whole regions", *[cell(scene, data.lanes[scene].open_regions) for scene in FOUR]],
        ["living quads, `--set quads=1`", *[cell(scene, data.lanes[scene].quads / 16) for scene in FOUR]],
        ["floor: blended pairs / 64 lanes", *[thousands(data.lanes[scene].blended / 64) for scene in FOUR]],
    ]
    return table(["the lanes work on", *TITLES.values()], rows)
