# SPDX-License-Identifier: Apache-2.0
"""Figures of docs/architect.md."""
from data import data
from formats import block
from measurements import FOUR  # noqa: F401  (the page uses them)
from pages.frames import cycles, fast_mean, largest_bound, over, roofline  # noqa: F401

MEASURED = ["model/*", "what_if/own", "work/*"]


def what_if():
    """What the command of the page prints, without scene and files."""
    return block(line for line in data.what_if.own.lines[2:] if line)
