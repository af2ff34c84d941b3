# SPDX-License-Identifier: Apache-2.0
"""Figures of README.md: what `make run` prints and takes."""
import re

from data import data
from formats import block, fixed
from pages.frames import fast_mean  # noqa: F401  (the page uses it)

MEASURED = ["model/*", "rtl/printed", "loops/*"]


def minutes(*loops):
    """What these take together on one core."""
    return f"{fixed(sum(data.loops.all[loop] for loop in loops) / 60, 1)} CPU minutes"


def gigabytes(key):
    return f"{fixed(data.loops.all[key] / 1024, 1)} GB"


LEFT_OUT = r" +(pu|su|ru) +[1-9] |    [a-z_0-9-]+:? +[\d.]+ (MB|GB)|  (work|wall)|$"


def sample():
    """Of four units of a kind the first; no streams, counts and seconds."""
    return block(line for line in data.rtl.printed.lines if not re.match(LEFT_OUT, line))
