# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/cycles/memory_timing.md."""
from data import data
from formats import table

MEASURED = ["dram/*"]
SHOWN = ("lpddr5-6400x4", "lpddr4-3200", "ddr4-3200x2")
STREAMS = ("stream_rd64", "stream_rdwr64", "two_streams_1k")
NAMES = {"ramulator2": "Ramulator 2", "dramsim3": "DRAMsim3"}


def worth(name):
    """Bandwidth by mapping, or step by step from the preset to the machine's memory."""
    found = data.dram.worth[name]
    return table(found.header, [row for row in found.rows if row[0] in SHOWN])


def differences(source, streams):
    """Of the bandwidth, in percent, over the runs of one simulator on the streams or on the random traces."""
    return [
        float(row[7].removesuffix(" %"))
        for row in data.dram.check.runs.rows
        if row[0] == source and (row[2] in STREAMS) == streams
    ]


def agreement():
    """The largest difference, by simulator and kind of trace."""
    rows = []
    for source, name in NAMES.items():
        both = [differences(source, streams) for streams in (True, False)]
        rows.append([name, sum(map(len, both)), *[f"{max(found, key=abs):+.2f} %" for found in both]])
    return table(["reference", "runs", "largest difference, streams", "random"], rows)


def second(source):
    """The largest difference but one on the streams."""
    return f"{sorted(differences(source, True), key=abs)[-2]:+.2f} %"
