#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""gating_test.py: synth/gating.py on small modules, by Yosys: which flip-flops get a gate, and the functions of their
enables, evaluated against the RTL's own expressions."""
import itertools
import json
import os
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../synth"))
import gating  # noqa: E402

PORTS = [
    ("clk_i", "input", 1),
    ("rst_ni", "input", 1),
    ("scan_en_i", "input", 1),
    ("enable_i", "input", 1),
    ("clk_o", "output", 1),
]
HEAD = "module m (input clk_i, rst_ni, a, b, c, input [99:0] d, output logic [99:0] q_q, output logic [7:0] r_q);\n"


def gated(body):
    """(the module in gated.json, its Program) of a SystemVerilog body."""
    with tempfile.TemporaryDirectory() as folder:
        with open(f"{folder}/m.sv", "w", encoding="utf-8") as file:
            file.write(HEAD + body + "\nendmodule\n")
        with open(f"{folder}/prepare.ys", "w", encoding="utf-8") as file:
            file.write(gating.PREPARE.format(folder=folder, name="m"))
        read = f"read_verilog -sv {folder}/m.sv; hierarchy -top m; proc; write_rtlil {folder}/module.il"
        subprocess.run(["yosys", "-q", "-p", read], check=True)
        subprocess.run(["yosys", "-q", "-s", f"{folder}/prepare.ys"], check=True)
        program = gating.gate_clocks(folder, "m", PORTS)
        with open(f"{folder}/gated.json", encoding="utf-8") as file:
            return json.load(file)["modules"]["m"], program


def clocks(module):
    """{gate or "": flip-flops}"""
    gates = {cell["connections"]["clk_o"][0]: name for name, cell in module["cells"].items() if name[:5] == "gate_"}
    counts = {}
    for cell in module["cells"].values():
        if cell["type"].startswith("$_DFF"):
            name = gates.get(cell["connections"]["C"][0], "")
            counts[name] = counts.get(name, 0) + 1
    return counts


def evaluate(program, node, values):
    """A node's value; values: {leaf's name: value}."""
    nodes = [0, 1] + [values[name] >> bit & 1 for name, bit in program["leaves"]]
    for what, *inputs in program["operations"]:
        a, b, c = ([nodes[i] for i in inputs] + [0, 0])[:3]
        nodes.append(
            {"and": a & b, "or": a | b, "xor": a ^ b, "xnor": 1 - (a ^ b), "not": 1 - a, "mux": b if a else c}[what]
        )
    return nodes[node]


class Gating(unittest.TestCase):
    def expect_enables(self, program, wanted):
        """wanted: [(function of a, b, c)], in any order."""
        bits = list(itertools.product((0, 1), repeat=3))
        found = {
            tuple(evaluate(program, enable, {"a": a, "b": b, "c": c, "q_q": 0, "r_q": 0}) for a, b, c in bits)
            for enable, _ in program["gates"]
        }
        self.assertEqual(found, {tuple(int(function(a, b, c)) for a, b, c in bits) for function in wanted})

    def test_wide_register_gets_several_gates(self):
        module, program = gated("always_ff @(posedge clk_i) if (a && !b) q_q <= d; assign r_q = '0;")
        self.assertEqual(clocks(module), {"gate_0": gating.MAX_GROUP, "gate_1": 100 - gating.MAX_GROUP})
        self.expect_enables(program, [lambda a, b, c: a and not b])
        self.assertEqual({program["leaves"][held - 2][0] for _, held in program["gates"]}, {"q_q"})

    def test_few_flipflops_get_none(self):
        module, program = gated(
            f"always_ff @(posedge clk_i) if (a) r_q[{gating.MIN_GROUP - 2}:0] <= d[{gating.MIN_GROUP - 2}:0];"
            f"assign q_q = '0; assign r_q[7:{gating.MIN_GROUP - 1}] = '0;"
        )
        self.assertEqual(clocks(module), {"": gating.MIN_GROUP - 1})
        self.assertEqual(program["gates"], [])

    def test_register_that_is_cleared_or_loaded_is_clocked_for_both(self):
        module, program = gated(
            "always_ff @(posedge clk_i or negedge rst_ni) if (!rst_ni) r_q <= '0;"
            " else if (a) r_q <= '0; else if (b && c) r_q <= d[7:0]; assign q_q = '0;"
        )
        self.assertEqual(clocks(module), {"gate_0": 8})
        self.expect_enables(program, [lambda a, b, c: a or (b and c)])

    def test_shared_multiplexer_hides_no_enable(self):  # as in rtl/lib/pipegs_skid.sv
        module, program = gated(
            "always_ff @(posedge clk_i) begin if (!a) r_q <= d[7:0]; if (b) q_q[7:0] <= a ? r_q : d[7:0]; end"
            " assign q_q[99:8] = '0;"
        )
        self.assertEqual(clocks(module), {"gate_0": 8, "gate_1": 8})
        self.expect_enables(program, [lambda a, b, c: not a, lambda a, b, c: b])

    def test_free_register_gets_none(self):
        module, program = gated("always_ff @(posedge clk_i) q_q <= d; assign r_q = '0;")
        self.assertEqual(clocks(module), {"": 100})
        self.assertEqual(program["gates"], [])

    def test_what_has_no_name_is_not_said(self):
        module = {"cells": {}, "netnames": {"a": {"hide_name": 0, "bits": [2]}, "n": {"hide_name": 1, "bits": [3]}}}
        cell = {"type": "$_AND_", "connections": {"A": [2], "B": [3], "Y": [4]}}
        flop = {"connections": {"Q": [5]}}
        module["cells"]["g"] = cell
        program = gating.Program(module, [(9, 4, [flop]), (9, 2, [flop])])
        self.assertEqual(program.gates, [[None, None], [2, None]])


if __name__ == "__main__":
    unittest.main()
