# SPDX-License-Identifier: Apache-2.0
"""The table of docs/integration.md."""
from data import data
from formats import change, table
from measurements import BUSES, BUSY
from pages.frames import cycles

MEASURED = ["bus/*", "model/*"]


def bus():
    """A row for each width: cycles of each scene, and what they are beside those of the core's own port."""
    port, *narrow = BUSES
    rows = []
    for bits in (port, 512, *narrow):
        cells = []
        for scene in BUSY:
            own = data.bus[f"{scene}_{port}"].designs[0].cycles
            found = cycles(scene, "fast") if bits == 512 else data.bus[f"{scene}_{bits}"].designs[0].cycles
            cells += [found, change(found / own - 1) if bits else "-"]
        rows.append([f"{bits} bits" if bits else "core's own port", *cells])
    return table(["bus", *[cell for scene in BUSY for cell in (scene, "")]], rows)
