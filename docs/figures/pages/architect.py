# SPDX-License-Identifier: Apache-2.0
"""Figures of docs/architect.md."""
from measurements import FOUR  # noqa: F401  (the page uses them)
from pages.frames import cycles, fast_mean, largest_bound, over, roofline  # noqa: F401

MEASURED = ["model/*", "work/*"]
