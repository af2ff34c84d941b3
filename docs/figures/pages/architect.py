# SPDX-License-Identifier: Apache-2.0
"""Figures of docs/architect.md."""
from pages.cycles.ladder import scenes  # noqa: F401  (the page uses them)
from pages.frames import cycles, largest_bound, roofline  # noqa: F401

MEASURED = ["model/*", "work/*"]
