#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""synth.py: the machine in gates of a liberty library: area, flip-flops and longest paths of every module.

Idea    Yosys elaborates the design once; each module (each of its parameterisations that occurs) is then a synthesis of
        its own with its submodules as black boxes. Modules are put together again for OpenSTA only.
        rtlil.py cuts the design, jobs.py runs and keeps, liberty.py knows the library, gating.py gates the clocks of
        flip-flops with enables, netlist.py buffers what crosses modules, timing.py asks OpenSTA, report.py prints.
Rule    Memories (rtl/lib/pipegs_sram.sv) have no area here and a stated access time. Whatever Yosys warns of ends the
        run, but for arrays that become registers: some constructs it reads wrong with no more than a warning, others
        with none (synth/misread.sh looks for these). A latch is an error outside pipegs_clock_gate.
"""
import argparse
import functools
import glob
import json
import os
import re
import signal
import subprocess
import sys

import design_points
import gates
import gating
import liberty
import netlist
import report
import rtlil
import timing
from jobs import Failed, Jobs

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(HERE)
TOP = "pipegs_top"
ENDS = 20000  # as many ends of the whole machine's longest paths are read
SETUP_FO4 = 2  # of a memory's and a clock gate's inputs
HARMLESS = re.compile(r"Replacing memory .* with list of registers|Selection .* did not match any module")
# States stay as the RTL codes them. abc sees a driver and a load at the borders, so that it buffers and sizes what
# begins and ends at registers.
ABC = "+strash;&get,-n;&st;&dch;&nf;&put;buffer,-c,-p;topo;upsize;dnsize"
MAP = """read_json {folder}/gated.json
techmap -map {library}/latch.v
dfflibmap -liberty {library}/cells.lib
opt
abc -liberty {library}/cells.lib -constr {library}/abc.constr -script {abc}
setundef -zero
opt_clean -purge
write_json {folder}/mapped.json
"""
# Small functions are mapped as a part of who uses them: a path through one is no longer than if it stood there.
FUNCTIONS = "*pipegs_saturate* *pipegs_first_set* *pipegs_bit_length*"
ELABORATE = """read_verilog -sv -defer -DSYNTHESIS {folder}/pipegs_pkg.sv {files}
hierarchy -check -top {name}
proc
check -assert
setattr -mod -set keep_hierarchy 1 *
setattr -mod -unset keep_hierarchy {functions}
flatten
hierarchy -top {name}
setattr -mod -unset keep_hierarchy *
write_rtlil {folder}/design.il
"""


def design_point_settings(name):
    """["key=value", ...] of a design point."""
    known = design_points.design_points()
    if name not in known:
        raise Failed(f"unknown design point '{name}'; known: {', '.join(known)}")
    return known[name]


def package_of(package_sv, settings):
    """The package of a configuration, as the program prints it; Failed when it is none."""
    printed = subprocess.run([package_sv, *settings], capture_output=True, text=True)
    if printed.returncode != 0:
        raise Failed(printed.stderr.strip())
    return printed.stdout


def check_log(log):
    with open(log, encoding="utf-8") as file:
        for line in file:
            if line.startswith(("Warning:", "ERROR:")) and not HARMLESS.search(line):
                raise Failed("Yosys: " + line.strip())


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def write_new(path, text):
    """Leaves a file alone that says the same already."""
    if os.path.exists(path):
        with open(path, encoding="utf-8") as file:
            if file.read() == text:
                return
    os.makedirs(os.path.dirname(path), exist_ok=True)
    write(f"{path}.new", text)
    os.replace(f"{path}.new", path)


def elaborate(jobs, package, top=TOP):
    """{name: rtlil.Module} of one module, all below it, and the clock gate that synthesis adds."""
    files = sorted(
        path for path in glob.glob(f"{ROOT}/rtl/**/*.sv", recursive=True) if not path.endswith("/pipegs_pkg.sv")
    )
    sources = [package]
    for path in files:
        with open(path, encoding="utf-8") as file:
            sources.append(file.read())

    def make(folder):
        misread = subprocess.run([f"{HERE}/misread.sh", *files], capture_output=True, text=True)
        write(f"{folder}/log", misread.stdout)
        if misread.returncode != 0:
            raise Failed("Yosys reads this wrong: " + misread.stdout.splitlines()[0])
        write(f"{folder}/pipegs_pkg.sv", package)
        write(
            f"{folder}/script.ys", ELABORATE.format(folder=folder, files=" ".join(files), name=top, functions=FUNCTIONS)
        )
        jobs.run(["yosys", "-q", "-s", f"{folder}/script.ys"], f"{folder}/log")
        check_log(f"{folder}/log")

    modules = rtlil.read(jobs.result(f"design_{top}", [ELABORATE, FUNCTIONS, top] + sources, make) + "/design.il")
    return modules if rtlil.GATE in modules else elaborate(jobs, package, rtlil.GATE) | modules


class Machine:
    """All modules mapped, buffered and timed; report.py reads it."""

    def __init__(self, jobs, library, access_fo4):
        self.jobs, self.library, self.programs = jobs, library, {}
        made_from = [library.power_text, library.latch_map(), timing.CLOCK]
        self.folder = jobs.each("library", [("library", 1, lambda: jobs.result("library", made_from, self._library))])[
            "library"
        ]
        with open(f"{self.folder}/fo4", encoding="utf-8") as file:
            self.fo4 = float(file.read())
        with open(f"{self.folder}/clock_energies", encoding="utf-8") as file:
            self.clock_energies = json.load(file)
        self.access, self.setup = access_fo4 * self.fo4, SETUP_FO4 * self.fo4

    def _library(self, folder):
        write(f"{folder}/cells.lib", self.library.text)
        write(f"{folder}/power.lib", self.library.power_text)
        write(f"{folder}/latch.v", self.library.latch_map())
        write(
            f"{folder}/abc.constr",
            f"set_driving_cell {self.library.inverter.name}\nset_load {self.library.load * self.library.femto:.3f}\n",
        )
        write(f"{folder}/fo4", f"{timing.fo4(self.jobs, self.library, folder):.5f}\n")
        energies = {
            cell.name: timing.clock_energy(self.jobs, self.library, folder, folder, *netlist.alone(cell))
            for cell in self.library.cells.values()
            if cell.is_flop and cell.clock_pin
        }
        write(f"{folder}/clock_energies", json.dumps(energies))

    def map(self, module, gate):
        """The folder with the mapped netlist of one module; gate: the clock gate."""
        children = {child.name: child for _, child in module.children}
        text = module.text() + "".join(child.black_box() for child in children.values())

        def make(folder):
            write(f"{folder}/module.il", text)
            prepare = gating.PREPARE.format(folder=folder, name=module.name)
            write(f"{folder}/prepare.ys", prepare)
            write(f"{folder}/script.ys", MAP.format(folder=folder, library=self.folder, abc=ABC))
            if module.base != rtlil.GATE and "cell $dlatch" in text:
                write(f"{folder}/log", text)
                raise Failed("a latch")
            self.jobs.run(["yosys", "-q", "-s", f"{folder}/prepare.ys"], f"{folder}/log")
            check_log(f"{folder}/log")
            enables = gating.gate_clocks(folder, module.name, gate.ports())
            write(f"{folder}/program.json", json.dumps(enables, separators=(",", ":")))
            self.jobs.run(["yosys", "-q", "-s", f"{folder}/script.ys"], f"{folder}/log")
            check_log(f"{folder}/log")
            try:
                netlist.Netlist.from_yosys(f"{folder}/mapped.json", module.name, self.library).save(
                    f"{folder}/netlist.json"
                )
            except ValueError as error:
                raise Failed(str(error)) from None
            for used in ("enables", "gated", "mapped"):
                os.remove(f"{folder}/{used}.json")

        made_from = [gating.PREPARE, str(gating.MAX_GROUP), rtlil.GATE, MAP, ABC, text]
        made_from += [self.library.text, self.library.latch_map()]
        return self.jobs.result(module.name, made_from, make)

    def netlists(self, modules, tops):
        """{name: Netlist} of the modules with these names and all below them, mapped and buffered.

        The clock gates of their enables are among the modules' children from here on."""
        gate = modules[rtlil.GATE]
        logic = {module.name: module for top in tops for module in modules[top].below() if module.base != rtlil.MEMORY}
        logic[gate.name] = gate
        mapped = self.jobs.each(
            "synthesis",
            [(name, len(module.text()), functools.partial(self.map, module, gate)) for name, module in logic.items()],
        )
        loads = {
            module.name: one_each(module) for module in modules.values() if module.base in (rtlil.MEMORY, rtlil.GATE)
        }
        netlists = {}
        for top in tops:
            self._assemble(modules[top], gate, mapped, loads, netlists)
        return netlists

    def build(self, modules):
        """Maps and times them all: self.areas, self.flipflops, self.paths by name."""
        logic = [module for module in modules.values() if module.base != rtlil.MEMORY]
        memories = [module for module in modules.values() if module.base == rtlil.MEMORY]
        gates = [module for module in logic if module.base == rtlil.GATE]
        netlists = self.netlists(modules, [TOP])
        self.mapped = netlists
        self.areas = {name: gate.area(self.library) for name, gate in netlists.items()}
        self.flipflops = {name: gate.flipflops(self.library) for name, gate in netlists.items()}
        self.clocked = {name: gate.clocked(self.library, self.clock_energies) for name, gate in netlists.items()}
        self.verilog = {name: gate.verilog(name) for name, gate in netlists.items() if modules[name] not in gates}
        models = liberty.models(memories, gates, self.library, self.access, self.setup)
        self.gate_energy = self._gate_energy(netlists[rtlil.GATE])
        parts = {
            module.name: [m.name for m in module.below() if m.name in self.verilog]
            for module in logic
            if module not in gates
        }
        timed = self.jobs.each(
            "timing",
            [
                (
                    name,
                    sum(len(self.verilog[part]) for part in parts[name]),
                    functools.partial(self.time, modules[name], parts[name], models),
                )
                for name in parts
            ],
        )
        self.paths = {name: timing.read(f"{folder}/log") for name, folder in timed.items()}

    def _assemble(self, module, gate, mapped, loads, netlists):
        """Buffers a module after all below it; loads: {module: {input: [loads of each bit]}}."""
        if module.name in netlists or module.base == rtlil.MEMORY:
            return
        netlists[module.name] = mapped_module = netlist.Netlist.load(f"{mapped[module.name]}/netlist.json")
        module.gates = [(label, gate) for label in mapped_module.gates()]
        with open(f"{mapped[module.name]}/program.json", encoding="utf-8") as file:
            self.programs[module.name] = json.load(file)
        for child in module.boxes():
            self._assemble(child, gate, mapped, loads, netlists)
        inner = mapped_module.buffer(self.library, {child.name: loads[child.name] for child in module.boxes()})
        loads.setdefault(module.name, inner)  # a clock gate keeps its ideal ones

    def _gate_energy(self, gate):
        """What the cells of a clock gate take for the clock, J of a cycle; as if it passed every edge."""
        verilog = gate.verilog(rtlil.GATE)

        def make(folder):
            energy = timing.clock_energy(self.jobs, self.library, self.folder, folder, verilog, rtlil.GATE, gate)
            write(f"{folder}/energy", f"{energy}\n")

        folder = self.jobs.result("gate_energy", [self.library.power_text, verilog, timing.CLOCK], make)
        with open(f"{folder}/energy", encoding="utf-8") as file:
            return float(file.read())

    def time(self, module, parts, models):
        """The folder with the timing of one module and all below it."""
        verilog = "".join(self.verilog[part] for part in parts)
        has_clock = any(name == "clk_i" for name, _, _ in module.ports())
        power = module.base in (*report.UNITS, TOP)

        def script(library_folder, folder):
            return timing.script(
                self.library, library_folder, folder, module.name, has_clock, ENDS if module.name == TOP else 0, power
            )

        def make(folder):
            write(f"{folder}/models.lib", models)
            write(f"{folder}/netlist.v", verilog)
            write(f"{folder}/script.tcl", script(self.folder, folder))
            self.jobs.run(["sta", "-no_splash", "-exit", f"{folder}/script.tcl"], f"{folder}/log")
            with open(f"{folder}/log", encoding="utf-8") as file:
                text = file.read()
            if "@end" not in text or "Error" in text:
                raise Failed("OpenSTA: " + next((line for line in text.splitlines() if "Error" in line), "no report"))
            os.remove(f"{folder}/netlist.v")
            os.remove(f"{folder}/models.lib")

        made_from = [models, self.library.power_text if power else self.library.text, verilog, script("", "")]
        return self.jobs.result("time_" + module.name, made_from, make)


