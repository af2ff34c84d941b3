# SPDX-License-Identifier: Apache-2.0
"""Figures of docs/units/ru.md."""
from pages.numerics.numbers import small  # noqa: F401  (the page uses it)

MEASURED = ["prints/all"]
