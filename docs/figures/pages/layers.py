# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/training.md."""
from data import data
from formats import change, fixed, group, mean, percent, table

MEASURED = ["trained/plush/*", "trained/scenes/*", "energy/terrace"]
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


def before_after(before, after):
    return f"{fixed(before, 1)} -> {fixed(after, 1)}"


def machine(found, name):
    """PSNR of a machine on the views held out, before and after; its cycles, in relation."""
    before, after = (found[key].machines[name] for key in ("held_out_before", "held_out"))
    return before_after(before.psnr_db, after.psnr_db), change(after.cycles / before.cycles - 1)


def given(found, name):
    """The scene's own views, in their order."""
    pairs = zip(found.held_out_before.given, found.held_out.given)
    return "; ".join(before_after(before[name].psnr_db, after[name].psnr_db) for before, after in pairs)


def fine_tuned():
    """Scenes that were trained on their own renders, in the order of 4 layers."""
    rows = []
    for scene in ("own", "terrace", "statue", "flowers"):
        found = data.trained.scenes[scene]
        (dop, dop_cycles), (fast, fast_cycles) = machine(found, "dop"), machine(found, "fast")
        exact = fixed(found.held_out.exact.psnr_db, 1)
        left = [percent(mean(found[key].violators), 1) for key in ("held_out_before", "held_out")]
        violators = " -> ".join(left)
        rows.append([scene, dop, given(found, "dop"), exact, fast, dop_cycles, fast_cycles, violators])
        rows[-1].append(fixed(found.minutes, 1))
    return table(
        [
            "scene",
            "`dop`, held out",
            "`dop`, the scene's own views",
            "exact order after",
            "`fast`, held out",
            "cycles of `dop`",
            "of `fast`",
            "beyond gamma d",
            "minutes",
        ],
        rows,
    )


def largest_change():
    """Of the cycles of any scene and machine."""
    shares = []
    for found in data.trained.scenes.values():
        for name in ("dop", "fast"):
            before, after = (found[key].machines[name].cycles for key in ("held_out_before", "held_out"))
            shares.append(abs(after / before - 1))
    return max(shares)


def own_view(scene, view, name="dop", when="held_out"):
    """One of the scene's own views; in dB."""
    return data.trained.scenes[scene][when].given[view][name].psnr_db


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
