#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""depends.py: which knobs each block of the machine depends on, into synth/data/depends.csv: one elaboration for each
knob.

Idea    A block depends on a knob when its elaborated text changes with it, but for the order of its lines and the
        numbers of nameless signals, which Yosys gives out anew. Nothing is mapped, so this is exact and cheap, and the
        area model's least squares (sim/silicon/area/area_model.hpp) never lays one knob's area on another.
Rule    What there is once in each unit, or in each PU that fetches, and is so with any number of them, does not depend
        on that number. A knob that a design point cannot take is none of it.
"""
import argparse
import collections
import functools
import hashlib
import os
import re
import signal
import sys

import points
import synth
from jobs import Failed, Jobs

# Every knob that moves gates: of `pipegs accuracy`, of `pipegs study shapes`, and of the design points, but for those
# that make another kind of machine (sim/silicon/area/machine_kind.hpp). Each at a value that none of DESIGN_POINTS has,
# or at each of its values where it has no more. Without spherical harmonics whole blocks are gone.
KNOBS = [
    "coeff_f=22",
    "power_f=16",
    "window=32",
    "mean_f=10",
    "mantissa_w=24",
    "exp_index_w=5",
    "exp_linear=0",
    "alpha_w=9",
    "t_w=16",
    "color_w=10",
    "rgb_w=14",
    "alpha_cut=128",
    "t_cut=1000",
    "depth_w=20",
    "pos_w=16",
    "quat_w=14",
    "scale_m_w=10",
    "opacity_f=10",
    "base_w=10",
    "sh_m_w=9",
    "sh_degree=2",
    "sh_degree=0",
    "tile_test=0",
    "tile_test=2",
    "grid=2",
    "records=512",
    "units=2",
    "fronts=1",
    "group=8",
    "occlusion=0",
    "occlusion=1",
    "tests=1",
    "tests=2",
    "tight_cull=0",
    "tight_cull=1",
    "tight_boxes=0",
    "tight_boxes=1",
    "pixel_w=32",
    "pixel_w=64",
    "bucket_bits=4",
    "nearest_nodes=256",
    "mark_chunks=4",
    "bus_w=128",
    "bus_w=256",
    "record=48",
    "lod=1",
]
# Together they hold every block of points.csv.
DESIGN_POINTS = ["fast", "fast record=48 lod=1", "exact", "dop", "baseline", "gscore"]


def digests(jobs, package):
    """{block: how many modules with which digest it holds}"""
    texts = collections.defaultdict(collections.Counter)
    for module, _, block, _ in points.instances(synth.elaborate(jobs, package)):
        lines = sorted(re.sub(r"\$\d+", "$", line) for line in module.text().splitlines())
        texts[block][hashlib.sha256("\n".join(lines).encode()).hexdigest()] += 1
    return texts


def package_with(build, design_point, knob):
    """The package of a design point with a knob at this value; None when it cannot take it."""
    try:
        return points.package(build, f"{design_point} {knob}")
    except Failed:
        return None


def copies(package):
    """How often what stands in each unit, and in each PU that fetches, does: the area model multiplies by them."""
    return [int(re.search(rf"\b{name} += (\d+);", package)[1]) for name in ("Units", "PuFronts")]


def depends(base, moved, of_base, of_moved):
    """Whether a block's text changes, or how many of it there are by anything but the number of units or fronts."""
    ratios = [(1, 1), *zip(of_base, of_moved)]
    return not any(
        base.keys() == moved.keys() and all(moved[text] * old == base[text] * new for text in base)
        for old, new in ratios
    )


def main():
    parser = argparse.ArgumentParser(description="Which knobs each block depends on.")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="programs at once")
    parser.add_argument("--build", default="build", help="build folder; holds cpp_model/package_sv")
    parser.add_argument("--out", default=f"{synth.HERE}/data/depends.csv", help="the table")
    options = parser.parse_args()
    jobs = Jobs(os.path.abspath(f"{options.build}/synth/cache"), options.jobs)
    found, line = collections.defaultdict(set), points.tables.whole_line()
    for design_point in DESIGN_POINTS:
        own = points.package(options.build, design_point)
        moved = {knob: package_with(options.build, design_point, knob) for knob in KNOBS}
        moved = {knob: printed for knob, printed in moved.items() if printed not in (None, own)}
        print(f"{design_point}: {len(moved)} knobs", flush=True)
        texts = jobs.each(
            f"knobs of {design_point}",
            [(knob, 1, functools.partial(digests, jobs, printed)) for knob, printed in {"": own, **moved}.items()],
        )
        for block, base in texts[""].items():
            found[block] |= {
                knob.split("=")[0]
                for knob, printed in moved.items()
                if depends(base, texts[knob].get(block, {}), copies(own), copies(printed))
            }
    rows = "".join(f"{block},{' '.join(sorted(knobs))}\n" for block, knobs in sorted(found.items()))
    synth.write_new(options.out, f"{line}\nblock,knobs\n{rows}")


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # as control-C: ends what was started
    try:
        main()
    except Failed as error:
        sys.exit(f"depends: {error}")
    except KeyboardInterrupt:
        sys.exit("\ndepends: interrupted; what is elaborated is kept")
