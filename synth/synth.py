#!/usr/bin/env python3
"""synth.py: the machine in gates of a liberty library: area, flip-flops and longest paths of every module.

Idea    Yosys elaborates the design once; each module (each of its parameterisations that occurs) is then a synthesis of
        its own with its submodules as black boxes. Modules are put together again for OpenSTA only.
        rtlil.py cuts the design, jobs.py runs and keeps, liberty.py knows the library, netlist.py buffers what crosses
        modules, timing.py asks OpenSTA, report.py prints.
Rule    Memories (rtl/lib/sram.sv) have no area here and a stated access time. Whatever Yosys warns of ends the run, but for
        arrays that become registers: some constructs it reads wrong with no more than a warning, others with none
        (synth/misread.sh looks for these). A latch is an error outside clock_gate.
"""
import argparse
import glob
import os
import re
import signal
import subprocess
import sys

import liberty
import netlist
import report
import rtlil
import timing
from jobs import Failed, Jobs

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(HERE)
TOP = "pipegs_top"
ENDS = 20000  # of the whole machine's paths, the longest
HARMLESS = re.compile(r"Replacing memory .* with list of registers|Whitebox|^Warning: Yosys")
# abc sees a driver and a load at the borders, so that it buffers and sizes what begins and ends at registers.
ABC = "+strash;&get,-n;&st;&dch;&nf;&put;buffer,-c,-p;topo;upsize,{D};dnsize,{D}"


def rung_settings(name):
    """The settings of a rung, from the table in sim/rung.cpp."""
    with open(f"{ROOT}/sim/rung.cpp", encoding="utf-8") as file:
        rungs = dict(re.findall(r'\{\.name = "(\w+)", ((?:\.\w+ = \d+, )+)', file.read()))
    if name not in rungs:
        raise Failed(f"unknown rung '{name}'; known: {', '.join(rungs)}")
    return re.findall(r"\.(\w+) = (\d+)", rungs[name])


def check_log(log):
    with open(log, encoding="utf-8") as file:
        for line in file:
            if line.startswith(("Warning:", "ERROR:")) and not HARMLESS.search(line):
                raise Failed("Yosys: " + line.strip())


def elaborate(jobs, package):
    """{name: rtlil.Module} of the whole machine."""
    files = sorted(path for path in glob.glob(f"{ROOT}/rtl/**/*.sv", recursive=True) if not path.endswith("/pipegs_pkg.sv"))
    sources = [package]
    for path in files:
        with open(path, encoding="utf-8") as file:
            sources.append(file.read())
    lines = f"hierarchy -check -top {TOP}\nproc\n"

    def make(folder):
        with open(f"{folder}/pipegs_pkg.sv", "w", encoding="utf-8") as file:
            file.write(package)
        misread = subprocess.run([f"{HERE}/misread.sh", *files], capture_output=True, text=True)
        with open(f"{folder}/script.ys", "w", encoding="utf-8") as file:
            file.write(f"read_verilog -sv -defer -DSYNTHESIS {folder}/pipegs_pkg.sv {' '.join(files)}\n{lines}write_rtlil {folder}/top.il\n")
        if misread.returncode != 0:
            raise Failed("Yosys reads this wrong: " + misread.stdout.splitlines()[0])
        jobs.run(["yosys", "-q", "-s", f"{folder}/script.ys"], f"{folder}/log")
        check_log(f"{folder}/log")

    folder = jobs.each("elaborate", [("design", 1, lambda: jobs.result("design", [lines] + files + sources, make))])["design"]
    return rtlil.read(f"{folder}/top.il")


