# SPDX-License-Identifier: Apache-2.0
"""The table of docs/architect.md."""
from data import data
from formats import fixed, table
from measurements import FOUR, points_of
from pages.cycles.ladder import PAPER

MEASURED = ["ladder/*"]
TITLES = {
    "gscore": "GSCore",
    "baseline": "baseline",
    "dpc": "DPC",
    "tspp": "+ TSPP",
    "dop": "+ DOP: PipeGS",
    "late": "late alphas",
    "exact": "exact order, no layers",
    "fast": "the default",
}


def speedups():
    """Over the paper's baseline, scene by scene."""
    points = points_of(*[data.ladder[scene] for scene in FOUR])

    def row(scene):
        return [
            "our own scene" if scene == "own" else scene,
            *[fixed(data.ladder[scene][point].speedup, 2) for point in points],
        ]

    paper = ["paper, up to", *[PAPER.get(point, ("-",))[0] for point in points]]
    return table(
        ["", *[TITLES[point] for point in points]],
        [["design point", *[f"`{point}`" for point in points]], *map(row, FOUR), paper],
    )
