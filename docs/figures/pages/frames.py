# SPDX-License-Identifier: Apache-2.0
"""What several pages read of frames: cycles and bytes by the timing model, work by the golden model."""
from data import data
from formats import mean
from measurements import FOUR

PINS = 51.2  # bytes a cycle of the default memory
VIEWS = {  # scene: its name and view, Gaussians, pixels
    "own": "our own scene (60k Gaussians, 1024x768)",
    "terrace": "terrace 0 (300k, 1236x822)",
    "statue": "statue 0 (134k, 960x1280)",
    "flowers": "flowers 0 (542k, 1296x840)",
}

SCENE_NAMES = {
    **VIEWS,
    "showroom": "showroom 0 (indoor, 1264x832)",
    "campsite": "campsite 0 (drone)",
}


def of(found, name):
    """The row of a design point in what a command prints of several."""
    return next(row for row in found.designs if row.name == name)


def modelled(scene, name):
    return of(data.model[scene], name)


def cycles(scene, name):
    return modelled(scene, name).cycles


def total_bytes(streams):
    return sum(stream["read"] + stream["written"] for stream in streams.values())


def megabytes(scene, name):
    return total_bytes(modelled(scene, name).bytes) / 1e6


def over(scene, name, base="baseline"):
    """How many times as fast a design point is as another one."""
    return cycles(scene, base) / cycles(scene, name)


def fast_mean():
    """How many times as fast as baseline `fast` is, mean of the four scenes."""
    return mean(over(scene, "fast") for scene in FOUR)


def work(scene, name="fast"):
    return data.work[f"{scene}_{name}"]


def floor(scene):
    """Cycles of 64 lanes that blend the pairs that must be blended, and nothing else."""
    return work(scene).work.blended / 64


def bounds(scene, name="fast"):
    """Cycles that each resource needs at least."""
    found = work(scene, name).bounds
    return {
        "Row Units": found.pu_rows,
        "RU": found.ru,
        "SU": found.su,
        "cull": found.cull,
        "memory": 1e6 * megabytes(scene, name) / PINS,
    }


def largest_bound(scene, name="fast"):
    """(resource, its cycles)"""
    return max(bounds(scene, name).items(), key=lambda one: one[1])


def roofline(scene, name="fast"):
    return cycles(scene, name) / largest_bound(scene, name)[1]
