# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/numerics/accuracy.md."""
from data import data
from formats import change, fixed, group, percent, table

MEASURED = ["accuracy/*", "accuracy_rtl/*", "fine/*"]


def told(value):
    """Area and energy are not known of data that are older than their interpolation."""
    return value or ""


def base(scene):
    """The base of a sweep: the design point exact."""
    row = data.accuracy[scene].base
    return table(
        ["numeric dB", "order dB", "total dB", "SSIM", "flips", "cycles", "MB", "buffers KB", "mm2", "mJ"],
        [
            [
                fixed(row.numeric_db, 2),
                fixed(row.order_db, 2),
                fixed(row.total_db, 2),
                fixed(row.ssim, 5),
                percent(row.flips, 4),
                row.cycles,
                fixed(row.mb, 1),
                fixed(row.buffer_kb, 1),
                told(row.mm2),
                told(row.mj),
            ]
        ],
    )


def knobs(scene):
    """What the last decibel of each knob costs, as the command says it."""
    rows = [[f"`{name}`", knob.what, knob.says] for name, knob in data.accuracy[scene].knobs.items()]
    return table(["knob", "what it is", "what its last decibel costs"], rows)


def front(scene, over="cycles"):
    """The points that no other beats in both accuracy and cost."""
    rows = [
        [
            fixed(row.numeric_db, 2),
            fixed(row.order_db, 2),
            row.cycles,
            fixed(row.mb, 1),
            fixed(row.buffer_kb, 1),
            told(row.mm2),
            told(row.mj),
            f"`{row.configuration}`",
        ]
        for row in data.accuracy[scene].front[over]
    ]
    return table(
        ["numeric dB", "order dB", "cycles", "MB", "buffers KB", "mm2", "mJ", "configuration over `exact`"], rows
    )


def in_rtl(scene):
    """The cheapest point at each level, run in RTL."""
    rows = []
    for row in data.accuracy_rtl[scene].levels:
        level = f"{row.level_db} dB" + ("" if row.reached else ", not reached: the most accurate")
        rows.append(
            [
                level,
                fixed(row.numeric_db, 2),
                row.model_cycles,
                row.rtl_cycles,
                row.beats,
                row.mismatches,
                f"`{row.configuration}`",
            ]
        )
    return table(
        [
            "level",
            "numeric dB",
            "cycles, timing model",
            "cycles, RTL",
            "beats compared",
            "mismatches",
            "configuration over `exact`",
        ],
        rows,
    )


def value(scene, knob, label):
    return data.accuracy[scene].knobs[knob]["values"][label]


def loses(scene, knob, label):
    """Numeric decibels below the base."""
    return f"{data.accuracy[scene].base.numeric_db - value(scene, knob, label).numeric_db:.2f} dB"


def more(scene, knob, label, key="cycles"):
    return change(value(scene, knob, label)[key] / data.accuracy[scene].base[key] - 1)


def flips(scene, knob, label):
    return percent(value(scene, knob, label).flips, 2)


def best(scene):
    """The most accurate point of the front over cycles."""
    return f"{max(row.numeric_db for row in data.accuracy[scene].front.cycles):.1f} dB"


def one_more(knob, coarse, fine, key="cycles"):
    """Of our own scene: from one value of a knob to a finer one."""
    at = data.accuracy.own.knobs[knob]["values"]
    return change(at[fine][key] / at[coarse][key] - 1)


def points():
    """Synthesised points: errors of the sum of all gates."""
    rows = [
        [
            f"`{row.configuration}`",
            change(row.fitted, 2),
            change(row.leave_one_out, 2),
            "yes" if row.extrapolated else "",
        ]
        for row in data.accuracy.leave_one_out.points
    ]
    return table(["configuration", "fitted", "leave-one-out error", "extrapolated"], rows)


def frames():
    """Measured frames: errors of the chip's energy without leakage."""
    rows = [
        [row.scene, f"`{row.configuration}`", row.uj, change(row.leave_one_out), "yes" if row.alone else ""]
        for row in data.accuracy.leave_one_out.frames
    ]
    return table(["scene", "configuration", "uJ", "leave-one-out error", "alone of its design point"], rows)


def clock():
    """Synthesised points: errors of the longest path."""
    rows = [
        [
            f"`{row.configuration}`",
            fixed(row.fo4, 1),
            change(row.fitted, 2),
            change(row.leave_one_out, 2),
            "yes" if row.extrapolated else "",
        ]
        for row in data.accuracy.leave_one_out.get("paths", [])
    ]
    rows = rows or [["none has been measured yet", "", "", "", ""]]
    return table(["configuration", "FO4", "fitted", "leave-one-out error", "extrapolated"], rows)


def most(rows, key="leave_one_out"):
    return percent(max(abs(row[key]) for row in rows), 1)


def of_points(extrapolated):
    """The largest leave-one-out error of the points that lie among the others, or beyond them."""
    return most(row for row in data.accuracy.leave_one_out.points if row.extrapolated == extrapolated)


def of_frames():
    return most(data.accuracy.leave_one_out.frames)


def alpha():
    """alpha_w on the design point dop."""
    known = data.accuracy.own_dop.knobs.alpha_w["values"]
    rows = {label: known[label] for label in ("7", "8", "9", "10")}
    return table(
        ["`alpha_w`, our own scene, `dop`", *rows],
        [
            ["numeric dB", *[fixed(row.numeric_db, 2) for row in rows.values()]],
            ["cycles", *[row.cycles for row in rows.values()]],
            ["MB", *[fixed(row.mb, 1) for row in rows.values()]],
            ["buffers, KB", *[group(row.buffer_kb) for row in rows.values()]],
        ],
    )


def alpha_cycles(label):
    return change(value("own_dop", "alpha_w", label).cycles / data.accuracy.own_dop.base.cycles - 1)


def fine():
    """The design point exact and its finer numbers, in RTL."""
    rows = []
    for scene, name in (("own", "our own"), ("terrace", "terrace"), ("statue", "statue"), ("flowers", "flowers")):
        plain, better = data.fine[scene].plain, data.fine[scene].fine
        rows.append(
            [
                name,
                fixed(plain.psnr_numeric_db, 2),
                fixed(better.psnr_numeric_db, 2),
                fixed(plain.psnr_order_db, 2),
                fixed(better.psnr_order_db, 2),
                plain.cycles,
                better.cycles,
                better.beats_compared,
                better.mismatches,
            ]
        )
    return table(
        [
            "scene",
            "numeric dB: `exact`",
            "fine",
            "order dB: `exact`",
            "fine",
            "cycles: `exact`",
            "fine",
            "beats compared, fine",
            "mismatches",
        ],
        rows,
    )
