# SPDX-License-Identifier: Apache-2.0
"""Figures of docs/numerics/stability.md."""
from data import data
from formats import percent

MEASURED = ["prints/stability"]
FOUND = data.prints.stability


def case(test):
    """The largest errors of alpha, T and colour of a pixel, each with the bound there, as cells of a table."""
    return " | ".join("{:.4f} of {:.4f}".format(*pair) for pair in FOUND.cases[test])


def fp16_off():
    return percent(FOUND.fp16_off, 1)


def popping():
    found = FOUND.popping
    against = found.dop[2] + found.exact[2]
    return (
        f"`dop` draws {found.dop[0]} pairs against their depth, `exact` {found.exact[0]}; half a degree later "
        f"{found.dop[1]} pairs (`dop`) and {found.exact[1]} (`exact`) have swapped; "
        + (f"{against} swaps do not follow depth" if against else "all swaps follow depth")
    )


def depth_bits():
    return "order error " + ", ".join(f"{value:.1f} dB at {bits} bits" for bits, value in FOUND.depth_bits.items())
