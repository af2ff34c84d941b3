# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/cycles/ladder.md."""
from data import data
from formats import fixed, group, mean, percent, span, table, times
from measurements import FOUR, points_of

MEASURED = [
    "ladder/*",
    "energy/*",
    "equal_area/*",
    "lanes/*",
    "sweep/*",
    "results/terrace_0",
    "stores/*",
    "positions/*",
]
PAPER = {"baseline": ("1.00", "7.48"), "dpc": ("-", "5.71"), "tspp": ("2.33", "1.83"), "dop": ("2.85", "-")}
FOR = ("fps_per_mm2", "frames_per_joule", "frames_per_joule_with_dram")
SWEPT = ("baseline", "dop", "exact", "fast")


def ladder(scene):
    """One scene: a row for each design point."""
    rows = []
    for point in points_of(data.ladder[scene]):
        row, paper = data.ladder[scene][point], PAPER.get(point, ("-", "-"))
        rows.append(
            [
                f"`{point}`",
                row.cycles,
                group(row.fps),
                times(row.speedup),
                paper[0],
                fixed(row.raster_over_sort, 2),
                paper[1],
                percent(row.bubbles),
                percent(row.exposed_share, 1),
                group(row.bytes / 1e6),
                fixed(row.cycles_over_largest_bound, 2),
                row.largest_bound,
                fixed(row.psnr_order_db, 1),
                row.mismatches,
            ]
        )
    return table(
        [
            "design point",
            "cycles",
            "fps at 1 GHz",
            "speed-up",
            "paper, up to",
            "raster / sort",
            "paper",
            "bubbles",
            "exposed",
            "MB",
            "roofline ratio",
            "of",
            "order dB",
            "mismatches",
        ],
        rows,
    )


STORES = {  # of dop: name of the measurement, lines, layers
    "lines1024_layers2": ("1024", 2),
    "lines1024_layers4": ("1024", 4),
    "lines1024": ("1024, `dop`", 8),
    "paper": ("840, 512 records in an SU", 8),
    "lines2048": ("2048", 8),
    "lines4096": ("4096", 8),
    "lines8192_layers2": ("8192", 2),
    "lines8192_layers4": ("8192", 4),
    "lines8192": ("8192", 8),
}


def stores():
    """What the alpha stores of dop are worth: cycles, over baseline, MB, scene by scene."""
    rows = []
    for name, (lines, layers) in STORES.items():
        cells = [data.stores[scene][name] for scene in FOUR]
        over = [store_over(scene, name) for scene in FOUR]
        rows.append(
            [lines, layers]
            + [f"{group(one.cycles)} ({times(gain)})" for one, gain in zip(cells, over)]
            + [" / ".join(group(one.bytes / 1e6) for one in cells)]
        )
    return table(["lines of a store", "layers", *[f"{scene}: cycles" for scene in FOUR], "MB of the four"], rows)


def positions():
    """What finer positions and shorter colours do to the picture of dop, dB."""
    rows = []
    for scene in FOUR:
        plain, finer = data.positions[scene].plain, data.positions[scene].finer
        rows.append(
            [scene, fixed(plain.psnr_order_db, 1)]
            + [fixed(one.psnr_numeric_db, 2) for one in (plain, finer)]
            + [fixed(one.psnr_total_db, 2) for one in (plain, finer)]
        )
    return table(["scene", "order, dB", "numeric, dB", "finer", "total, dB", "finer"], rows)


def store_over(scene, name):
    """Over baseline, by the same timing model."""
    return data.stores[scene].baseline.cycles / data.stores[scene][name].cycles


def store_spans(name):
    """The span of that over the scenes."""
    return span(fixed, [store_over(scene, name) for scene in FOUR], 2)


def fair(scene):
    """Each design point at the clock that it reaches: for its area, and for a joule."""
    found = data.energy[scene]
    base = found.baseline
    rows = [
        [
            f"`{point}`",
            fixed(row.ghz, 3),
            group(row.us),
            times(base.us / row.us),
            fixed(row.mm2, 2),
            *[cell for key in FOR for cell in (group(row[key]), times(row[key] / base[key]))],
        ]
        for point in points_of(found)
        for row in [found[point]]
    ]
    head = ["design point", "GHz", "us", "over baseline", "mm2", "frames/s/mm2", "over", "frames/J", "over"]
    return table([*head, "with DRAM", "over"], rows)


