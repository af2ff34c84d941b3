#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""points.py: synthesises configurations around two design points into synth/data/points.csv, which the area model
interpolates (sim/study/silicon/area/area_model.hpp).

Idea    A row is a block of the machine in one configuration: a module with what it holds of rtl/lib. A block depends on
        few knobs, so few configurations tell them apart: those in which knobs move that seldom meet in a block, then
        some in which all move. What a change leaves alone comes out of the cache, and nothing is timed.
Rule    Areas are those of `make synth`, buffers included, memories not; of all instances in the machine.
"""
import argparse
import collections
import glob
import os
import re
import signal
import subprocess
import sys

import liberty
import report
import rtlil
import synth
from jobs import Failed, Jobs

sys.path.append(f"{synth.ROOT}/docs/figures")
from sources import csv_line  # noqa: E402  (what tables are measured with)

HEAD = "configuration,unit,block,instances,nand2,flipflops"


def settings(text):
    """["key=value", ...] of "dop key=value ...": a design point and what is changed in it."""
    design_point, *rest = text.split()
    return [f"{key}={value}" for key, value in synth.design_point_settings(design_point)] + rest


def instances(modules):
    """(module, unit, block, whether it is the block itself) of every instance that is no memory."""
    shared = {os.path.basename(path)[:-3] for path in glob.glob(f"{synth.ROOT}/rtl/lib/*.sv")}

    def visit(module, unit, block):
        if module.base == rtlil.MEMORY:
            return
        unit = report.UNITS.get(module.base, unit) if unit == "top" else unit
        own = module.base not in shared
        block = module.base if own else block
        yield module, unit, block, own
        for _, child in module.children:
            yield from visit(child, unit, block)

    yield from visit(modules[synth.TOP], "top", synth.TOP)


def elaborated(jobs, build, text):
    """The name of a configuration, and its modules."""
    printed = subprocess.run([f"{build}/cpp_model/package_sv", *settings(text)], capture_output=True, text=True)
    if printed.returncode != 0:
        raise Failed(printed.stderr.strip())
    return re.search(r"Configuration: (\S+)\.", printed.stdout)[1], synth.elaborate(jobs, printed.stdout)


def point(machine, build, text):
    """The table's lines of one configuration."""
    configuration, modules = elaborated(machine.jobs, build, text)
    netlists = machine.netlists(modules, [synth.TOP])
    areas = {name: gate.area(machine.library) / machine.library.nand.area for name, gate in netlists.items()}
    flipflops = {name: gate.flipflops(machine.library) for name, gate in netlists.items()}
    rows = collections.defaultdict(lambda: [0, 0, 0])
    for module, unit, block, own in instances(modules):
        row = rows[unit, block]
        row[0] += own
        row[1] += areas[module.name]
        row[2] += flipflops[module.name]
    return [
        f'"{configuration}",{unit},{block},{count},{nand2:.0f},{flops}'
        for (unit, block), (count, nand2, flops) in sorted(rows.items())
    ]


def main():
    parser = argparse.ArgumentParser(description="Synthesises the points of the area model into synth/data/points.csv.")
    parser.add_argument(
        "--liberty", default="/usr/share/qflow/tech/osu018/osu018_stdcells.lib", help="the library, .gz too"
    )
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="programs at once")
    parser.add_argument("--build", default="build", help="build folder; holds cpp_model/package_sv")
    parser.add_argument("--out", default=f"{synth.HERE}/data/points.csv", help="the table")
    parser.add_argument("points", nargs="*", help='"POINT key=value ..."; without any those of points.txt')
    options = parser.parse_args()
    with open(f"{synth.HERE}/data/points.txt", encoding="utf-8") as file:
        lines = file.read().replace("\n ", " ").splitlines()  # a line that begins with a blank goes on
    points = options.points or [" ".join(line.split()) for line in lines if line.strip() and not line.startswith("#")]
    machine = synth.Machine(
        Jobs(os.path.abspath(f"{options.build}/synth/cache"), options.jobs), liberty.Library(options.liberty), 20
    )
    lines = [csv_line("synth/data/points.csv"), HEAD]  # the sources of now: what changes meanwhile is not in it
    for number, text in enumerate(points, 1):
        print(f"{number} of {len(points)}: {text}", flush=True)
        lines += point(machine, options.build, text)
        synth.write_new(options.out, "\n".join(lines) + "\n")


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # as control-C: ends what was started
    try:
        main()
    except Failed as error:
        sys.exit(f"points: {error}")
    except KeyboardInterrupt:
        sys.exit("\npoints: interrupted; what is done is kept")
