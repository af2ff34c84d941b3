# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/integration.md."""
from data import data
from formats import change, table
from measurements import BUSES, FOUR

MEASURED = ["bus/*"]


def bus():
    """A row for each width: cycles of each scene, and what they are beside those of the core's own port."""
    rows = []
    for bits in BUSES:
        cells = []
        for scene in FOUR:
            cycles = [data.bus[scene][f"bits{width}"].cycles for width in (bits, 0)]
            cells += [cycles[0], change(cycles[0] / cycles[1] - 1) if bits else "-"]
        rows.append([f"{bits} bits" if bits else "core's own port"] + cells)
    return table(["bus"] + [cell for scene in FOUR for cell in (scene, "")], rows)
