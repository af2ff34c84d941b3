# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/numerics/time.md."""
import math

import drawing
from data import data
from formats import fixed, group, listing, millions, percent, span, table, thousands
from measurements import FRONTS
from pages.silicon.silicon import ranged

MEASURED = ["tradeoff/*"]
TITLES = dict(zip(FRONTS, ("our own scene", "terrace 0", "showroom 0")))
STEP_DB = 20 * math.log10(255)  # of an error of one step of 8 bits


def points(scene):
    return data.tradeoff[scene].points


def base(scene):
    return points(scene)[0]


def share(scene, row):
    """Of the time of the whole frame."""
    return percent(row.cycles / base(scene).cycles, 1)


def on_front(scene):
    """The points that no other one beats, the most accurate first."""
    return sorted((row for row in points(scene) if row.front), key=lambda row: row.front)


def modelled(row, beyond, value, form, *rest):
    """What the models of area and energy say of a machine: with ~ beyond what they were fitted to, - of a kind that
    they do not know."""
    if row.silicon is None:
        return "-"
    return ("~" if row.silicon[beyond] else "") + form(value(row.silicon), *rest)


def energy(silicon):
    """uJ of a frame, chip and DRAM together: low, mid, high."""
    return {end: 1e3 * (silicon.chip_mj[end] + silicon.dram_mj[end]) for end in ("low", "mid", "high")}


def front(scene):
    """What the points of a front cost, and how close they are."""
    return listing(
        TITLES[scene],
        [(row.label if row.knob == "together" else f"{row.knob} {row.label}", row) for row in on_front(scene)],
        ("us", "us", fixed, 1),
        ("of all", lambda row: share(scene, row)),
        ("MB", lambda row: row.bytes / 1e6, fixed, 1),
        ("uJ", lambda row: modelled(row, "extrapolated_energy", lambda one: energy(one)["mid"], group)),
        ("mm2", lambda row: modelled(row, "extrapolated_area", lambda one: one.mm2.mid, fixed, 3)),
        ("dB", "psnr_db", fixed, 2),
        ("SSIM", "ssim", fixed, 4),
    )


def whole_frame(scene):
    """uJ of the whole frame, with their range."""
    return f"{ranged(energy(base(scene).silicon), 0)} uJ"


def fronts():
    """The fronts of all scenes, from the whole frame's time down."""

    def line(scene):
        whole = base(scene)
        found = [(100 * row.cycles / whole.cycles, row.psnr_db) for row in on_front(scene)]
        form = millions if whole.gaussians >= 1e6 else thousands
        return TITLES[scene], f"{form(whole.gaussians)} Gaussians", [one for one in found if one[0] <= 100]

    return drawing.lines(
        "The less accurate, the faster",
        "time of the frame; 100 %: nothing is left out",
        "accuracy, dB",
        (STEP_DB, "an error of one step of 8 bits"),
        [line(scene) for scene in TITLES],
    )


DRAWN = {"tradeoff.svg": fronts}


def single(scene, knob, label):
    """One thing alone; None where the scene has none of it."""
    found = [row for row in points(scene) if (row.knob, row.label) == (knob, label)]
    return found[0] if found else None


def alone():
    """Each way alone on each scene: its share of the time, and what it leaves of the accuracy."""
    rows = [["all: us, dB", *[f"{fixed(base(scene).us, 1)}, {fixed(base(scene).psnr_db, 1)}" for scene in TITLES]]]
    for row in points("own")[1:]:
        if row.knob == "together":
            continue
        cells = [f"{row.knob} {row.label}"]
        for scene in TITLES:
            one = single(scene, row.knob, row.label)
            cells.append(f"{share(scene, one)}, {fixed(one.psnr_db, 1)}" if one else "-")
        rows.append(cells)
    return table(["with less: time, dB", *TITLES.values()], rows)


def prices():
    """Each section of each scene's front."""
    return listing(
        "scene",
        [(TITLES[scene], (scene, section)) for scene in TITLES for section in data.tradeoff[scene].price],
        ("dB", lambda one: f"{fixed(one[1].from_db, 1)} to {fixed(one[1].to_db, 1)}"),
        ("us saved", lambda one: one[1].us, fixed, 1),
        ("us a decibel", lambda one: one[1].us_per_db, fixed, 1),
        ("of the whole frame's time", lambda one: one[1].us_per_db / base(one[0]).us, percent, 1),
    )


def saved(knob, label):
    """Per cent of the time that one thing alone saves, over the scenes."""
    found = [single(scene, knob, label) for scene in TITLES]
    shares = [100 * (1 - one.cycles / base(scene).cycles) for scene, one in zip(TITLES, found) if one]
    return f"{span(fixed, shares, 1)} %"


def spared(knob, label):
    """Per cent of the bytes, then of the energy, that one thing alone spares, over the scenes."""
    found = [(base(scene), single(scene, knob, label)) for scene in TITLES]
    moved = [100 * (1 - one.bytes / whole.bytes) for whole, one in found]
    spent = [100 * (1 - energy(one.silicon)["mid"] / energy(whole.silicon)["mid"]) for whole, one in found]
    return f"{span(fixed, moved, 1)} % of the bytes and {span(fixed, spent, 1)} % of the energy"


def of_all(scene, knob, label):
    return share(scene, single(scene, knob, label))


def left(knob, label):
    """Decibels that are left, over the scenes."""
    return f"{span(fixed, [one.psnr_db for one in (single(scene, knob, label) for scene in TITLES) if one], 1)} dB"


def slowest_order():
    """What layers take more than the exact order, in per cent: the least and the most of all grids and scenes."""
    shares = [
        100 * (row.cycles / base(scene).cycles - 1) for scene in TITLES for row in points(scene) if row.knob == "order"
    ]
    return f"{span(fixed, shares, 1)} %"


def measured():
    """How many points of all scenes."""
    return group(sum(len(points(scene)) for scene in TITLES))
