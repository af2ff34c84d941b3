# SPDX-License-Identifier: Apache-2.0
"""Figures of docs/units/rows.md."""
from data import data
from formats import fixed

MEASURED = ["prints/*/pu_rows", "prints/*/exp2", "memories/dop"]
(rows,) = data.prints.pu.pu_rows.lines
(exp2,) = data.prints.lib.exp2.lines


def store_kb(place):
    """KB of an SRAM of one alpha store of `dop`."""
    (row,) = [row for row in data.memories.dop if place in row.place]
    return fixed(row.width * row.depth / 8192, 1)
