# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/cycles/timing_model.md."""
import re

from data import data
from formats import group, table
from measurements import POINTS
from pages.cycles.ladder import rtl
from pages.frames import cycles, modelled  # noqa: F401  (the page uses modelled)

FIXED = ("waves", "taps", "asserts")  # no scene decides on them, as the page says
MEASURED = ["model/*", "rtl/*", "effects/*"]


def agreement():
    """Frames by the RTL beside the model's."""
    found = [(f"own, `{name}`", cycles("own", name), rtl(name).cycles) for name in POINTS]
    found += [
        (f"terrace 0, `{name}`", cycles("terrace", name), data.rtl[f"terrace_{name}"].cycles)
        for name in ("fast", "dop")
    ]
    rows = [[name, model, beside, group(beside - model)] for name, model, beside in found]
    return table(["frame", "cycles, model", "cycles, RTL", "difference"], rows)


def evidence():
    """Which effects two scenes call for, and why."""

    def cell(one):
        figures = re.findall(r"degree \d|(?<![\w.])\d+(?:\.\d+)?(?: %| lines| M)?", one.evidence)
        short = ", ".join(group(int(figure)) if figure.isdigit() else figure for figure in figures)
        return f"{'**yes**' if one.called_for else 'no'} {short}".strip()

    rows = zip(data.effects.own.effects, data.effects.statue.effects)
    cells = [[f"`{a.name}`", cell(a), cell(b)] for a, b in rows if a.name not in FIXED]
    return table(["effect", "our own", "statue"], cells)
