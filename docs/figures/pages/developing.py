# SPDX-License-Identifier: Apache-2.0
"""Figures of docs/developing.md."""
from data import data

MEASURED = ["loops/all"]


def seconds(loop):
    return f"{data.loops.all[loop]} CPU seconds"
