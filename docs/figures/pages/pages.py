# SPDX-License-Identifier: Apache-2.0
"""The table of docs/pages.md."""
from data import data
from formats import fixed, table

MEASURED = ["viewer/*"]
CHOICES = {"machine": "like the machine", "float": "scene in float", "own": "Spark's defaults"}


def viewed():
    """Pages of `pipegs sim --viewer`: their size, and how far Spark's picture is from the machine's."""
    rows = []
    for scene in ("own", "plushdog", "terrace", "flowers"):
        found = data.viewer[scene]
        decibels = [fixed(found.psnr_db[choice], 2) for choice in CHOICES]
        rows.append([scene, fixed(found.bytes / 1e6, 1), *decibels])
    return table(["scene", "page, MB", *(f"{name}, dB" for name in CHOICES.values())], rows)
