# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/silicon/silicon.md: data.silicon, and the blocks of synth/data/points.csv."""
import csv

from data import data
from formats import change, fixed, group, listing, percent, table, times
from pages.silicon import memories
from sources import ROOT

MEASURED = ["silicon/*", "memories/*"]
UNITS = ("DOPU", "PU", "SU", "RU")
ROWS = (*UNITS, "Other", "Buffers", "Total")
PAPER = {"DOPU": 0.001, "PU": 1.695, "SU": 0.065, "RU": 0.472, "Buffers": 1.038, "Total": 3.283}  # mm2, Table 2
NAND2 = 0.49  # um2 in 28 nm, mid


def ranged(value, digits=3, factor=1):
    """mid (low to high)"""
    mid, low, high = (fixed(factor * value[end], digits) for end in ("mid", "low", "high"))
    return f"{mid} ({low} to {high})"


def either(value, form, *digits):
    return "" if value is None else form(value, *digits)


def design(scene, name):
    return data.silicon[f"{scene}_{name}"].designs[0]


def row(name, unit, scene="own"):
    """What a design point's unit takes of silicon."""
    return next(one for one in design(scene, name).rows if one.name == unit)


def area(name, unit):
    return row(name, unit).area_mm2.mid


def longest(name):
    """The longest path of the whole machine, ps."""
    return fixed(row(name, "Total").path_ps.mid, 0)


def beside(name):
    """A design point beside Table 2."""
    return listing(
        "unit",
        [(unit, row(name, unit)) for unit in ROWS],
        ("units", lambda one: either(one["count"] or None, group)),
        ("kNAND2", lambda one: either(one.kilo_nand2 or None, group)),
        ("KB", lambda one: either(one.kb or None, group)),
        ("mm2 in 28 nm", lambda one: ranged(one.area_mm2)),
        ("longest path, ps", lambda one: ranged(one.path_ps, 0) if one.path_ps.mid else ""),
        ("paper, mm2", lambda one: either(PAPER.get(one.name), fixed, 3)),
    )


def blocks(*names, of="default"):
    """NAND2 of all instances of these blocks, each with what it holds of rtl/lib."""
    with open(ROOT / "synth/data/points.csv", newline="") as file:
        lines = csv.DictReader(line for line in file if not line.startswith("#"))
        found = [row for row in lines if row["configuration"] == of and row["block"] in names]
    if {row["block"] for row in found} != set(names):
        raise KeyError(f"synth/data/points.csv: {of} lacks one of {', '.join(names)}")
    return sum(int(row["nand2"]) for row in found)


def kilo(*names, each=1, of="default"):
    return f"{blocks(*names, of=of) / each / 1e3:.0f} k"


def own_kilo(unit):
    """kNAND2 of one instance of `dop`."""
    return f"{row('dop', unit).kilo_nand2 / row('dop', unit)['count']:.0f} k"


def paper_kilo(unit, count=4):
    """The paper's area as kNAND2 of one instance."""
    return f"{PAPER[unit] * 1e3 / NAND2 / count:.0f} k"


def against(unit, name="dop"):
    """How much larger than the paper's: +57 %."""
    return change(area(name, unit) / PAPER[unit] - 1, 0)


def over(unit):
    return times(area("dop", unit) / PAPER[unit], 0)


def difference(to, unit, frm="dop"):
    return f"{area(to, unit) - area(frm, unit):+.2f}"


def by_unit():
    """mm2 of the paper's chip and of three design points, unit by unit."""
    cells = [[f"`{name}`", *[fixed(area(name, unit), 3) for unit in ROWS]] for name in ("fast", "exact", "dop")]
    return table(["mm2, mid", *ROWS], [["paper", *[either(PAPER.get(unit), fixed, 3) for unit in ROWS]], *cells])


def sky(unit, figure):
    """What the other library says of `dop`, over ours."""
    other = next(one for one in data.silicon.dop_sky130.designs[0].rows if one.name == unit)
    return figure(other) / figure(row("dop", unit))


def libraries():
    """`dop` in gates of two libraries: osu018 over sky130hd."""
    return listing(
        "unit",
        [(unit, unit) for unit in (*UNITS, "Total")],
        ("kNAND2: osu018, 180 nm", lambda unit: row("dop", unit).kilo_nand2, group),
        ("sky130hd over it", lambda unit: sky(unit, lambda one: one.kilo_nand2), times),
        ("longest path, ps: osu018", lambda unit: row("dop", unit).path_ps.mid, fixed, 0),
        ("sky130hd over it", lambda unit: sky(unit, lambda one: one.path_ps.mid), times),
    )


def stored_alphas():
    """The alpha stores' share of all bits in SRAMs."""
    return percent(memories.by_purpose("dop")["alphas"] / memories.total("dop"))


def buffers_more():
    found = row("dop", "Buffers")
    return f"{found.area_mm2.mid - PAPER['Buffers']:.1f} mm2", f"{found.kb - 428:.0f} KB"
