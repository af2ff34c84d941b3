# SPDX-License-Identifier: Apache-2.0
"""Figures of docs/units/top.md."""
from data import data
from formats import group, percent

MEASURED = ["rtl/views"]


def gap(run):
    """The largest gap in front of a frame, and its share of a frame, `queued` or `alone`."""
    found = data.rtl["views"]
    rows = found["views"]
    largest, cycles = max(row[f"gap_{run}"] for row in rows[1:]), found[f"cycles_{run}"] / len(rows)
    return f"{group(largest)} cycles, {percent(largest / cycles, 2)} of a frame"