def one_each(module):
    return {name: [1] * width for name, direction, width in module.ports() if direction == "input"}


def write_netlists(jobs, machine, package, folder, names):
    """FOLDER/NAME.v of each: those that stand in the machine without parameters from there, the others alone.

    Of a unit with parameters FOLDER/NAME.sv chooses among one .v for each of the values that the machine gives them."""
    whole = elaborate(jobs, package)
    for name in [name for name in names if name in report.UNITS]:
        variants = [module for module in whole.values() if module.base == name and module.parameters]
        if variants:
            for module in variants:
                del whole[module.name]
                module.name = rtlil.variant(module).replace("__", "_")  # Verilator gives `__` a meaning of its own
                whole[module.name] = module
            write_new(f"{folder}/{name}.sv", gates.choice(name, variants))
            names = [one for one in names if one != name] + [module.name for module in variants]
    alone = [name for name in names if name not in whole or whole[name].parameters and whole[name].base == name]
    designs = jobs.each("elaborate", [(name, 1, functools.partial(elaborate, jobs, package, name)) for name in alone])
    for modules, tops in [(whole, [name for name in names if name not in alone])] + [
        (designs[name], [name]) for name in alone
    ]:
        netlists = machine.netlists(modules, tops)
        for top in tops:
            try:
                text = gates.text(modules[top].below(), netlists, machine.library)
            except ValueError as error:
                raise Failed(f"netlist of {top}: {error}") from None
            write_new(f"{folder}/{top}.v", text)


