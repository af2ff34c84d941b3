# SPDX-License-Identifier: Apache-2.0
"""The table of docs/trust/proofs.md."""
from data import data
from formats import fixed, table
from sources import ROOT

MEASURED = ["proofs/all"]


def in_table():
    """How many proofs there are."""
    return sum(line.startswith("proof ") for line in (ROOT / "synth/prove/table.sh").read_text().splitlines())


def total(key):
    return sum(row[key] for row in data.proofs.all.values())


def times():
    """Two proofs in a row, to spare length."""
    cells = [
        [f"`{name}`", row.sets, fixed(row.seconds, 1), row.mutants, fixed(row.seconds_of_mutants, 1)]
        for name, row in data.proofs.all.items()
    ]
    half = (len(cells) + 1) // 2
    return table(
        ["proof", "sizes", "s", "mutants", "s"] * 2,
        [left + right for left, right in zip(cells[:half], cells[half:] + [[""] * 5])],
    )
