# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/training.md."""
from data import data
from formats import fixed, group, listing, mean, percent
from pages.silicon.silicon import area, design

MEASURED = ["trained/*", "silicon/*"]
PHOTOGRAPHS = {  # what a scene is trained for: the paper's Table 1 in exact order and in layers
    "original": ("exact order, no CLDR: the original", "26.42", "25.19"),
    "layers": ("order of the layers, CLDR logarithm: the default", "-", "26.21"),
}


def likeness(one):
    return f"{fixed(one.psnr_db, 2)}, {fixed(one.ssim, 4)}"


def violators(quality):
    """Gaussians beyond gamma d, of the three axes."""
    return percent(mean(quality.violators), 1)


def plush(name):
    return data.trained[f"plush_{name}"]


def photographs():
    """The paper's Table 1, on photographs."""
    return listing(
        "how the steps draw and what they add",
        [(what, (plush(name), exact, layers)) for name, (what, exact, layers) in PHOTOGRAPHS.items()],
        ("float64, exact order", lambda one: likeness(one[0].held_out.exact)),
        ("float64, 8 layers", lambda one: likeness(one[0].held_out.layered)),
        ("`dop`, 8 layers", lambda one: likeness(one[0].held_out.machines.dop)),
        ("`fast`", lambda one: likeness(one[0].held_out.machines.fast)),
        ("beyond gamma d", lambda one: violators(one[0].held_out)),
        ("Gaussians", lambda one: one[0].gaussians, group),
        ("minutes", lambda one: one[0].minutes, fixed, 1),
        ("paper, exact", lambda one: one[1]),
        ("paper, layers", lambda one: one[2]),
    )


def fine_tuned():
    """terrace, trained on its own renders in the order of 4 layers: before and after."""
    found = data.trained.terrace

    def given(place):
        return lambda one: [view for view in one["views"] if not view.held_out][place].dop.psnr_db

    return listing(
        "terrace",
        [("before", found.held_out_before), ("after", found.held_out)],
        ("`dop`, held out, dB", lambda one: one.machines.dop.psnr_db, fixed, 1),
        *[(f"`dop`, view {place}", given(place), fixed, 1) for place in range(3)],
        ("exact order, dB", lambda one: one.exact.psnr_db, fixed, 1),
        ("`fast`, held out", lambda one: one.machines.fast.psnr_db, fixed, 1),
        ("cycles of `dop`", lambda one: one.machines.dop.cycles, group),
        ("of `fast`", lambda one: one.machines.fast.cycles, group),
        ("beyond gamma d", violators),
    )


def order():
    """Layers, which need training, beside exact order, which needs none; terrace."""
    return listing(
        "machine",
        [(f"`{name}`, {what}", name) for name, what in (("fast", "watermarks"), ("dop", "layers"))],
        ("area, mm2", lambda name: area(name, "Total"), fixed, 2),
        ("cycles", lambda name: design("terrace", name).cycles),
        ("mJ of the chip", lambda name: 1e3 / design("terrace", name).frames_per_joule, fixed, 2),
        ("mJ with DRAM", lambda name: 1e3 / design("terrace", name).frames_per_joule_with_dram, fixed, 2),
    )
