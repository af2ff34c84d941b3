# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/cycles/cycles.md."""
from data import data
from formats import fixed, table, times

MEASURED = ["walks/*"]
RANKS = ("median", "p90", "p99", "max")
TITLES = {
    "own": "through our own scene, 1024x768",
    "terrace": "through terrace, 1236x822",
}
QUANTITIES = {  # of the report: name, its factor, digits
    "cycles": ("cycles", 1, None),
    "us": ("us", 1, 0),
    "megabytes": ("MB", 1, 1),
    "chip_uj": ("mJ, chip", 1e-3, 2),
    "dram_uj": ("mJ, DRAM", 1e-3, 2),
}


def at(scene, quantity, rank):
    return data.walks[scene].percentiles[quantity][rank]["value"]


def tail(scene, quantity, rank="p99"):
    """A percentile over the median."""
    return at(scene, quantity, rank) / at(scene, quantity, "median")


def walks():
    """What a frame takes: percentiles of each quantity on each scene."""
    rows = []
    for scene in TITLES:
        for quantity, (name, factor, digits) in QUANTITIES.items():
            found = [factor * at(scene, quantity, rank) for rank in RANKS]
            cells = [round(value) if digits is None else fixed(value, digits) for value in found]
            rows.append([TITLES[scene] if quantity == "cycles" else "", name, *cells, times(tail(scene, quantity))])
        frames = [data.walks[scene].percentiles["cycles"][rank]["frame"] for rank in RANKS]
        rows.append(["", "frame, of the cycles", *frames, ""])
    return table(["walk", "", "median", "90 %", "99 %", "max", "99 % / median"], rows)


def joules(scene, rank):
    """Chip and DRAM, mJ."""
    return 1e-3 * (at(scene, "chip_uj", rank) + at(scene, "dram_uj", rank))


def least(scene):
    """The cheapest frame over the median."""
    return data.walks[scene].least_cycles / at(scene, "cycles", "median")


def rtl_differs(quantity):
    """The largest difference of a frame between RTL and timing model, as a share."""
    rtl, model = data.walks.rtl[quantity], data.walks.model[quantity]
    return max(abs(a / b - 1) for a, b in zip(rtl, model))
