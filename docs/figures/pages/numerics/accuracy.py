# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/numerics/accuracy.md."""
from data import data
from formats import change, fixed, listing

MEASURED = ["accuracy/*"]
FOUND = data.accuracy.own


def base():
    """The base of the sweep."""
    return listing(
        "`exact`",
        [("our own scene", FOUND.base)],
        ("numeric dB", "numeric.psnr_db", fixed, 2),
        ("order dB", "order.psnr_db", fixed, 2),
        ("total dB", "total.psnr_db", fixed, 2),
        ("SSIM", "total.ssim", fixed, 5),
        ("cycles", "cycles"),
        ("mm2", "silicon.mm2.mid", fixed, 2),
    )


def knobs():
    """Each knob alone: decibels and cycles at its values."""

    def by_value(form, figure, *rest):
        return lambda one: "; ".join(
            f"{row.label}: {form(figure(row), *rest)}" for row in one["values"] if "failure" not in row
        )

    return listing(
        "knob",
        [(f"`{one.name}`", one) for one in FOUND.knobs],
        ("what it is", "what"),
        ("total dB", by_value(fixed, lambda row: row.total.psnr_db, 1)),
        ("cycles over the base", by_value(change, lambda row: row.cycles / FOUND.base.cycles - 1)),
    )


def value(knob, label):
    values = next(one for one in FOUND.knobs if one.name == knob)["values"]
    return next(row for row in values if row.label == label)


def loses(knob, label):
    """Numeric decibels below the base."""
    return f"{FOUND.base.numeric.psnr_db - value(knob, label).numeric.psnr_db:.1f} dB"


def gains(knob, label):
    """Numeric decibels above the base."""
    return f"{value(knob, label).numeric.psnr_db - FOUND.base.numeric.psnr_db:.1f} dB"


def more(knob, label):
    """Cycles."""
    return change(value(knob, label).cycles / FOUND.base.cycles - 1)


def left_out(what):
    """The largest error of a model of synthesised points, per cent."""
    return f"{data.accuracy.leave_one_out[what]:.1f} %"