class Machine:
    """All modules mapped, buffered and timed; report.py reads it."""

    def __init__(self, jobs, library, liberty_path, access_fo4):
        self.jobs, self.library, self.liberty_path = jobs, library, liberty_path
        fo4 = jobs.each("library", [("library", 1, lambda: jobs.result("library", [library.text], self._library))])["library"]
        self.folder = fo4
        with open(f"{fo4}/fo4", encoding="utf-8") as file:
            self.fo4 = float(file.read())
        self.access, self.setup = access_fo4 * self.fo4, 2 * self.fo4

    def _library(self, folder):
        with open(f"{folder}/cells.lib", "w", encoding="utf-8") as file:
            file.write(self.library.text)
        with open(f"{folder}/latch.v", "w", encoding="utf-8") as file:
            file.write(self.library.latch_map())
        with open(f"{folder}/abc.constr", "w", encoding="utf-8") as file:
            file.write(f"set_driving_cell {self.library.inverter.name}\nset_load {self.library.load * self.library.femto:.3f}\n")
        fo4 = timing.fo4(self.jobs, self.library, f"{folder}/cells.lib", folder)
        with open(f"{folder}/fo4", "w", encoding="utf-8") as file:
            file.write(f"{fo4:.5f}\n")

    def map(self, module):
        """The mapped netlist of one module."""
        text = module.text() + "".join(child.black_box() for child in module.boxes())
        library = f"-liberty {self.folder}/cells.lib"
        lines = [f"synth -noabc -nofsm -noshare -top {module.name}", f"techmap -map {self.folder}/latch.v",
                 f"dfflibmap {library}", "opt", f"abc {library} -constr {self.folder}/abc.constr -script {ABC}",
                 "setundef -zero", "opt_clean -purge"]

        def make(folder):
            with open(f"{folder}/module.il", "w", encoding="utf-8") as file:
                file.write(text)
            with open(f"{folder}/script.ys", "w", encoding="utf-8") as file:
                file.write("\n".join([f"read_rtlil {folder}/module.il"] + lines + [f"write_json {folder}/mapped.json", ""]))
            if module.base != rtlil.GATE and "cell $dlatch" in text:
                raise Failed("a latch")
            self.jobs.run(["yosys", "-q", "-s", f"{folder}/script.ys"], f"{folder}/log")
            check_log(f"{folder}/log")
            try:
                netlist.Netlist.from_yosys(f"{folder}/mapped.json", module.name, self.library).save(f"{folder}/netlist.json")
            except ValueError as error:
                raise Failed(str(error)) from None
            os.remove(f"{folder}/mapped.json")

        return self.jobs.result(module.name, [text, self.library.text] + lines[:1] + lines[2:4] + [ABC], make)

    def build(self, modules):
        """Maps and times them all: self.areas, self.flipflops, self.paths by name."""
        logic = [module for module in modules.values() if module.base != rtlil.MEMORY]
        cells = [module for module in modules.values() if module.base in (rtlil.MEMORY, rtlil.GATE)]
        mapped = self.jobs.each("synthesis", [(module.name, len(module.text()), lambda module=module: self.map(module)) for module in logic])
        self.areas, self.flipflops, loads, self.verilog = {}, {}, {}, {}
        for module in cells:
            loads[module.name] = {name: [1] * width for name, direction, width in module.ports() if direction == "input"}
        for module in reversed(modules[TOP].below()):
            self._assemble(module, mapped, loads)
        text = liberty.models([m for m in cells if m.base == rtlil.MEMORY], [m for m in cells if m.base == rtlil.GATE],
                              self.library, self.access, self.setup)
        timed = self.jobs.each("timing", [(module.name, sum(len(self.verilog.get(m.name, "")) for m in module.below()) + 1,
                                           lambda module=module: self.time(module, text)) for module in logic if module.base != rtlil.GATE])
        self.paths = {name: timing.read(f"{folder}/log") for name, folder in timed.items()}

    def _assemble(self, module, mapped, loads):
        if module.name in self.areas or module.base == rtlil.MEMORY:
            return
        for child in module.boxes():
            self._assemble(child, mapped, loads)
        gates = netlist.Netlist.load(f"{mapped[module.name]}/netlist.json")
        inner = gates.buffer(self.library, {child.name: loads[child.name] for child in module.boxes()})
        loads.setdefault(module.name, inner)
        self.areas[module.name], self.flipflops[module.name] = gates.area(self.library), gates.flipflops(self.library)
        if module.base != rtlil.GATE:
            self.verilog[module.name] = gates.verilog(module.name)

    def time(self, module, models):
        below = [m for m in module.below() if m.name in self.verilog]
        many = ENDS if module.name == TOP else 0
        has_clock = any(name == "clk_i" for name, _, _ in module.ports())

        def make(folder):
            with open(f"{folder}/models.lib", "w", encoding="utf-8") as file:
                file.write(models)
            with open(f"{folder}/netlist.v", "w", encoding="utf-8") as file:
                file.write("".join(self.verilog[m.name] for m in below))
            with open(f"{folder}/script.tcl", "w", encoding="utf-8") as file:
                file.write(timing.script(self.library, f"{self.folder}/cells.lib", f"{folder}/models.lib", f"{folder}/netlist.v", module.name, has_clock, many))
            self.jobs.run(["sta", "-no_splash", "-exit", f"{folder}/script.tcl"], f"{folder}/log")
            with open(f"{folder}/log", encoding="utf-8") as file:
                text = file.read()
            if "@end" not in text or "Error" in text:
                raise Failed("OpenSTA: " + next((line for line in text.splitlines() if "Error" in line), "no report"))
            os.remove(f"{folder}/netlist.v")
            os.remove(f"{folder}/models.lib")

        made_from = [models, self.library.text, timing.script(self.library, "", "", "", module.name, has_clock, many)]
        return self.jobs.result("time_" + module.name, made_from + [self.verilog[m.name] for m in below], make)


def main():
    parser = argparse.ArgumentParser(description="The machine in gates of a liberty library; prints and writes areas and longest paths.")
    parser.add_argument("--rung", default="", help="a rung of the ladder (sim/rung.cpp)")
    parser.add_argument("--set", default="", dest="settings", help='"key=value ...", entries of cpp_model/config.def')
    parser.add_argument("--liberty", default="/usr/share/qflow/tech/osu018/osu018_stdcells.lib", help="the library, .gz too")
    parser.add_argument("--sram-fo4", type=float, default=20, help="access time of a memory, fan-out-of-4 delays")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="programs at once")
    parser.add_argument("--build", default="build", help="build folder; holds cpp_model/package_sv")
    options = parser.parse_args()
    begin = report.now()
    settings = [f"{key}={value}" for key, value in rung_settings(options.rung)] if options.rung else []
    settings += options.settings.split()
    printed = subprocess.run([f"{options.build}/cpp_model/package_sv", *settings], capture_output=True, text=True)
    if printed.returncode != 0:
        raise Failed(printed.stderr.strip())
    configuration = ",".join(([options.rung] if options.rung else []) + options.settings.split()) or "default"
    name = os.path.basename(options.liberty).split(".")[0].replace("_stdcells", "")
    if not os.path.exists(options.liberty):
        raise Failed(f"no library {options.liberty}")
    jobs = Jobs(os.path.abspath(f"{options.build}/synth/cache"), max(1, options.jobs))
    modules = elaborate(jobs, printed.stdout)
    machine = Machine(jobs, liberty.Library(options.liberty), options.liberty, options.sram_fo4)
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