def best_over(key):
    """The span over the scenes of what `fast` has over baseline."""
    return span(fixed, [data.energy[scene].fast[key] / data.energy[scene].baseline[key] for scene in FOUR], 2)


def equal():
    """The time of a frame at the area that all have, scene by scene."""
    rows = []
    for point in points_of(data.equal_area.own):
        at = {scene: data.equal_area[scene][point] for scene in FOUR}
        over = {scene: data.equal_area[scene].baseline.us / at[scene].us for scene in FOUR}
        half = fixed(at["own"].half_mm2, 2)
        rows.append([f"`{point}`", half, *[f"{group(at[scene].us)} ({times(over[scene])})" for scene in FOUR]])
    return table(["us of a frame (over `baseline`)", "mm2 of half a machine", *FOUR], rows)


def equal_mean(point):
    """The mean over the scenes of what a design point has over baseline at the area that all have."""
    return fixed(mean(data.equal_area[scene].baseline.us / data.equal_area[scene][point].us for scene in FOUR), 2)


def built_of():
    """What each design point is made of; by the configuration alone, so the same for every scene."""
    rows = []
    for point in points_of(data.ladder.own):
        built = data.ladder.own[point].built_of
        rows.append(
            [
                f"`{point}`",
                f"{built.row_lanes} / {built.blend_lanes}",
                *[built.multipliers[kind] for kind in ("power", "color", "projection", "blend", "all")],
                built.adders,
                fixed(built.buffer_bytes / 1024, 1),
            ]
        )
    return table(
        [
            "design point",
            "lanes power / blend",
            "multipliers: power",
            "colour",
            "projection",
            "blend",
            "all",
            "adders",
            "buffers KB",
        ],
        rows,
    )


def best():
    """fast over baseline, over the floor, and its roofline ratio, scene by scene."""
    point = {scene: data.ladder[scene].fast for scene in FOUR}
    to_floor = {scene: one.cycles / (data.lanes[scene].blended / 64) for scene, one in point.items()}
    rows = [
        [
            scene,
            times(one.speedup),
            "up to 2.85x",
            fixed(to_floor[scene], 2),
            fixed(one.cycles_over_largest_bound, 3),
            one.largest_bound,
        ]
        for scene, one in point.items()
    ]
    means = [mean(one[key] for one in point.values()) for key in ("speedup", "cycles_over_largest_bound")]
    rows.append(["mean", times(means[0]), "", fixed(mean(to_floor.values()), 2), fixed(means[1], 3), ""])
    head = [
        "scene",
        "`fast` over `baseline`",
        "paper, final over Baseline",
        "cycles / floor",
        "roofline ratio",
        "bound by",
    ]
    return table(head, rows)


def sweep():
    """Cycles by bandwidth."""
    rows = []
    for scene in FOUR:
        for point in SWEPT:
            row = data.sweep[scene][point]
            rows.append(
                [
                    scene if point == SWEPT[0] else "",
                    f"`{point}`",
                    row.at_12_8,
                    row.at_25_6,
                    row.at_51_2,
                    row.at_102_4,
                    group(data.ladder[scene][point].bytes / 1e6),
                    f"{row.enough:g}",
                ]
            )
    return table(
        [
            "scene",
            "design point",
            "12.8",
            "25.6",
            "51.2",
            "102.4 GB/s",
            "MB",
            "more bandwidth saves less than 5 % from",
        ],
        rows,
    )


def alphas(scene, point):
    """Bytes of alphas that go to memory and come back."""
    return data.ladder[scene][point].alpha_bytes


def over(scene, faster, slower):
    """How many times as fast one design point is as another."""
    return data.ladder[scene][slower].cycles / data.ladder[scene][faster].cycles


def faster(point, than):
    """The span over the scenes."""
    return span(fixed, [over(scene, point, than) for scene in FOUR], 2)


def shares(key, *points):
    """The span of a share over the scenes and some design points."""
    return span(percent, [data.ladder[scene][point][key] for scene in FOUR for point in points], 1)
