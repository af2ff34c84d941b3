# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/numerics/time.md."""
from data import data
from formats import fixed, group, listing, percent, span, table

MEASURED = ["tradeoff/*"]
TITLES = {"own": "our own scene", "terrace": "terrace 0"}


def points(scene):
    return data.tradeoff[scene].points


def base(scene):
    return points(scene)[0]


def share(scene, row):
    """Of the time of the whole frame."""
    return percent(row.cycles / base(scene).cycles, 1)


def front(scene):
    """The points that no other one beats, the most accurate first."""
    rows = sorted((row for row in points(scene) if row.front), key=lambda row: row.front)
    return listing(
        TITLES[scene],
        [(row.label if row.knob == "together" else f"{row.knob} {row.label}", row) for row in rows],
        ("us", "us", fixed, 1),
        ("of all", lambda row: share(scene, row)),
        ("MB", lambda row: row.bytes / 1e6, fixed, 1),
        ("dB", "psnr_db", fixed, 2),
        ("SSIM", "ssim", fixed, 4),
    )


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
