# SPDX-License-Identifier: Apache-2.0
"""Figures of docs/units/shared.md."""
from data import data
from formats import fixed
from pages.cycles.ladder import alphas  # noqa: F401  (the page uses it)

MEASURED = ["prints/all", "rtl/own"]


def recip():
    """Worst error by width."""
    return ", ".join(f"{fixed(line.units, 3)} units at {line.bits:.0f} bits" for line in data.prints.all.recip)
