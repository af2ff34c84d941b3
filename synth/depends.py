#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""depends.py: which knobs each block of the machine depends on, into synth/data/depends.csv: one elaboration for each
knob.

Idea    A block depends on a knob when its elaborated text changes with it, but for the order of its lines and the
        numbers of nameless signals, which Yosys gives out anew. Nothing is mapped, so this is exact and cheap, and the
        area model's least squares (sim/study/silicon/area/area_model.hpp) never lays one knob's area on another.
"""
import argparse
import collections
import hashlib
import os
import re
import signal
import sys

import points
import synth
from jobs import Failed, Jobs

# Every knob of `pipegs accuracy` that moves gates, at a value that none of DESIGN_POINTS has. Without spherical
# harmonics whole blocks are gone.
KNOBS = [
    "coeff_f=24",
    "power_f=16",
    "window=32",
    "mean_f=10",
    "mantissa_w=22",
    "exp_index_w=5",
    "exp_linear=0",
    "alpha_w=10",
    "t_w=16",
    "color_w=10",
    "rgb_w=14",
    "alpha_cut=128",
    "t_cut=1000",
    "depth_w=20",
    "pos_w=18",
    "quat_w=14",
    "scale_m_w=10",
    "opacity_f=10",
    "base_w=10",
    "sh_m_w=9",
    "sh_degree=2",
    "sh_degree=0",
    "tile_test=0",
    "grid=2",
    "records=512",
]
DESIGN_POINTS = ["exact", "dop", "baseline"]  # together they hold every block of points.csv


def digests(modules):
    """{block: digests of the modules that it holds}"""
    texts = collections.defaultdict(list)
    for module, _, block, _ in points.instances(modules):
        lines = sorted(re.sub(r"\$\d+", "$", line) for line in module.text().splitlines())
        texts[block].append(hashlib.sha256("\n".join(lines).encode()).hexdigest())
    return {block: sorted(found) for block, found in texts.items()}


def main():
    parser = argparse.ArgumentParser(description="Which knobs each block depends on.")
    parser.add_argument("--build", default="build", help="build folder; holds cpp_model/package_sv")
    parser.add_argument("--out", default=f"{synth.HERE}/data/depends.csv", help="the table")
    options = parser.parse_args()
    jobs = Jobs(os.path.abspath(f"{options.build}/synth/cache"), 1)
    found, line = collections.defaultdict(set), points.csv_line("synth/data/depends.csv")
    for design_point in DESIGN_POINTS:
        base = digests(points.elaborated(jobs, options.build, design_point)[1])
        for block in base:
            found[block] |= set()
        for number, knob in enumerate(KNOBS, 1):
            print(f"{design_point}: {number} of {len(KNOBS)}: {knob}", flush=True)
            moved = digests(points.elaborated(jobs, options.build, f"{design_point} {knob}")[1])
            for block in base:
                if moved.get(block) != base[block]:
                    found[block].add(knob.split("=")[0])
            synth.write_new(
                options.out,
                f"{line}\nblock,knobs\n"
                + "".join(f"{block},{' '.join(sorted(knobs))}\n" for block, knobs in sorted(found.items())),
            )


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # as control-C: ends what was started
    try:
        main()
    except Failed as error:
        sys.exit(f"depends: {error}")
    except KeyboardInterrupt:
        sys.exit("\ndepends: interrupted")
