# SPDX-License-Identifier: Apache-2.0
"""A frame of 13 M Gaussians whose windows are shared out: what docs/campaign.md works out from measured parts."""
from math import ceil

from data import data
from formats import fixed, group, table

MEASURED = ["scale/*", "speed/*"]
GAUSSIANS, BELOW, ABOVE = 13, 8, 16  # millions: of the frame, and of the two scenes that were measured
WIDTH, HEIGHT, WINDOW = 1296, 840, 128
KHZ = data.speed.fast["+"].compared_khz


def between(figure):
    """At 13 M Gaussians, on the line between the two scenes; `figure` takes simulation and model."""
    low, high = (figure(data.scale.sim[f"gaussians_{n}m"], data.scale.model[f"gaussians_{n}m"]) for n in (BELOW, ABOVE))
    return low + (high - low) * (GAUSSIANS - BELOW) / (ABOVE - BELOW)


UNDIVIDED = between(lambda sim, _: sim.seconds.rest + sim.seconds.pack)
GOLDEN = between(lambda sim, _: sim.seconds.golden)
CYCLES = between(lambda _, model: model.cycles)
MEMORY = between(lambda sim, _: sim.memory)


def jobs(windows):
    """Points of a frame whose points are so many windows side by side."""
    return ceil(HEIGHT / WINDOW) * ceil(ceil(WIDTH / WINDOW) / windows)


def seconds(windows):
    """Of each point on a core of its own: what each does anew, and an equal part of the rest."""
    return UNDIVIDED + (GOLDEN + CYCLES / KHZ / 1000) / jobs(windows)


def whole():
    return UNDIVIDED + GOLDEN + CYCLES / KHZ / 1000


def shared_out():
    rows = [["whole", "1", fixed(whole() / 60, 1), "1.0", "100 %"]]
    for windows in (6, 3, 2, 1):
        busy = seconds(windows) * jobs(windows)
        rows.append(
            [
                str(windows),
                str(jobs(windows)),
                fixed(seconds(windows) / 60, 1),
                fixed(whole() / seconds(windows), 1),
                f"{100 * whole() / busy:.0f} %",
            ]
        )
    share = "share of the time that is not reading and packing"
    return table(["windows of a point", "machines", "minutes", "times as fast", share], rows)
