# SPDX-License-Identifier: Apache-2.0
"""gating.py: flip-flops that share an enable get one gated clock, as a commercial flow does.

Idea    Yosys finds what holds a flip-flop (opt_dff) and leaves an enable where MIN_GROUP flip-flops or more share it;
        the others get a multiplexer. Here each enable becomes an instance of rtl/lib/pipegs_clock_gate.sv before the
        library's gates are chosen, so that those behind an enable are mapped, timed and counted like all others.
        A gate drives at most MAX_GROUP flip-flops; the next ones of the same enable get a gate of their own.
Rule    How often an enable is high is measured in the RTL's waves: a Program says each enable as a function of signals
        that have a name there. It stops at the first name on the way back from the enable. An enable that it cannot
        say is None: its flip-flops count as always clocked.
"""
import json
import re

import rtlil

MIN_GROUP = 4
MAX_GROUP = 64
ENABLED = re.compile(r"\$_DFFE_P(N[01])?P_$")  # a flip-flop with an enable, as PREPARE leaves it
# Enables before anything is shared (a shared multiplexer holds no register), and before resets to constants: a register
# that is cleared or loaded is clocked when either happens.
PREPARE = f"""read_rtlil {{folder}}/module.il
opt_expr
opt_clean
opt_dff -nosdff
opt -nodffe -nosdff
opt_dff -nosdff
opt_clean
synth -noabc -nofsm -noshare -top {{name}}
dfflegalize -mince {MIN_GROUP} -cell $_DFF_P_ x -cell $_DFF_PN?_ x -cell $_DFFE_PP_ x -cell $_DFFE_PN?P_ x \
  -cell $_DLATCH_?_ x
opt_merge
opt_clean
write_json {{folder}}/enables.json
"""
GATES = {  # Yosys' gates of one bit: the operation of a Program, and its inputs
    "$_AND_": ("and", "AB"),
    "$_OR_": ("or", "AB"),
    "$_XOR_": ("xor", "AB"),
    "$_XNOR_": ("xnor", "AB"),
    "$_NOT_": ("not", "A"),
    "$_MUX_": ("mux", "SBA"),  # S ? B : A
}
PLAIN = re.compile(r"[A-Za-z_]\w*(\[\d+\])?(\.[A-Za-z_]\w*(\[\d+\])?)*$")  # a name as waves have it


class Program:
    """The enables of a module's gates, for the evaluator in sim/silicon/energy/enables.hpp.

    leaves [[name, bit]] and operations [[what, node, ...]]: nodes 0 and 1 are constants, then leaves, then these.
    gates [[node of the enable, node of one bit that is clocked]], None where it cannot be said."""

    def __init__(self, module, groups):
        self.leaves, self.operations = [], []
        self._names, self._nodes = _names(module), {"0": 0, "1": 1, "x": 0, "z": 0}
        cells = [cell for cell in module["cells"].values() if cell["type"] in GATES]
        self._drivers = {cell["connections"]["Y"][0]: cell for cell in cells}
        cones = [self._cone(enable) for _, enable, _ in groups]
        order = list(dict.fromkeys(bit for cone in cones for bit in cone or ()))
        held = [
            next((bit for cell in cells for bit in cell["connections"]["Q"] if bit in self._names), None)
            for _, _, cells in groups
        ]
        for bit in [bit for bit in order + held if bit in self._names]:
            self._nodes[bit] = 2 + len(self.leaves)
            self.leaves.append(list(self._names[bit]))
        for bit in [bit for bit in order if bit not in self._nodes]:
            self.operations.append([GATES[self._drivers[bit]["type"]][0]] + [self._nodes[a] for a in self._inputs(bit)])
            self._nodes[bit] = 1 + len(self.leaves) + len(self.operations)
        self.gates = [
            [None if cone is None else self._nodes[enable], self._nodes.get(bit)]
            for cone, (_, enable, _), bit in zip(cones, groups, held)
        ]

    def _inputs(self, bit):
        cell = self._drivers[bit]
        return [cell["connections"][pin][0] for pin in GATES[cell["type"]][1]]

    def _cone(self, enable):
        """Leaves and gates behind an enable, each after its inputs; None when one has neither a name nor a gate."""
        order, stack, found = [], [(enable, False)], set()
        while stack:
            bit, done = stack.pop()
            if done:
                order.append(bit)
            elif isinstance(bit, int) and bit not in found:
                found.add(bit)
                stack.append((bit, True))
                if bit not in self._names:
                    if bit not in self._drivers:
                        return None
                    stack += [(below, False) for below in self._inputs(bit)]
        return order


def _names(module):
    """{bit: (name, place)} of all that the RTL names; registers first, then the shortest name."""
    names = {}
    for name, body in sorted(
        module["netnames"].items(), key=lambda item: (not item[0].endswith("_q"), len(item[0]), item[0])
    ):
        if not body["hide_name"] and PLAIN.match(name):
            for place, bit in enumerate(body["bits"]):
                names.setdefault(bit, (name, place))
    return names


def _groups(module):
    """[(clock, enable, cells)], at most MAX_GROUP cells each."""
    found = {}
    for cell in module["cells"].values():
        if ENABLED.match(cell["type"]):
            pins = cell["connections"]
            found.setdefault((pins["C"][0], pins["E"][0]), []).append(cell)
    return [
        (clock, enable, cells[at : at + MAX_GROUP])
        for (clock, enable), cells in found.items()
        for at in range(0, len(cells), MAX_GROUP)
    ]


def gate_clocks(folder, name, ports):
    """enables.json -> gated.json, the same with gated clocks, and the Program of their enables.

    ports: those of the clock gate. Gate number i of the Program is the instance gate_i."""
    with open(f"{folder}/enables.json", encoding="utf-8") as file:
        design = json.load(file)
    module = design["modules"][name]
    groups = _groups(module)
    program = Program(module, groups)
    fresh = 1 + max(
        (bit for body in module["netnames"].values() for bit in body["bits"] if isinstance(bit, int)), default=1
    )
    for number, (clock, enable, cells) in enumerate(groups):
        pins = {"clk_i": [clock], "rst_ni": ["1"], "scan_en_i": ["0"], "enable_i": [enable], "clk_o": [fresh + number]}
        module["cells"][f"gate_{number}"] = {
            "hide_name": 0,
            "type": rtlil.GATE,
            "parameters": {},
            "attributes": {},
            "port_directions": {port: direction for port, direction, _ in ports},
            "connections": pins,
        }
        for cell in cells:
            cell["type"] = f"$_DFF_P{ENABLED.match(cell['type'])[1] or ''}_"
            del cell["connections"]["E"], cell["port_directions"]["E"]
            cell["connections"]["C"] = pins["clk_o"]
    if groups:
        box = {port: {"direction": direction, "bits": [2 + i]} for i, (port, direction, _) in enumerate(ports)}
        design["modules"][rtlil.GATE] = {"attributes": {"blackbox": "1"}, "ports": box, "cells": {}, "netnames": {}}
    with open(f"{folder}/gated.json", "w", encoding="utf-8") as file:
        json.dump(design, file, separators=(",", ":"))
    return {"leaves": program.leaves, "operations": program.operations, "gates": program.gates}
