#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""fpga.py: the machine in the cells of an FPGA: look-up tables, flip-flops, multipliers and block RAM of every unit.

Idea    Yosys elaborates the machine once, with clock_gates=0 and taps=0; each module (each of its parameterisations
        that occurs) is then mapped by itself with its submodules as black boxes, and kept under the hash of its own
        text. What a machine shares with one of fewer units, or with another design point, is mapped once.
        Elaboration and cache are those of synth.py; memories (rtl/lib/pipegs_sram.sv) are modules like all others here.
Rule    A latch is an error, and so is whatever Yosys warns of but for arrays that become registers and the unused high
        address bits of a block RAM. Counts are cells of the netlist: nothing is placed, routed or timed.
"""
import argparse
import collections
import functools
import json
import os
import re
import signal
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))  # synth/
import rtlil  # noqa: E402
import synth  # noqa: E402
from jobs import Failed, Jobs  # noqa: E402
from report import UNITS  # noqa: E402

TOP = "pipegs_axi"
HARMLESS = re.compile(synth.HARMLESS.pattern + r"|Resizing cell port \S+ from \d+ bits to \d+ bits")
FLOWS = {
    "xcup": "synth_xilinx -family xcup -noiopad -noclkbuf",
    "ecp5": "synth_ecp5",
}
MAP = """read_rtlil {folder}/module.il
{flow} -top {name}
tee -q -o {folder}/stat.json stat -json
"""
# Look-up tables that one cell takes. Those of distributed RAM: in an UltraScale+ the LUTs that it is made of, in an
# ECP5 three slices for sixteen words of four bits.
LUTS = {
    **{f"LUT{inputs}": 1 for inputs in range(1, 7)}, "INV": 1, "SRL16E": 1, "SRLC32E": 1,
    "LUT4": 1, "CCU2C": 2,
}  # fmt: skip
DISTRIBUTED = {
    "RAM32X1D": 2, "RAM64X1D": 2, "RAM128X1D": 4, "RAM256X1D": 8, "RAM32M": 4, "RAM64M": 4, "RAM32M16": 8,
    "RAM64M8": 8, "TRELLIS_DPR16X4": 6,
}  # fmt: skip
BLOCKS = {"RAMB18E2": 1, "RAMB36E2": 2, "DP16KD": 1}  # of 18 Kb
MULTIPLIERS = {"DSP48E2": 1, "MULT18X18D": 1}
FLIPFLOP = re.compile(r"FD[RSCP]E(_1)?$|TRELLIS_FF$")
FREE = re.compile(r"CARRY[48]$|MUXF[789]$|PFUMX$|L6MUX21$|VCC$|GND$")
LATCH = re.compile(r"LD[CP]E(_1)?$|\$_?DLATCH", re.IGNORECASE)
KINDS = ("luts", "distributed", "flipflops", "multipliers", "blocks")
# What the parts have, by their makers' tables (AMD DS891); block RAM in halves of 36 Kb.
PARTS = {
    "ZU7EV": {"luts": 230400, "flipflops": 460800, "multipliers": 1728, "blocks": 624},
    "ZU9EG": {"luts": 274080, "flipflops": 548160, "multipliers": 2520, "blocks": 1824},
}
NAMES = UNITS | {"pipegs_axi_manager": "bus", "pipegs_control_registers": "control"}
ORDER = ("dopu", "pu", "su", "ru", "buf", "list", "bus", "control", "rest")


def counts_of(cells):
    """What a module's cells take: {cell: how many} -> {kind of resource: how many}."""
    found = dict.fromkeys(KINDS, 0)
    for cell, number in cells.items():
        found["luts"] += number * (LUTS.get(cell, 0) + DISTRIBUTED.get(cell, 0))
        found["distributed"] += number * DISTRIBUTED.get(cell, 0)
        found["flipflops"] += number * bool(FLIPFLOP.match(cell))
        found["multipliers"] += number * MULTIPLIERS.get(cell, 0)
        found["blocks"] += number * BLOCKS.get(cell, 0)
        if LATCH.match(cell):
            raise Failed(f"a latch, {cell}")
        known = (*LUTS, *DISTRIBUTED, *MULTIPLIERS, *BLOCKS)
        if cell not in known and not FLIPFLOP.match(cell) and not FREE.match(cell):
            raise Failed(f"an unknown cell {cell}")
    return found


def check_log(log):
    with open(log, encoding="utf-8") as file:
        for line in file:
            if line.startswith(("Warning:", "ERROR:")) and not HARMLESS.search(line):
                raise Failed("Yosys: " + line.strip())


