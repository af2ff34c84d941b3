# SPDX-License-Identifier: Apache-2.0
"""The figures under docs/data as one tree: data.ladder.own.exact.cycles is the entry `own` of docs/data/ladder.json,
exact, cycles.

A file holds a family of measurements, {"own": {"by": {part of the sources: hash}, "commit", "date", "seconds",
"figures"}}. An entry is written whole or not at all, under a lock: two that measure do not hinder each other.
"""
import contextlib
import fcntl
import json
import os
import re

from sources import MODULES, ROOT
from tree import Figures, wrap

FOLDER = ROOT / "docs/data"
NEXT = re.compile(r",\n\s+")


def stored():
    """{name of a measurement: its entry}"""
    files = sorted(file for file in FOLDER.glob("*.json") if file != MODULES)
    return {f"{file.stem}/{name}": entry for file in files for name, entry in json.loads(file.read_text()).items()}


def grow(entries):
    """Puts the figures of these entries into the tree, in place of what it held; {name: its node}."""
    tree, nodes = {}, {}
    for name, entry in entries.items():
        place = tree
        *folders, last = name.split("/")
        for folder in folders:
            place = place.setdefault(folder, {})
        place[last] = nodes[name] = wrap(entry["figures"], name)

    def wrapped(place):
        return {key: Figures(wrapped(one)) if isinstance(one, dict) else one for key, one in place.items()}

    data.__init__(wrapped(tree))
    return nodes


data = Figures({})


def text_of(value):
    """JSON; a list of numbers and words in one line."""
    row = r"\[\n\s+([^\[\]{}]*?)\n\s*\]"
    return re.sub(row, lambda found: f"[{re.sub(NEXT, ', ', found[1])}]", json.dumps(value, indent=1))


@contextlib.contextmanager
def locked():
    folder = os.open(FOLDER, os.O_RDONLY)
    try:
        fcntl.flock(folder, fcntl.LOCK_EX)
        yield
    finally:
        os.close(folder)


def store(entries):
    """Writes these entries {name: entry}, None to remove one, beside those that are there."""
    with locked():
        for family in sorted({name.split("/")[0] for name in entries}):
            file = FOLDER / (family + ".json")
            known = json.loads(file.read_text()) if file.exists() else {}
            known |= {
                name.removeprefix(family + "/"): e for name, e in entries.items() if name.startswith(family + "/")
            }
            known = {name: known[name] for name in sorted(known) if known[name] is not None}
            fresh = file.with_suffix(".new")
            fresh.write_text(text_of(known) + "\n")
            fresh.replace(file)
