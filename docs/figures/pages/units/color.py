# SPDX-License-Identifier: Apache-2.0
"""Figures of docs/units/color.md."""
from formats import fixed
from pages.numerics.numbers import two  # noqa: F401  (the page uses it)
from pages.silicon.silicon import blocks

MEASURED = ["prints/*/rsqrt", "prints/*/pu_color*"]


def area(*modules):
    """kNAND2 of these modules in one of the four PUs, with what each holds of rtl/lib."""
    return fixed(blocks(*modules) / 4e3, 1)
