# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/silicon/energy.md."""
from formats import fixed, group, listing, percent, span, table, times
from measurements import CHARTED
from pages.silicon.silicon import design, either, ranged

MEASURED = ["silicon/*"]
ROWS = ("DOPU", "PU", "SU", "RU", "Other", "Buffers", "Total", "DRAM")
PAPER = {"DOPU": 0.004, "PU": 0.466, "SU": 0.068, "RU": 0.171, "Buffers": 0.236, "Total": 0.948}  # W, Table 2


def row(scene, name, unit):
    return next(one for one in design(scene, name).energy if one.name == unit)


def units(scene, name):
    """What each unit takes for one frame."""
    return listing(
        f"`{name}`",
        [(unit, row(scene, name, unit)) for unit in ROWS],
        ("awake", lambda one: either(one.awake or None, percent)),
        ("uJ of a frame", lambda one: ranged(one.frame_j, 0, 1e6)),
        ("clocks", lambda one: either(one.clocks_j / one.frame_j.mid or None, percent)),
        ("split-half error", lambda one: either(one.halves_differ or None, percent, 1)),
        ("leakage, mW", lambda one: ranged(one.leakage_w, 1, 1e3)),
        (f"W at {design(scene, name).fps:.0f} frames/s", lambda one: ranged(one.watts_full)),
        ("paper, W", lambda one: either(PAPER.get(one.name), fixed, 3)),
    )


def uj(scene, name, unit):
    return 1e6 * row(scene, name, unit).frame_j.mid


def joules(scene):
    """uJ of a frame by unit at mid, without leakage."""
    rows = [
        [f"`{name}`", *[group(uj(scene, name, unit)) for unit in ROWS]]
        + [percent(row(scene, name, unit).awake) for unit in ("PU", "RU")]
        for name in ("fast", "exact", "dop", "baseline")
    ]
    units = ["chip" if unit == "Total" else unit for unit in ROWS]
    return table([f"uJ, {scene}", *units, "PUs awake", "RUs awake"], rows)


def gated():
    """Which flip-flops of `fast` have a gate, and what their clocks take."""
    return listing(
        "`fast`",
        [(scene, row(scene, "fast", "Total")) for scene in CHARTED],
        ("flip-flops", "flipflops", group),
        ("behind a gate", lambda one: one.gated / one.flipflops, percent, 1),
        ("enable not seen", lambda one: one.unseen / one.flipflops, percent, 2),
        ("edges that pass", lambda one: (one.clocks_j - one.ungated_j - one.gates_j) / one.open_j, percent, 1),
        ("uJ of clocks", lambda one: 1e6 * one.clocks_j, group),
        ("without a gate", lambda one: 1e6 * one.ungated_j, group),
        ("the gates", lambda one: 1e6 * one.gates_j, group),
    )


def dop(figure, unit):
    """Of the paper's machine, on both scenes."""
    return [figure(row(scene, "dop", unit)) for scene in CHARTED]


def watts(one):
    return one.watts_full.mid


def of_paper(unit, digits=1):
    """The unit's power at full speed over the paper's."""
    return span(times, (one / PAPER[unit] for one in dop(watts, unit)), digits)


def awake(unit):
    return span(percent, dop(lambda one: one.awake, unit))


def clocks(unit):
    return span(percent, dop(lambda one: one.clocks_j / one.frame_j.mid, unit))


def leaks(unit):
    """Leakage as a share of the unit's power at full speed."""
    return span(percent, dop(lambda one: one.leakage_w.mid / watts(one), unit))


def dram():
    """Of what the chip takes."""
    return span(times, (a / b for a, b in zip(dop(watts, "DRAM"), dop(watts, "Total"))), 1)
