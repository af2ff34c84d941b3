# SPDX-License-Identifier: Apache-2.0
"""The table of README.md, and what `make run` prints."""
import re

from data import data
from formats import block, fixed, table
from measurements import FOUR, POINTS
from pages.cycles.ladder import PAPER

MEASURED = ["ladder/*", "shown/sim", "loops/*"]


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

    def row(scene):
        return [
            "our own scene" if scene == "own" else scene,
            *[fixed(data.ladder[scene][point].speedup, 2) for point in POINTS],
        ]

    paper = ["paper, up to", *[PAPER.get(point, ("-",))[0] for point in POINTS]]
    return table(
        ["", "baseline", "DPC", "+ TSPP", "+ DOP: PipeGS", "late alphas", "exact order, no layers"],
        [["design point", *[f"`{point}`" for point in POINTS]], *map(row, FOUR), paper],
    )
