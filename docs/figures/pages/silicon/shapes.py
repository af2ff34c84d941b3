# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/silicon/shapes.md."""
from data import data
from formats import change, fixed, listing, percent

MEASURED = ["shapes/*"]
FOUND = data.shapes.own
BASE = FOUND.shapes[0]
BEST = next(row for row in FOUND.shapes if row.shape == FOUND.best)
DENSEST = max(FOUND.shapes, key=lambda row: row.fps_per_mm2)


def name(row):
    return row.shape if row.shape == "base" else f"`{row.shape}`"


def shapes(rows):
    """What shapes take; ~ before an area beyond what was synthesised."""
    return listing(
        "shape",
        [(name(row), row) for row in rows],
        ("cycles", "cycles"),
        ("time", lambda row: row.us / BASE.us - 1, change),
        ("mm2", lambda row: ("~" if row.extrapolated_area else "") + fixed(row.mm2.mid, 2)),
        ("frames/s/mm2", "fps_per_mm2", fixed, 1),
        ("frames/J", "frames_per_joule_with_dram", fixed, 0),
    )


def alone():
    """One entry changed."""
    return shapes(row for row in FOUND.shapes if row.step != "together")


def front():
    """What no other shape beats in both time and area."""
    return shapes(sorted((row for row in FOUND.shapes if row.front), key=lambda row: row.front))


def area(row):
    return change(row.mm2.mid / BASE.mm2.mid - 1)


def per_area(row):
    """Frames/s/mm2 of a shape over the base's."""
    return percent(row.fps_per_mm2 / BASE.fps_per_mm2)
