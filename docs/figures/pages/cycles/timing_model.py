# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/cycles/timing_model.md."""
from data import data
from formats import fixed, group, table
from measurements import FOUR, points_of
from pages.cycles import speed
from pages.cycles import effects

MEASURED = ["ladder/*", "model/*", *speed.MEASURED, *effects.MEASURED]


def signed(share):
    return f"{100 * share:+.3f} %"


def agreement():
    """Cycles of the RTL and of the model, scene by scene."""
    rows = []
    for scene in FOUR:
        for point in points_of(data.ladder[scene], data.model[scene]):
            rtl, model = data.ladder[scene][point].cycles, data.model[scene][point]
            rows.append(
                [scene, f"`{point}`", rtl, model.cycles, signed(model.cycles / rtl - 1), fixed(model.seconds, 2)]
            )
    return table(["scene", "design point", "RTL cycles", "model cycles", "error", "model s"], rows)


def check():
    """Our own scene, the RTL beside the model: frame, windows and bytes of the streams; the speed of both."""
    rows = [
        [
            f"`{point}`",
            row.rtl_cycles,
            row.cycles,
            row.differences,
            group(row.rtl_khz),
            fixed(row.seconds, 2),
            group(row.speed_ratio),
        ]
        for point, row in data.model.check.items()
    ]
    return table(["design point", "RTL cycles", "model cycles", "differences", "RTL kHz", "model s", "speed"], rows)


def speeds():
    """The least and the largest ratio of model and RTL."""
    ratios = [row.speed_ratio for row in data.model.check.values()]
    return f"{min(ratios):.0f} to {max(ratios):.0f}"
