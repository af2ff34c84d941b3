# SPDX-License-Identifier: Apache-2.0
"""The table of docs/units/su.md."""
from data import data
from formats import fixed, group, listing

MEASURED = ["prints/all"]


def pace():
    """Cycles for each key."""
    return listing(
        "keys per layer",
        [(group(line["keys"]), line) for line in data.prints.all.su],
        ("cycles per key, random depths", "random", fixed, 2),
        ("64 neighbouring depths", "narrow", fixed, 2),
        ("exponentially clustered", "clustered", fixed, 2),
    )
