# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/silicon/energy.md."""
from itertools import product

from data import data
from formats import fixed, group, percent, span, table, times
from measurements import CHARTED, points_of
from pages.cycles.cycles import TITLES
from pages.silicon.silicon import either, ranged

MEASURED = ["energy/*"]
ROWS = ("DOPU", "PU", "SU", "RU", "Other", "Buffers", "Total", "DRAM")
PAPER = {"DOPU": 0.004, "PU": 0.466, "SU": 0.068, "RU": 0.171, "Buffers": 0.236, "Total": 0.948}  # W, Table 2


def units(scene, point):
    """What each unit takes for one frame."""
    rows = []
    for name in ROWS:
        row = data.energy[scene][point].rows[name]
        rows.append(
            [
                name,
                either(row.awake, percent),
                ranged(row.uj, 0),
                either(row.clocks, percent),
                either(row.halves, percent, 1),
                ranged(row.leakage_mw, 1),
                ranged(row.mw_60, 0),
                ranged(row.w_full, 3),
                either(PAPER.get(name), fixed, 3),
            ]
        )
    full = f"W at {data.energy[scene][point].fps:.0f} frames/s"
    return table(
        [
            "unit",
            "awake",
            "uJ of a frame",
            "clocks",
            "split-half error",
            "leakage, mW",
            "mW at 60 frames/s",
            full,
            "paper, W",
        ],
        rows,
    )


def joules(scene):
    """uJ of a frame by unit at mid, without leakage."""
    rows = []
    for name in points_of(data.energy[scene]):
        row = data.energy[scene][name]
        cells = [group(row.rows[unit].uj.mid) for unit in ROWS]
        awake = [percent(row.rows[unit].awake) for unit in ("PU", "RU")]
        rows.append([f"`{name}`", *cells, *awake])
    return table(
        [
            "design point",
            *["chip" if unit == "Total" else unit for unit in ROWS],
            "PUs awake",
            "RUs awake",
        ],
        rows,
    )


def gated():
    """Which flip-flops of two machines have a gate, and what their clocks take."""
    rows = []
    for scene, name in product(CHARTED, ("dpc", "fast")):
        point = data.energy[scene][name]
        total = point.rows.Total
        clock = total.clock_uj
        rows.append(
            [
                f"`{name}`, {TITLES[scene]}",
                group(total.flipflops),
                percent(total.gated / total.flipflops, 1),
                percent(total.unseen / total.flipflops, 2),
                percent((clock.clocks - clock.ungated - clock.gates) / clock.open, 1),
                group(clock.clocks),
                group(clock.ungated),
                group(clock.gates),
                group(total.uj.mid),
                group(point.frames_per_joule),
                group(point.frames_per_joule_with_dram),
            ]
        )
    return table(
        [
            "machine and scene",
            "flip-flops",
            "behind a gate",
            "enable not seen",
            "edges that pass",
            "uJ of clocks",
            "without a gate",
            "the gates",
            "uJ of the chip",
            "frames/J",
            "with DRAM",
        ],
        rows,
    )


def gated_modules(name):
    """Where the clocks of a machine go."""
    rows = [
        [
            one.row,
            f"`{one.module}`",
            group(one.flipflops),
            group(one.gated),
            fixed(one.ungated_uj, 1),
            fixed(one.gated_uj, 1),
        ]
        for one in data.energy.own[name].modules
    ]
    return table(["unit", "module", "flip-flops", "behind a gate", "uJ without a gate", "uJ behind gates"], rows)


def uj(scene, point, unit):
    return data.energy[scene][point].rows[unit].uj.mid


def watts(scene, unit):
    return data.energy[scene].dop.rows[unit].w_full.mid


def of_paper(unit, digits=1):
    """The unit's power at full speed over the paper's, both scenes."""
    return span(times, (watts(scene, unit) / PAPER[unit] for scene in CHARTED), digits)


def awake(unit):
    return span(percent, (data.energy[scene].dop.rows[unit].awake for scene in CHARTED))


def clocks(unit):
    return span(percent, (data.energy[scene].dop.rows[unit].clocks for scene in CHARTED))


def leaks(unit):
    """Leakage as a share of the unit's power at full speed, both scenes."""
    rows = [data.energy[scene].dop.rows[unit] for scene in CHARTED]
    return span(percent, (row.leakage_mw.mid / 1e3 / row.w_full.mid for row in rows))


def sky(scene):
    """How much more energy the other library says."""
    more = data.energy[f"{scene}_sky130"].dop.rows.Total.uj.mid / uj(scene, "dop", "Total") - 1
    return percent(more)
