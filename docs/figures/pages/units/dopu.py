# SPDX-License-Identifier: Apache-2.0
"""Figures of docs/units/dopu.md."""
from formats import fixed
from pages.frames import work
from pages.numerics.numbers import left  # noqa: F401  (the page uses it)

MEASURED = ["work/*", "prints/all"]


def fetched(scene, name="fast"):
    """Times that a Gaussian of the scene is fetched for a frame."""
    found = work(scene, name)
    return fixed(found.work.fetched / found.scene.gaussians, 2)
