# SPDX-License-Identifier: Apache-2.0
"""The table of docs/units/su.md."""
from data import data
from formats import fixed, group, table

MEASURED = ["prints/*/su"]


def pace():
    """Cycles for each key."""
    rows = [
        [group(line["keys"]), *[fixed(line[name], 2) for name in ("random", "narrow", "clustered")]]
        for line in data.prints.su.su.lines
    ]
    return table(
        ["keys per layer", "cycles per key, random depths", "64 neighbouring depths", "exponentially clustered"], rows
    )
