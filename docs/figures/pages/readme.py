# SPDX-License-Identifier: Apache-2.0
"""The table of README.md, and what `make run` prints."""
import re

from data import data
from formats import block, fixed, table
from measurements import FOUR, points_of
from pages.cycles.ladder import PAPER
from pages.cycles.cycles import fast_mean

MEASURED = ["ladder/*", "shown/sim", "loops/*"]
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


def minutes(*loops):
    """What these take together on one core."""
    return f"{fixed(sum(data.loops.all[loop] for loop in loops) / 60, 1)} CPU minutes"


def gigabytes(key):
    return f"{fixed(data.loops.all[key] / 1024, 1)} GB"


def sample():
    """Of four units of a kind the first."""
    return block(line for line in data.shown.sim.lines if not re.match(r" +(pu|su|ru) +[1-9] ", line))


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
