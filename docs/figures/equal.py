# SPDX-License-Identifier: Apache-2.0
"""Equal quantities are equal wherever they were measured: cycles, bytes, mm2 and PSNR of one scene, view and machine.

Looked at is what a command says of a machine as a whole: its JSON where it has one machine, the rows of its `designs`,
or what stands under a design point's name. `differs` of a measurement names what is another quantity there, and why.
"""
import collections
import re

from measurements import TABLE
from sources import settings

QUANTITIES = ("cycles", "bytes", "mm2", "psnr_numeric_db", "psnr_order_db", "psnr_total_db")
# Options that make it another frame.
OTHER = re.compile(r"--(?:scale|window|crop|path|views|memory|library|walk-most|lod-pixels|picture|stereo|gaze) \S+")


def leaves(value, name):
    """(name.of.the.leaf, number) of all that lies in a value."""
    if isinstance(value, dict):
        for key, one in value.items():
            yield from leaves(one, f"{name}.{key}")
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        yield name, value


def wholes(one, figures):
    """(machine, what is said of it)"""
    machines = one.machines()
    if not isinstance(figures, dict):
        return
    if len(machines) == 1:
        yield machines[0], figures
    yield from zip(machines, figures.get("designs", []))
    for machine in machines:
        if isinstance(figures.get(machine), dict):
            yield machine, figures[machine]


def unequal(entries, table=None):
    """What is to be said of quantities that are not the same everywhere."""
    found = collections.defaultdict(lambda: collections.defaultdict(list))
    for one in TABLE if table is None else table:
        for machine, said in wholes(one, entries[one.name]["figures"]) if one.name in entries else ():
            place = (one.scene, one.view, *OTHER.findall(one.command), *sorted(settings(machine)))
            for key in QUANTITIES:
                if key in said and not re.search(rf"\b{key}\b", one.differs):
                    for name, value in leaves(said[key], key):
                        found[(*place, name)][value].append(f"{one.name} ({machine})")
    return [
        f"{key[0]}, view {key[1]}: {key[-1]} is not the same: "
        + "; ".join(f"{value} in {', '.join(names)}" for value, names in values.items())
        for key, values in found.items()
        if len(values) > 1
    ]
