# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/numerics/layers.md."""
from data import data
from formats import fixed, group, mean, percent, table

MEASURED = ["trained/plush/*", "energy/terrace"]
PAPER = {"none": (26.42, 25.19), "order_logarithm": (None, 26.21)}  # Table 1, average: original or exact, layers
WAYS = {  # data.trained.plush: how it was trained
    "none": "exact order, no CLDR: the original",
    "printed": "exact order, CLDR as printed",
    "relative": "exact order, CLDR relative",
    "order": "order of the layers, no CLDR",
    "order_relative": "order of the layers, CLDR relative",
    "order_logarithm": "order of the layers, CLDR logarithm: the default",
}


def likeness(one):
    return f"{fixed(one.psnr_db, 2)}, {fixed(one.ssim, 4)}"


def violators(quality):
    """Of the three axes."""
    return percent(mean(quality.violators), 1)


def photographs():
    """The paper's Table 1, on photographs."""
    rows = []
    for name, way in WAYS.items():
        found = data.trained.plush[name]
        after = found.held_out
        paper = ["-" if one is None else fixed(one, 2) for one in PAPER.get(name, (None, None))]
        rows.append(
            [
                way,
                likeness(after.exact),
                likeness(after.layered),
                likeness(after.machines.dop),
                likeness(after.machines.fast),
                violators(after),
                group(found.gaussians),
                fixed(found.minutes, 1),
                *paper,
            ]
        )
    return table(
        [
            "how the steps draw and what they add",
            "float64, exact order",
            "float64, 8 layers",
            "`dop`, 8 layers",
            "`fast`",
            "beyond gamma d",
            "Gaussians",
            "minutes",
            "paper, exact",
            "paper, layers",
        ],
        rows,
    )


def plush(way, order=None):
    """The views held out; in dB, in one order."""
    found = data.trained.plush[way].held_out
    return found if order is None else found[order].psnr_db


def worth():
    """Layers that were trained for, beside exact order that needs no training; terrace."""
    rows = []
    for point, what in (("dop", "layers"), ("exact", "watermarks"), ("fast", "watermarks")):
        found = data.energy.terrace[point]
        rows.append(
            [
                f"`{point}`, {what}",
                fixed(found.mm2, 2),
                group(found.cycles),
                fixed(1e3 / found.frames_per_joule, 2),
                fixed(1e3 / found.frames_per_joule_with_dram, 2),
            ]
        )
    return table(["machine", "area, mm2", "cycles", "mJ of the chip", "mJ with DRAM"], rows)
