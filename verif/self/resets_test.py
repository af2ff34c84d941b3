#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""resets_test.py [ROOT]: on which reset and which pins of the scan test flip-flops and clock gates hang, read from the
elaborated RTL below ROOT.

Rule    A reset is asynchronous, low, and the port rst_ni of its module, which is that of the module above, from two
        places on: pipegs_reset_sync for registers and bus, pipegs_control_restart for the core. In both a multiplexer
        of test_mode_i puts rst_ni in the place of the flip-flop, so a tester who drives aresetn owns every reset. Each
        clock gate has scan_en_i, which is scan_enable of the machine. What the core says of itself goes nowhere in
        pipegs_host but into a gate, which is closed while the core is kept apart.
"""
import glob
import json
import os
import re
import subprocess
import sys
import tempfile

ROOT = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..")
# (module, instance, port): what drives it, where that is not the port of the same name.
ELSEWHERE = {
    ("pipegs_axi", "u_reset", "rst_ni"): "aresetn",
    ("pipegs_axi", "u_reset", "test_mode_i"): "test_mode",
    ("pipegs_axi", "u_host", "rst_ni"): "u_reset.rst_no",
    ("pipegs_axi", "u_host", "test_mode_i"): "test_mode",
    ("pipegs_axi", "u_host", "scan_en_i"): "scan_enable",
    ("pipegs_axi", "u_manager", "rst_ni"): "u_reset.rst_no",
    ("pipegs_host", "u_core", "rst_ni"): "u_restart.core_rst_no",
}
GATED = ("mem_valid_o", "done_o", "busy_o", "error_o", "frame_ready_o")
BYPASSED = {"pipegs_reset_sync": "rst_no", "pipegs_control_restart": "core_rst_no"}


def modules():
    files = sorted(file for file in glob.glob(f"{ROOT}/rtl/**/*.sv", recursive=True) if "pipegs_pkg" not in file)
    with tempfile.TemporaryDirectory() as folder:
        script = f"""read_verilog -sv -defer -DSYNTHESIS {ROOT}/rtl/pipegs_pkg.sv {" ".join(files)}
            hierarchy -check -top pipegs_axi; proc; opt_clean; write_json {folder}/machine.json"""
        subprocess.run(["yosys", "-q", "-w", "Replacing memory", "-p", script], check=True)
        with open(f"{folder}/machine.json", encoding="utf-8") as file:
            return json.load(file)["modules"]


def base(name):
    return name.split("\\")[1] if name.startswith("$paramod") else name


def drivers(module, all_modules):
    """{bit: what drives it}: a port by its name, an instance's output as INSTANCE.PORT."""
    found = {bits["bits"][0]: name for name, bits in module["ports"].items() if bits["direction"] == "input"}
    for instance, cell in module["cells"].items():
        if cell["type"] in all_modules:
            for port, bits in cell["connections"].items():
                if cell["port_directions"][port] == "output" and bits:
                    found[bits[0]] = f"{instance}.{port}"
    return found


def ungated(host, all_modules):
    """Outputs of the core that reach a part of the host, or a port of it, as they are."""
    core = host["cells"]["u_core"]["connections"]
    ends = {name: port["bits"] for name, port in host["ports"].items() if port["direction"] == "output"}
    for instance, cell in host["cells"].items():
        if cell["type"] in all_modules and instance != "u_core":
            ends.update({f"{instance}.{port}": bits for port, bits in cell["connections"].items()})
    return [
        f"pipegs_host: {port} of the core reaches {end} ungated"
        for port in GATED
        for end, bits in ends.items()
        if set(core[port]) & set(bits)
    ]


def main():
    machine = modules()
    wrong, registers, gates, bypassed = [], 0, 0, set()
    for name, module in machine.items():
        known, short = drivers(module, machine), base(name)
        if short == "pipegs_host":
            wrong += ungated(module, machine)
        for instance, cell in module["cells"].items():
            pins = cell["connections"]
            if cell["type"] in machine:
                gates += base(cell["type"]) == "pipegs_clock_gate"
                for port in {"rst_ni", "test_mode_i", "scan_en_i"} & set(pins):
                    driver, wanted = known.get(pins[port][0]), ELSEWHERE.get((short, instance, port), port)
                    if driver != wanted:
                        wrong.append(f"{short}.{instance}.{port} hangs on {driver}, not on {wanted}")
            elif re.match(r"\$(adff|aldff|dffsr|sr)", cell["type"]):
                registers += 1
                if known.get(pins.get("ARST", [None])[0]) != "rst_ni" or int(cell["parameters"]["ARST_POLARITY"], 2):
                    wrong.append(f"{short}: a register {instance} whose reset is not rst_ni, low")
            elif cell["type"] == "$mux" and pins["Y"] == module["ports"].get(BYPASSED.get(short), {}).get("bits"):
                if [known.get(pins["S"][0]), known.get(pins["B"][0])] == ["test_mode_i", "rst_ni"]:
                    bypassed.add(short)
    wrong += [f"{short}: no test_mode_i puts rst_ni on {BYPASSED[short]}" for short in set(BYPASSED) - bypassed]
    if registers < 300 or gates < 10:
        wrong.append(f"only {registers} registers with a reset and {gates} clock gates were found")
    for line in wrong:
        print(line)
    print(f"{registers} registers with a reset, {gates} clock gates, {len(wrong)} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
