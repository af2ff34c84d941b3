#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""package_test.py [--write] BUILD: what is printed for systems on a chip is what the programs print today.

Committed   all of the default machine, its package in rtl/ and the rest in package/, and the driver's header. Each is
            compared; with --write, written.
Machines    package/machine.py gives each design point without a program, word for word what the programs print, with
            the modules that Verilator found in it (docs/data/modules.json); other settings by the programs.
Instance    its template has every port of pipegs_axi in its width: Verilator connects it to the module's header.
Waivers     of sim/rtl/waivers.vlt hold for our files alone: the same fault in another's is a warning.
Timescale   docs/integration.md names the option for systems that have one.
Errors      one line, exit code 2, and no folder.
"""
import difflib
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "package"))
import files  # noqa: E402
import machine  # noqa: E402
import machines  # noqa: E402
import ports  # noqa: E402

HEADER = "cpp_model/driver/pipegs_registers.h"
ODD = "units=1 antialias=1 world_w=32 late=1 order=2".split()  # a machine with other widths
finds = []


def output(*command, status=0):
    run = subprocess.run([*map(str, command)], cwd=ROOT, capture_output=True, text=True, check=False)
    if run.returncode != status:
        finds.append(f"{' '.join(map(str, command))}: exit code {run.returncode}, not {status}: {run.stderr}")
    return run.stdout if status == 0 else run.stderr


def held(path, text, write=False):
    """Finds a committed file that is not what is printed; or writes it."""
    path = ROOT / path
    was = path.read_text(encoding="utf-8") if path.exists() else ""
    if write and was != text:
        path.write_text(text, encoding="utf-8")
    elif was != text:
        lines = difflib.unified_diff(was.splitlines(), text.splitlines(), "committed", "printed", lineterm="", n=0)
        finds.append(f"{path} is stale: run make package\n" + "\n".join([*lines][:20]))


def committed(build, write):
    """What the programs print first, for the rest is printed from it."""
    registers = [f"{build}/cpp_model/control/print/registers_print", "header"]
    held(HEADER, output(*registers), write)
    if output(*registers) != output(*registers, *ODD):  # one driver for every machine
        finds.append(f"{HEADER} depends on the configuration")
    points = files.design_points()
    texts = {point: machines.printed(build, [*points[point], "taps=0"]) for point in points}
    for file, text in texts[machines.DEFAULT].items():
        held(machines.committed(file), text, write)
    held("package/machines.csv", machines.table(texts), write)
    printed = machine.texts_of(texts[machines.DEFAULT], machines.committed("pipegs_pkg.sv"), pathlib.Path())
    for file, text in printed.items():
        held(file if file in ("pipegs.core", "Bender.yml") else machines.committed(file), text, write)
    held("package/vivado.tcl", files.vivado(), write)
    return texts


def design_points(texts, folder):
    """Every design point by machine.py, with no build folder to ask."""
    listed = json.loads((ROOT / "docs/data/modules.json").read_text(encoding="utf-8"))
    for point, printed in texts.items():
        output(ROOT / "package/machine.py", point, "--out", f"{folder}/{point}", "--build", "/nowhere")
        for file, text in printed.items():
            held(f"{folder}/{point}/{file}", text)
        names = [
            pathlib.Path(line).stem for line in pathlib.Path(f"{folder}/{point}/pipegs.f").read_text().splitlines()
        ]
        wrong = {*names[4:]} ^ {name for name, where in listed.items() if point in where} - {"pipegs_sim"}
        if wrong:
            finds.append(f"{point}: pipegs.f and Verilator differ in {sorted(wrong)}")


def settings(build, folder):
    """Settings by words and by a file, and what is refused."""
    program = [ROOT / "package/machine.py", "--build", build, "--out"]
    pathlib.Path(f"{folder}/narrow.cfg").write_text("# a bus\nbus_w = 128\n", encoding="utf-8")
    output(*program, f"{folder}/file", "exact", f"{folder}/narrow.cfg", "units=2")
    want = machines.printed(build, [*files.design_points()["exact"], "taps=0", "bus_w=128", "units=2"])
    for file, text in want.items():
        held(f"{folder}/file/{file}", text)
    for words, said in ((["bus_w=64"], "bus_w"), (["fastest"], "'fastest' is no file"), (["nokey=1"], "nokey")):
        error = output(*program, f"{folder}/none", *words, status=2)
        if said not in error or error.count("\n") != 1 or pathlib.Path(f"{folder}/none").exists():
            finds.append(f"machine.py {words}: {error}")
    error = output(program[0], "bus_w=128", "--build", "/nowhere", "--out", f"{folder}/none", status=2)
    if "cmake --build" not in error:
        finds.append(f"machine.py without its programs: {error}")


def lint(folder, name, text, *options):
    """What Verilator warns of in a module beside our package."""
    path = pathlib.Path(folder, f"{name}.sv")
    path.write_text(text, encoding="utf-8")
    words = ["verilator", "--lint-only", "--assert", "-Wall", *options, "--top-module", name]
    words += [ROOT / "sim/rtl/waivers.vlt", f"{folder}/fast/pipegs_pkg.sv", path]
    run = subprocess.run([*map(str, words)], capture_output=True, text=True, check=False)
    return run.stderr if run.returncode else ""


def instance(folder):
    found = ports.ports(pathlib.Path(f"{folder}/fast/pipegs_pkg.sv").read_text(encoding="utf-8"))
    template = pathlib.Path(f"{folder}/fast/pipegs_axi_instance.svh").read_text(encoding="utf-8")
    if len(found) != ports.header().count("\n  input ") + ports.header().count("\n  output ") or len(found) != 57:
        finds.append(f"{len(found)} ports of pipegs_axi, not all")
    quiet = "/* verilator lint_off UNUSED */ /* verilator lint_off UNDRIVEN */ /* verilator lint_off DECLFILENAME */"
    log = lint(folder, "around", f"module around;\n{quiet}\n{template}endmodule\n{ports.header()}\n);\nendmodule\n")
    if log:
        finds.append(f"the template of an instance: {log}")


def waivers(folder):
    """An output left open, and a reset that an assertion reads, in a file of ours and in another's."""
    leaf = "module leaf_{0} (output logic o);\n  assign o = 1'b1;\nendmodule\n"
    top = "module {0} (input logic clk_i, rst_ni, d_i, output logic q_o);\n  leaf_{0} u_leaf (.o());\n"
    top += "  always_ff @(posedge clk_i or negedge rst_ni) if (!rst_ni) q_o <= 1'b0; else q_o <= d_i;\n"
    top += "  always_ff @(posedge clk_i) if (rst_ni && d_i) assert (!q_o);\nendmodule\n"
    quiet = "/* verilator lint_off DECLFILENAME */\n"
    for name in ("pipegs_ours", "foreign"):
        log = lint(folder, name, quiet + top.format(name) + leaf.format(name))
        if [rule for rule in ("PINCONNECTEMPTY", "SYNCASYNCNET") if (rule in log) != (name == "foreign")]:
            finds.append(f"waivers for {name}: {log}")


def timescale(folder):
    """Verilator wants one of our files where another has one, unless an option says it for all."""
    timed = "`timescale 1ns / 1ps\nmodule timed (input logic a_i, output logic b_o);\n  assign b_o = a_i;\nendmodule\n"
    if "TIMESCALEMOD" not in lint(folder, "timed", timed) or lint(folder, "timed", timed, "--timescale", "1ns/1ps"):
        finds.append("docs/integration.md: --timescale is not what a system with a timescale needs")


def main():
    build = pathlib.Path(sys.argv[-1]).resolve()
    texts = committed(build, "--write" in sys.argv)
    with tempfile.TemporaryDirectory() as folder:
        design_points(texts, folder)
        settings(build, folder)
        instance(folder)
        waivers(folder)
        timescale(folder)
    print("\n".join(finds) or f"{len(texts)} machines are what the programs print")
    return 1 if finds else 0


if __name__ == "__main__":
    sys.exit(main())
