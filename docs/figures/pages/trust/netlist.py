# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/trust/trust.md."""
from data import data
from formats import fixed, group, table

MEASURED = ["netlist/*"]
WINDOWS = {"own_8_6": "our own scene 8,6", "own_15_11": "our own scene 15,11", "terrace_9_6": "terrace 9,6 (view 0)"}


def slower():
    """Seconds of gates over those of RTL, all windows."""
    ratios = [data.netlist[name].gates.rtl_s / data.netlist[name].rtl.rtl_s for name in WINDOWS]
    return f"{group(min(ratios))} to {group(max(ratios))}"


def windows():
    """The same window in gates and in RTL."""
    rows = []
    for name, title in WINDOWS.items():
        gates, rtl = data.netlist[name].gates, data.netlist[name].rtl
        rows.append(
            [
                title,
                gates.cycles,
                rtl.cycles,
                gates.beats_compared,
                gates.mismatches,
                fixed(rtl.rtl_s, 1),
                fixed(gates.rtl_s, 0),
            ]
        )
    return table(["window", "cycles, gates", "cycles, RTL", "beats compared", "mismatches", "RTL, s", "gates, s"], rows)
