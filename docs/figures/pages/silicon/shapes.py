# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/silicon/shapes.md."""
from data import data
from formats import change, fixed, percent, table

MEASURED = ["shapes/*"]


def told(row):
    """mm2; ~ beyond what was synthesised."""
    return ("~" if row.extrapolated_area else "") + fixed(row.mm2, 2)


def name(row):
    return row.shape if row.shape == "base" else f"`{row.shape}`"


def base(scene):
    return data.shapes[scene].shapes[0]


def best(scene):
    (row,) = [row for row in data.shapes[scene].shapes if row.shape == data.shapes[scene].best]
    return row


def best_change(scene, key):
    return change(best(scene)[key] / base(scene)[key] - 1)


def densest(scene):
    return max(data.shapes[scene].shapes, key=lambda row: row.fps_per_mm2)


def alone(scene):
    """One entry changed: what it does to time and area."""
    rows = [
        [
            name(row),
            row.cycles,
            change(row.us / base(scene).us - 1, 2),
            told(row),
            change(row.mm2 / base(scene).mm2 - 1),
            fixed(row.fps_per_mm2, 1),
            fixed(row.frames_per_joule, 0),
        ]
        for row in data.shapes[scene].shapes
        if row.step != "together"
    ]
    return table(["shape", "cycles", "time", "mm2", "area", "frames/s/mm2", "frames/J"], rows)


def front(scene):
    """What no other shape beats in both time and area."""
    rows = [
        [row.front, name(row), row.cycles, fixed(row.us, 1), told(row), fixed(row.fps_per_mm2, 1)]
        for row in sorted(data.shapes[scene].shapes, key=lambda row: row.front or 0)
        if row.front
    ]
    return table(["place", "shape", "cycles", "us", "mm2", "frames/s/mm2"], rows)


def one(scene, shape):
    (row,) = [row for row in data.shapes[scene].shapes if row.shape == shape]
    return row


def per_area(scene, shape):
    """Frames/s/mm2 of a shape over the base's."""
    return percent(one(scene, shape).fps_per_mm2 / base(scene).fps_per_mm2, 0)
