# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/cycles/timing_model.md."""
from data import data
from formats import fixed, group, table
from measurements import FOUR
from pages.cycles import speed
from pages.cycles import effects

MEASURED = ["model/*", *speed.MEASURED, *effects.MEASURED]


def cycles():
    """Cycles of the model, scene by scene, and its seconds."""
    rows = [
        [scene, f"`{point}`", row.cycles, fixed(row.seconds, 2)]
        for scene in FOUR
        for point, row in data.model[scene].items()
    ]
    return table(["scene", "design point", "cycles", "model s"], rows)


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