def map_module(jobs, module, family):
    """{kind of resource: how many} of one module without its submodules."""
    children = {child.name: child for _, child in module.children}
    text = module.text() + "".join(child.black_box() for child in children.values())

    def make(folder):
        synth.write(f"{folder}/module.il", text)
        synth.write(f"{folder}/script.ys", MAP.format(folder=folder, flow=FLOWS[family], name=module.name))
        jobs.run(["yosys", "-q", "-s", f"{folder}/script.ys"], f"{folder}/log")
        check_log(f"{folder}/log")
        with open(f"{folder}/stat.json", encoding="utf-8") as file:
            cells = json.load(file)["modules"]["\\" + module.name]["num_cells_by_type"]
        own = {cell.lstrip("\\"): number for cell, number in cells.items() if cell.lstrip("\\") not in children}
        synth.write(f"{folder}/counts.json", json.dumps(counts_of(own)))

    folder = jobs.result(f"{family}_{module.name}", [MAP, FLOWS[family], text, repr((LUTS, DISTRIBUTED, BLOCKS))], make)
    with open(f"{folder}/counts.json", encoding="utf-8") as file:
        return json.load(file)


def walk(module, unit="rest"):
    """(module, unit) of every instance below, itself first."""
    yield module, unit
    for _, child in module.children:
        yield from walk(child, NAMES.get(child.base, unit) if unit == "rest" else unit)


def measure(jobs, modules, top, family):
    """{unit: {count, resources of all of them}} of what stands below the top, and their total."""
    used = modules[top].below()
    mapped = jobs.each(
        family,
        [(f"{family}_{m.name}", len(m.text()), functools.partial(map_module, jobs, m, family)) for m in used],
    )
    units, instances = collections.defaultdict(collections.Counter), collections.Counter()
    for module, unit in walk(modules[top]):
        units[unit].update(mapped[f"{family}_{module.name}"])
        instances[unit] += NAMES.get(module.base) == unit
    rows = {
        unit: {"count": max(1, instances[unit])} | {kind: units[unit][kind] for kind in KINDS}
        for unit in ORDER
        if unit in units
    }
    return rows | {"total": {"count": 1} | {kind: sum(row[kind] for row in rows.values()) for kind in KINDS}}


def fits(total):
    """{part: share of its scarcest resource that the machine takes}"""
    return {name: max(total[kind] / has for kind, has in part.items()) for name, part in PARTS.items()}


def table(title, rows, family):
    lines = [
        title,
        f"{'unit':8} {'count':>5} {'LUT':>8} {'of RAM':>7} {'FF':>8} {'mult.':>6} {'RAM, 18 Kb':>10}  all in a row",
    ]
    for unit, row in rows.items():
        lines.append(
            f"{unit:8} {row['count']:5} {row['luts']:8} {row['distributed']:7} {row['flipflops']:8} "
            f"{row['multipliers']:6} {row['blocks']:10}"
        )
    if "total" in rows and family == "xcup":
        lines += [f"{name}: {100 * share:.0f} % of what is scarcest" for name, share in fits(rows["total"]).items()]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description="The machine in cells of an FPGA; prints and writes what it takes.")
    parser.add_argument("--design", default="fast", help="a design point (sim/design/design_points.def)")
    parser.add_argument("--set", default="", dest="settings", help='"key=value ...", entries of cpp_model/config.def')
    parser.add_argument("--units", default="1,2,4", help="machines of so many units, one after another")
    parser.add_argument("--families", default=",".join(FLOWS), help="xcup (UltraScale+), ecp5")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="programs at once")
    parser.add_argument("--build", default="build", help="build folder; holds cpp_model/package_sv")
    parser.add_argument("--json", action="store_true", help="print fpga.json instead of the tables")
    parser.add_argument("modules", nargs="*", metavar="MODULE", help="only these modules, each with all below it")
    options = parser.parse_args()
    families = options.families.split(",")
    for family in families:
        if family not in FLOWS:
            raise Failed(f"unknown family '{family}'; known: {', '.join(FLOWS)}")
    jobs = Jobs(os.path.abspath(f"{options.build}/synth/fpga"), max(1, options.jobs))
    result = []
    for units in options.units.split(","):
        settings = [*synth.design_point_settings(options.design), f"units={units}", *options.settings.split()]
        text = synth.package_of(f"{options.build}/cpp_model/package_sv", [*settings, "clock_gates=0", "taps=0"])
        for top in options.modules or [TOP]:
            modules = jobs.each("elaborate", [(top, 1, functools.partial(synth.elaborate, jobs, text, top))])[top]
            for family in families:
                rows = measure(jobs, modules, top, family)
                if options.modules:
                    rows = {top: rows["total"]}
                entry = {"design_point": options.design, "units": int(units), "family": family, "rows": rows}
                result.append(entry)
                if not options.json:
                    print(table(f"{options.design}, units={units}, {family}", rows, family), flush=True)
    text = json.dumps(result, indent=1) + "\n"
    if options.json:
        print(text, end="")
    if not options.modules:
        folder = f"{options.build}/synth/fpga"
        synth.write(f"{folder}/fpga_{options.design}.json", text)


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # as control-C: ends what was started
    try:
        main()
    except Failed as error:
        sys.exit(f"fpga: {error}")
    except KeyboardInterrupt:
        sys.exit("\nfpga: interrupted; what is done is kept")