def main():
    parser = argparse.ArgumentParser(
        description="The machine in gates of a liberty library; prints and writes areas and longest paths."
    )
    parser.add_argument("--design", default="dop", help="a design point (sim/design/design_points.def)")
    parser.add_argument("--set", default="", dest="settings", help='"key=value ...", entries of cpp_model/config.def')
    parser.add_argument(
        "--liberty", default="/usr/share/qflow/tech/osu018/osu018_stdcells.lib", help="the library, .gz too"
    )
    parser.add_argument("--sram-fo4", type=float, default=20, help="access time of a memory, fan-out-of-4 delays")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="programs at once")
    parser.add_argument("--build", default="build", help="build folder; holds cpp_model/package_sv")
    parser.add_argument(
        "--netlist",
        metavar="FOLDER",
        help="write FOLDER/MODULE.v for simulation instead: each of the modules with all below it",
    )
    parser.add_argument("modules", nargs="*", metavar="MODULE", help="with --netlist: which")
    options = parser.parse_args()
    if bool(options.netlist) != bool(options.modules):
        parser.error("--netlist FOLDER and the modules go together")
    begin = report.now()
    if not os.path.exists(options.liberty):
        raise Failed(f"no library {options.liberty}")
    settings = [*design_point_settings(options.design), *options.settings.split()]
    package = package_of(f"{options.build}/cpp_model/package_sv", settings)
    if re.search(r"\bClockGates += 0;", package):
        raise Failed("clock_gates=0 is an FPGA's machine (make fpga): its pipegs_clock_gate cannot stand for enables")
    configuration = re.search(r"Configuration: (\S+)\.", package)[1]  # as the RTL's folders are named
    name = os.path.basename(options.liberty).split(".")[0].replace("_stdcells", "")
    jobs = Jobs(os.path.abspath(f"{options.build}/synth/cache"), max(1, options.jobs))
    machine = Machine(jobs, liberty.Library(options.liberty), options.sram_fo4)
    if options.netlist:
        write_netlists(jobs, machine, package, options.netlist, options.modules)
        return
    modules = jobs.each("elaborate", [(TOP, 1, functools.partial(elaborate, jobs, package))])[TOP]
    machine.build(modules)
    report.write(machine, modules, configuration, name, f"{options.build}/synth/{configuration}/{name}", begin)


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # as control-C: ends what was started
    try:
        main()
    except Failed as error:
        sys.exit(f"synth: {error}")
    except KeyboardInterrupt:
        sys.exit("\nsynth: interrupted; what is done is kept")
