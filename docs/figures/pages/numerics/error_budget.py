# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/numerics/error_budget.md."""
from data import data
from formats import fixed, table
from pages.numerics.numbers import plain, two, worst  # noqa: F401  (the page uses plain and two)

MEASURED = ["budget/*", "prints/all"]


def units(name):
    """Of the covariance's error, in units of 2^-25."""
    return fixed(2 ** (worst("pu_covariance", name) + 25), 1)


def errors():
    """Percentiles over random Gaussians; FP16 loses some of them altogether."""
    rows = [
        [name, *["no number" if value is None else f"{value:.3g}" for value in found.values()]]
        for name, found in data.budget.random.items()
        if ", " in name
    ]
    return table(["powers in log2 units", "50 %", "90 %", "99 %", "99.9 %", "worst"], rows)
