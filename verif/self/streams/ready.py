#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""ready.py BUILD [ROOT [SETTINGS]]: in no module does the valid of a stream depend on a ready in the same cycle.

Idea    Yosys elaborates machines that have nearly every module between them. Within a module each output X_valid_o is
        followed back through logic, not through registers, and through instances by what was found in them. Where it
        arrives at an input Y_ready_i, valid waits for ready, unless X_valid_o has no ready (a pulse) and is no stream.
Output  Such pairs, then how many streams were followed; exits 1 when there is a pair, or hardly any stream.
"""
import json
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[3] / "synth"))
from design_points import design_points  # noqa: E402
from elaborate import ROOT, elaborated  # noqa: E402

# tspp and dpc are read here in place of synth/lint.sh, dop and fast by verif/cli/static_cost_test.cpp, too.
POINTS = ["dop", "tspp", "dpc", "fast"]
MACHINES = [("pipegs_top", design_points()[name]) for name in POINTS]
MACHINES += [("pipegs_axi_manager", []), ("pipegs_control_registers", [])]
REGISTERS = re.compile(r"\$(a|s|al)?dff|\$(a|d)?latch|\$mem")


def bits(wires):
    return [bit for bit in wires if isinstance(bit, int)]


class Follower:
    def __init__(self, modules):
        self.modules, self.found = modules, {}

    def sources_of_cell(self, cell):
        """Yields (bit, the bits on which it depends in the same cycle)."""
        wires, kind = cell["connections"], cell["type"]
        if kind in self.modules:
            for (port, i), sources in self.of(kind).items():
                if port in wires and i < len(wires[port]):
                    yield wires[port][i], bits(wires[p][j] for p, j in sources if p in wires and j < len(wires[p]))
            return
        if REGISTERS.match(kind):
            return
        inputs = [p for p, direction in cell["port_directions"].items() if direction == "input"]
        for port, direction in cell["port_directions"].items():
            if direction != "output":
                continue
            for i, bit in enumerate(wires[port]):
                if kind in ("$and", "$or", "$xor", "$xnor", "$not", "$mux", "$pmux"):
                    yield bit, bits(b for p in inputs for b in self.lane(wires[p], p, i, len(wires[port])))
                else:
                    yield bit, bits(b for p in inputs for b in wires[p])

    @staticmethod
    def lane(wires, port, i, width):
        """Of an input of a bitwise cell what bit i of its output sees."""
        return wires if port == "S" else wires[i::width] if i < len(wires) else wires[-1:]

    def of(self, name):
        """(port, bit) of the outputs of a module -> the inputs on which each depends in the same cycle."""
        if name in self.found:
            return self.found[name]
        module = self.modules[name]
        driven = {}
        for cell in module["cells"].values():
            driven.update(self.sources_of_cell(cell))
        inputs = {}
        for port, what in module["ports"].items():
            if what["direction"] == "input":
                inputs.update({bit: (port, i) for i, bit in enumerate(what["bits"])})
        result = {}
        for port, what in module["ports"].items():
            for i, bit in enumerate(what["bits"] if what["direction"] == "output" else []):
                todo, seen = [bit], set()
                while todo:
                    at = todo.pop()
                    if at not in seen:
                        seen.add(at)
                        todo += driven.get(at, [])
                result[port, i] = {inputs[at] for at in seen if at in inputs}
        self.found[name] = result
        return result


def plain(name):
    """The module of a name that Yosys gave to one with parameters."""
    return re.sub(r"^\$paramod(\$[0-9a-f]+)?\\", "", name).split("\\")[0]


def main():
    build, root = sys.argv[1], Path(sys.argv[2] if len(sys.argv) > 2 else ROOT).resolve()
    store = None if root == ROOT else root / "elaborated"
    streams, wrong = set(), set()
    for top, settings in [("pipegs_top", sys.argv[3].split())] if len(sys.argv) > 3 else MACHINES:
        folder = elaborated(build, settings, top, root, store)
        modules = json.loads((folder / "proc.json").read_text(encoding="utf-8"))["modules"]
        follower = Follower(modules)
        for name, module in modules.items():
            for (port, _), sources in follower.of(name).items():
                ready = re.sub(r"valid(_o)?$", lambda match: "ready_i" if match[1] else "ready", port)
                if ready == port or ready not in module["ports"]:
                    continue
                streams.add((plain(name), port))
                late = {source for source, _ in sources if re.search(r"ready(_i)?$", source)}
                wrong |= {f"{plain(name)}: {port} depends on {source}" for source in late}
    print(*sorted(wrong), f"{len(streams)} streams followed", sep="\n")
    return 1 if wrong or len(streams) < 100 else 0


sys.exit(main())
