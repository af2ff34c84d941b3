# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/cycles/memory_timing.md."""
from data import data
from formats import listing, table

MEASURED = ["dram/*"]
NAMES = {"ramulator2": "Ramulator 2", "dramsim3": "DRAMsim3"}


def bandwidth(name):
    """By mapping, or step by step from the preset to the machine's memory."""
    found = data.dram.steps[name]
    return table(found.header, found.rows)


def agreement():
    """The largest difference, by simulator and kind of trace."""
    return listing(
        "reference",
        [(name, data.dram.check[source]) for source, name in NAMES.items()],
        ("runs", "runs"),
        *[(f"largest difference, {kind}", f"{kind}.0", "{:+.2f} %".format) for kind in ("streams", "random")],
    )
