# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/silicon/fpga.md: data.fpga.POINT_FAMILY_UNITS."""
import sys

from data import data
from formats import fixed, group, percent, table
from sources import ROOT
from tree import Figures

sys.path.insert(0, str(ROOT / "synth/fpga"))
import fpga  # noqa: E402

MEASURED = ["fpga/*"]
NAMES = {"dopu": "DOPU", "pu": "PU", "su": "SU", "ru": "RU", "buf": "alpha stores", "list": "lists", "bus": "bus"}
HEADER = ["LUT", "of these distributed RAM", "flip-flops", "multipliers", "block RAM, 36 Kb"]


def cells(row):
    found = [group(row[kind]) for kind in ("luts", "distributed", "flipflops", "multipliers")]
    return found + [fixed(row.blocks / 2, 1)]


def measured(family):
    """(design point, units, rows) of what there is, small machines first."""
    found = []
    for name, entries in data.fpga.items():
        point, of, units = name.rsplit("_", 2)
        if of == family:
            found.append((point, int(units), entries[0].rows))
    return sorted(found, key=lambda one: one[:2])


def units(family):
    """Of each machine: every unit, all instances together."""
    lines = []
    for point, count, rows in measured(family):
        for unit, row in rows.items():
            name = NAMES.get(unit, unit) + (f", {row['count']} of them" if row["count"] > 1 else "")
            lines.append([f"`{point}`, `units={count}`", name, *cells(row)])
    return table(["machine", "unit", *HEADER], lines)


def parts():
    """The whole machines beside what two parts have."""
    lines = []
    for name, part in fpga.PARTS.items():
        lines.append([f"{name} has", *cells(Figures(part | {"distributed": 0})), "", ""])
    for point, count, rows in measured("xcup"):
        shares = [percent(share) for share in fpga.fits(rows.total).values()]
        lines.append([f"`{point}`, `units={count}`", *cells(rows.total), *shares])
    return table(["", *HEADER, *[f"of what is scarcest in a {name}" for name in fpga.PARTS]], lines)


def largest(part):
    """The measured machine of most units that the part holds."""
    held = [(count, point) for point, count, rows in measured("xcup") if fpga.fits(rows.total)[part] <= 1]
    if not held:
        return "none of those measured"
    count, point = max(held)
    return f"`{point}` with {count} unit" + ("s" if count > 1 else "")
