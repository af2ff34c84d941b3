#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""points.py: synthesises configurations around three design points into synth/data/points.csv and paths.csv, which the
models of area and clock interpolate (sim/silicon/area: area_model.hpp, path_model.hpp).

Idea    A row is a block of the machine in one configuration: a module with what it holds of rtl/lib. A block depends on
        few knobs, so few configurations tell them apart: those in which knobs move that seldom meet in a block, then
        some in which all move. What a change leaves alone comes out of the cache. Timed are the four units, each of
        their variants, and the machine: what a clock is made of.
Rule    Areas are those of `make synth`, buffers included, memories not; of all instances in the machine. A path is the
        longest between registers, in FO4 delays of the library, as in `make synth`.
"""
import argparse
import collections
import functools
import glob
import os
import re
import signal
import sys

import liberty
import report
import rtlil
import synth
import timing
from jobs import Failed, Jobs

sys.path.append(f"{synth.ROOT}/docs/figures")
import tables  # noqa: E402  (what they are measured with)

HEAD = "configuration,unit,block,instances,nand2,flipflops"
PATHS_HEAD = "configuration,unit,path_fo4"
TIMED = {base: unit for base, unit in report.UNITS.items() if unit in ("dopu", "pu", "su", "ru")} | {synth.TOP: "top"}


def instances(modules):
    """(module, unit, block, whether it is the block itself) of every instance that is no memory."""
    shared = {os.path.basename(path)[:-3] for path in glob.glob(f"{synth.ROOT}/rtl/lib/**/*.sv", recursive=True)}

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


def package(build, text):
    """The package of "dop key=value ...", a design point and what is changed in it; Failed when it is none."""
    design_point, *changes = text.split()
    settings = [*synth.design_point_settings(design_point), *changes]
    try:
        return synth.package_of(f"{build}/cpp_model/package_sv", settings)
    except Failed as failed:
        raise Failed(f"{text}: {failed}") from None


def name_of(printed):
    """The name of a configuration; printed: its package."""
    return re.search(r"Configuration: (\S+)\.", printed)[1]


def longest_paths(machine, modules, netlists):
    """{unit: FO4}: the longest path of any of its variants, and of the whole machine."""
    memories = [module for module in modules.values() if module.base == rtlil.MEMORY]
    gates = [module for module in modules.values() if module.base == rtlil.GATE]
    models = liberty.models(memories, gates, machine.library, machine.access, machine.setup)
    machine.verilog = {name: gate.verilog(name) for name, gate in netlists.items() if modules[name] not in gates}
    timed = {name: module for name, module in modules.items() if module.base in TIMED}
    parts = {
        name: [part.name for part in module.below() if part.name in machine.verilog] for name, module in timed.items()
    }
    folders = machine.jobs.each(
        "timing",
        [
            (
                name,
                sum(len(machine.verilog[part]) for part in parts[name]),
                functools.partial(machine.time, module, parts[name], models),
            )
            for name, module in timed.items()
        ],
    )
    longest = collections.defaultdict(float)
    for name, folder in folders.items():
        unit, path = TIMED[timed[name].base], timing.read(f"{folder}/log")["registers"]
        longest[unit] = max(longest[unit], path.ns / machine.fo4 if path else 0)
    return dict(sorted(longest.items()))


def point(machine, printed):
    """The lines of one configuration in both tables."""
    configuration, modules = name_of(printed), synth.elaborate(machine.jobs, printed)
    netlists = machine.netlists(modules, [synth.TOP])
    areas = {name: gate.area(machine.library) / machine.library.nand.area for name, gate in netlists.items()}
    flipflops = {name: gate.flipflops(machine.library) for name, gate in netlists.items()}
    rows = collections.defaultdict(lambda: [0, 0, 0])
    for module, unit, block, own in instances(modules):
        row = rows[unit, block]
        row[0] += own
        row[1] += areas[module.name]
        row[2] += flipflops[module.name]
    blocks = [
        f'"{configuration}",{unit},{block},{count},{nand2:.0f},{flops}'
        for (unit, block), (count, nand2, flops) in sorted(rows.items())
    ]
    paths = longest_paths(machine, modules, netlists)
    line = tables.point_line(configuration, {block for _, block in rows})
    return [line, *blocks], [line, *(f'"{configuration}",{unit},{fo4:.2f}' for unit, fo4 in paths.items())]


def measured(*paths):
    """{configuration: its lines in both tables}, and those that today's sources would give again."""
    rows = [tables.rows_of(path) for path in paths]
    lines = [tables.today(path) for path in paths]
    known = {
        name: [[line for line in (of[name][0], *of[name][1]) if line] for of in rows]
        for name in rows[0]
        if all(name in of for of in rows)
    }
    return known, {name for name in known if all(of[name][0] == now[name] for of, now in zip(rows, lines))}


def main():
    parser = argparse.ArgumentParser(
        description="Synthesises the points of the models of area and clock into synth/data/points.csv and paths.csv."
    )
    parser.add_argument(
        "--liberty", default="/usr/share/qflow/tech/osu018/osu018_stdcells.lib", help="the library, .gz too"
    )
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="programs at once")
    parser.add_argument("--build", default="build", help="build folder; holds cpp_model/package_sv")
    parser.add_argument("--out", default=f"{synth.HERE}/data/points.csv", help="the table of areas")
    parser.add_argument("--paths", default=f"{synth.HERE}/data/paths.csv", help="the table of longest paths")
    parser.add_argument("points", nargs="*", help='"POINT key=value ..."; without any those of points.txt')
    options = parser.parse_args()
    points = options.points or tables.points()
    machine = synth.Machine(
        Jobs(os.path.abspath(f"{options.build}/synth/cache"), options.jobs), liberty.Library(options.liberty), 20
    )
    names = {text: package(options.build, text) for text in points}
    names = {name_of(printed): (text, printed) for text, printed in names.items()}
    known, fresh = ({}, set()) if options.points else measured(options.out, options.paths)
    for number, (name, (text, printed)) in enumerate(names.items(), 1):
        print(f"{number} of {len(names)}: {text}{': as new as the sources' if name in fresh else ''}", flush=True)
        if name in fresh:
            continue
        known[name] = point(machine, printed)
        both = zip(*(known[name] for name in names if name in known))
        for path, head, parts in zip((options.out, options.paths), (HEAD, PATHS_HEAD), both):
            synth.write_new(path, "\n".join([head, *(line for part in parts for line in part)]) + "\n")


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # as control-C: ends what was started
    try:
        main()
    except Failed as error:
        sys.exit(f"points: {error}")
    except KeyboardInterrupt:
        sys.exit("\npoints: interrupted; what is done is kept")
