# SPDX-License-Identifier: Apache-2.0
"""Figures of docs/units/ru.md."""
from data import data
from formats import change, fixed, group
from pages.numerics.numbers import small  # noqa: F401  (the page uses it)

MEASURED = ["prints/all", "rtl/own_fast", "rtl/own_raster"]


def raster():
    """Cycles of the picture in raster order, and how many more they are than those by windows."""
    windows, rows = data.rtl.own_fast.cycles, data.rtl.own_raster.cycles
    return f"{group(rows)}, {change(rows / windows - 1)}"


def pixels(entry):
    """Megabytes of pixels that a frame writes."""
    return f"{fixed(entry.memory.by_stream.raster.written / 1e6, 1)} MB"
