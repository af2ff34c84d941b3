# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/units/top.md."""
from data import data
from formats import percent, table
from measurements import CHARTED

MEASURED = ["views/*"]


def sequences():
    """A row for each scene: cycles of a frame and the largest gap in front of one, queued and alone."""
    rows = []
    for scene in CHARTED:
        found, cells = data["views"][scene], []
        for run in ("queued", "alone"):
            cycles, gap = found[f"cycles_{run}"], found[f"gap_{run}"]
            cells += [cycles, gap, percent(gap / cycles, 2)]
        rows.append([f"{scene}, {found.frames} views"] + cells)
    return table(["scene", "queued: cycles of a frame", "largest gap", "", "alone: cycles", "largest gap", ""], rows)
