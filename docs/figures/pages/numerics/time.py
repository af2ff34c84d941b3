# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/numerics/time.md."""
from data import data
from formats import fixed, group, percent, span, table

MEASURED = ["tradeoff/*"]
TITLES = {"own": "our own scene", "terrace": "terrace 0", "statue": "statue 0", "flowers": "flowers 0"}


def points(scene):
    return data.tradeoff[scene].points


def base(scene):
    return points(scene)[0]


def share(scene, row):
    """Of the time of the whole frame."""
    return percent(row.cycles / base(scene).cycles, 1)


def front_rows(scene):
    return sorted((row for row in points(scene) if row.front), key=lambda row: row.front)


def front(scene):
    """The points that no other one beats, the most accurate first."""
    rows = [
        [
            str(row.front),
            row.label if row.knob == "together" else f"{row.knob} {row.label}",
            fixed(row.us, 1),
            share(scene, row),
            fixed(row.bytes / 1e6, 1),
            fixed(row.psnr_db, 2),
            fixed(row.ssim, 4),
        ]
        for row in front_rows(scene)
    ]
    return table(["", "with less", "us", "of all", "MB", "dB", "SSIM"], rows)


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


def legs(level):
    """Of each scene that has it the leg that ends at this level of decibels."""
    found = {}
    for scene in TITLES:
        for leg in data.tradeoff[scene].price:
            if level <= leg.to_db < {50: 1000, 40: 50, 30: 40}[level]:
                found[scene] = leg
    return found


def price(level):
    """Microseconds a decibel on the way to a level, over the scenes."""
    return f"{span(fixed, [leg.us_per_db for leg in legs(level).values()], 1)} us"


def price_share(level):
    """The same as shares of the frame's time."""
    found = [100 * leg.us_per_db / base(scene).us for scene, leg in legs(level).items()]
    return f"{span(fixed, found, 1)} %"


def reached(level):
    """Shares of the time at the ends of those legs."""
    found = []
    for scene, leg in legs(level).items():
        (row,) = [row for row in points(scene) if row.front == leg.to]
        found.append(100 * row.cycles / base(scene).cycles)
    return f"{span(fixed, found, 0)} %"


def prices():
    """Each leg of each scene."""
    rows = [
        [
            TITLES[scene],
            f"{fixed(leg.from_db, 1)} to {fixed(leg.to_db, 1)}",
            f"{leg['from']} to {leg.to}",
            fixed(leg.us, 1),
            fixed(leg.us_per_db, 1),
            percent(leg.us_per_db / base(scene).us, 1),
        ]
        for scene in TITLES
        for leg in data.tradeoff[scene].price
    ]
    return table(["scene", "dB", "front", "us saved", "us a decibel", "of the whole frame's time"], rows)


def saved(knob, label):
    """Per cent of the time that one thing alone saves, over the scenes."""
    found = [single(scene, knob, label) for scene in TITLES]
    shares = [100 * (1 - one.cycles / base(scene).cycles) for scene, one in zip(TITLES, found) if one]
    return f"{span(fixed, shares, 1)} %"


def mb(scene, knob, label):
    return f"{fixed(single(scene, knob, label).bytes / 1e6, 1)} MB"


def us(scene, knob, label):
    return f"{fixed(single(scene, knob, label).us, 1)} us"


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
