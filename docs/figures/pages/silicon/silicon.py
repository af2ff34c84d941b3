# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/silicon/silicon.md: data.silicon, and the blocks of synth/data/points.csv."""
import csv

from data import data
from formats import change, fixed, group, percent, table, times
from pages.silicon import memories
from sources import ROOT

MEASURED = ["silicon/*", "energy/own", "memories/dop", *memories.MEASURED]
UNITS = ("DOPU", "PU", "SU", "RU")
ROWS = (*UNITS, "Other", "Buffers", "Total")
PAPER = {"DOPU": 0.001, "PU": 1.695, "SU": 0.065, "RU": 0.472, "Buffers": 1.038, "Total": 3.283}  # mm2, Table 2
NAND2 = 0.49  # um2 in 28 nm, mid


def ranged(value, digits=3, middle=True):
    """mid (low to high)"""
    if value is None or value.mid is None:
        return ""
    if value.low is None:
        return fixed(value.mid, digits)
    span = f"{fixed(value.low, digits)} to {fixed(value.high, digits)}"
    return f"{fixed(value.mid, digits)} ({span})" if middle else span


def either(value, form, *digits):
    return "" if value is None else form(value, *digits)


def beside(point):
    """A design point beside Table 2."""
    rows = []
    for name in ROWS:
        row = data.silicon[point][name]
        rows.append(
            [
                name,
                either(row["count"], group),
                either(row.kilo_nand2, group),
                either(row.kb, group),
                ranged(row.area_mm2),
                ranged(row.path_ps, 0),
                either(PAPER.get(name), fixed, 3),
            ]
        )
    return table(["unit", "units", "kNAND2", "KB", "mm2 in 28 nm", "longest path, ps", "paper, mm2"], rows)


def blocks(*names, of="default"):
    """NAND2 of all instances of these blocks, each with what it holds of rtl/lib."""
    with open(ROOT / "synth/data/points.csv", newline="") as file:
        lines = csv.DictReader(line for line in file if not line.startswith("#"))
        found = [row for row in lines if row["configuration"] == of and row["block"] in names]
    if {row["block"] for row in found} != set(names):
        raise KeyError(f"synth/data/points.csv: {of} lacks one of {', '.join(names)}")
    return sum(int(row["nand2"]) for row in found)


def kilo(*names, each=1):
    return f"{blocks(*names) / each / 1e3:.0f} k"


def flipflops(unit=None):
    with open(ROOT / "synth/data/points.csv", newline="") as file:
        lines = csv.DictReader(line for line in file if not line.startswith("#"))
        return sum(
            int(row["flipflops"]) for row in lines if row["configuration"] == "default" and unit in (None, row["unit"])
        )


def own_kilo(unit):
    """kNAND2 of one instance."""
    row = data.silicon.dop[unit]
    return f"{row.kilo_nand2 / row['count']:.0f} k"


def paper_kilo(unit, count=4):
    """The paper's area as kNAND2 of one instance."""
    return f"{PAPER[unit] * 1e3 / NAND2 / count:.0f} k"


def against(unit, point="dop"):
    """How much larger than the paper's: +57 %."""
    return change(data.silicon[point][unit].area_mm2.mid / PAPER[unit] - 1, 0)


def over(unit):
    return times(data.silicon.dop[unit].area_mm2.mid / PAPER[unit], 0)


def mid(point, unit):
    return fixed(data.silicon[point][unit].area_mm2.mid, 3)


def difference(to, unit, frm="dop"):
    return f"{data.silicon[to][unit].area_mm2.mid - data.silicon[frm][unit].area_mm2.mid:+.2f}"


def longest(*points):
    """Longest path of the whole machine at each design point."""
    return [f"{data.energy.own[point].path_ps:.0f} ps" for point in points]


def fine():
    """The fastest design point, with its own numbers and with finer ones."""
    rows = [["paper", *[either(PAPER.get(unit), fixed, 3) for unit in ROWS], "", ""]]
    named = (
        ("exact", "`exact`"),
        ("exact_fine", "`exact`, `sim/fine.cfg`"),
        ("exact_quads", "and `--set quads=1`"),
        ("fast", "`fast`"),
    )
    for point, name in named:
        row = data.silicon[point]
        rows.append(
            [
                name,
                *[mid(point, unit) for unit in ROWS],
                ranged(row.Total.area_mm2, middle=False),
                fixed(row.Total.path_ps.mid, 0),
            ]
        )
    return table(["mm2, mid", *ROWS, "Total, low to high", "longest path, ps"], rows)


def libraries():
    """The default machine in gates of two libraries."""
    osu, sky = data.silicon.dop, data.silicon.dop_sky130
    rows = []
    for name in (*UNITS, "Total"):
        a, b = osu[name], sky[name]
        rows.append(
            [
                name,
                a.kilo_nand2 and group(a.kilo_nand2),
                group(b.kilo_nand2),
                fixed(b.kilo_nand2 / a.kilo_nand2, 2),
                fixed(a.path_ps.mid, 0),
                fixed(b.path_ps.mid, 0),
                fixed(b.path_ps.mid / a.path_ps.mid, 2),
            ]
        )
    return table(
        [
            "unit",
            "kNAND2: osu018, 180 nm",
            "sky130hd, 130 nm",
            "ratio",
            "longest path, ps: osu018",
            "sky130hd",
            "ratio",
        ],
        rows,
    )


def sky(unit, key):
    a, b = data.silicon.dop[unit], data.silicon.dop_sky130[unit]
    if key == "path":
        return b.path_ps.mid / a.path_ps.mid
    return b.kilo_nand2 / a.kilo_nand2


def sky_paths():
    ratios = [sky(unit, "path") for unit in UNITS]
    return f"{min(ratios):.1f} to {max(ratios):.1f} times"


def stored_alphas():
    """The alpha stores' share of all bits in SRAMs."""
    return percent(memories.by_purpose("dop")["alphas"] / memories.total("dop"))


def buffers_more():
    row = data.silicon.dop.Buffers
    return f"{row.area_mm2.mid - PAPER['Buffers']:.1f} mm2", f"{row.kb - 428:.0f} KB"
