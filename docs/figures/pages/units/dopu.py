# SPDX-License-Identifier: Apache-2.0
"""The table of docs/units/dopu.md."""
from data import data
from formats import fixed, table
from pages.numerics.numbers import left  # noqa: F401  (the page uses it)

MEASURED = ["results/terrace_*", "results/statue_*", "profile/*", "prints/*/dopu_depth"]
GAUSSIANS = {"terrace": 300000, "statue": 133618}


def chunks():
    """Fetched for each Gaussian of the scene, by size of the chunks."""

    def cell(scene, fetched):
        return fixed(fetched / GAUSSIANS[scene], 2)

    scenes = list(GAUSSIANS)
    rows = [
        [
            f"as built: chunks of 16, groups of 32, view {view}",
            *[cell(scene, data.results[f"{scene}_{view}"].work.fetched) for scene in scenes],
        ]
        for view in (0, 1, 2)
    ]
    rows.append(
        [
            "`--set chunk=32 --set group=16`, view 0",
            *[cell(scene, data.profile[f"{scene}_chunk32"].fetched) for scene in scenes],
        ]
    )
    return table(["", *scenes], rows)
