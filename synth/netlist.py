# SPDX-License-Identifier: Apache-2.0
"""netlist.py: one module after mapping: counted, its large nets buffered, written for OpenSTA.

Idea    Yosys' JSON says which bits meet at which pins; that is all there is to a netlist. A flip-flop is named after
        the signal that it holds, so that a path reads as the RTL does.
Rule    abc buffers the nets of a module's own gates. What it does not see are nets into submodules and from flip-flop
        to flip-flop: a net with more than FANOUT loads gets a tree of buffers, where a submodule's pin counts as many
        loads as it has inside (at most FANOUT). Clock and reset stay ideal.
"""
import json

import rtlil

FANOUT = 10
IDEAL = ("clk_i", "rst_ni")


class Netlist:
    """ports {name: (direction, bits)}, cells [[type, name, {pin: bits}]], bits are numbers or "0", "1"."""

    def __init__(self, ports, cells):
        self.ports, self.cells = ports, cells

    @classmethod
    def from_yosys(cls, path, name, library):
        """The module from Yosys' JSON; a cell that is neither of the library nor a module raises ValueError."""
        with open(path, encoding="utf-8") as file:
            design = json.load(file)["modules"]
        module = design[name]
        names = {}
        for net, body in sorted(
            module["netnames"].items(), key=lambda item: (not item[0].endswith("_q"), len(item[0]))
        ):
            if not body["hide_name"]:
                for i, bit in enumerate(body["bits"]):
                    names.setdefault(bit, net if len(body["bits"]) == 1 else f"{net}[{i}]")
        cells = []
        for number, (cell, body) in enumerate(module["cells"].items()):
            kind = body["type"]
            pins = {
                pin: ["0" if bit in ("x", "z") else bit for bit in bits] for pin, bits in body["connections"].items()
            }
            if kind not in library.cells and kind not in design:
                raise ValueError(f"{kind} was not mapped")
            if kind in design:
                label = cell
            elif library.cells[kind].is_flop or library.cells[kind].latch:
                outputs = [
                    names[pins[pin][0]]
                    for pin in library.cells[kind].outputs
                    if pins.get(pin) and pins[pin][0] in names
                ]
                label = outputs[0] if outputs else f"flop{number}"
            else:
                label = f"g{number}"
            cells.append([kind, label, pins])
        return cls({port: (body["direction"], body["bits"]) for port, body in module["ports"].items()}, cells)

    @classmethod
    def load(cls, path):
        with open(path, encoding="utf-8") as file:
            return cls(*json.load(file))

    def save(self, path):
        with open(path, "w", encoding="utf-8") as file:
            json.dump([self.ports, self.cells], file, separators=(",", ":"))

    def area(self, library):
        return sum(library.cells[kind].area for kind, _, _ in self.cells if kind in library.cells)

    def flipflops(self, library):
        return sum(kind in library.cells and library.cells[kind].is_flop for kind, _, _ in self.cells)

    def load_of(self, port, library):
        """Of all pins on a port's net, in the library's unit of capacitance."""
        nets = self.ports[port][1]
        pins = [(library.cells[kind], pin, bits) for kind, _, pins in self.cells for pin, bits in pins.items()]
        return sum(cell.inputs.get(pin, 0) for cell, pin, bits in pins if bits[0] in nets)

    def gates(self):
        """The instances of the clock gates that gating.py made: they have no reset."""
        return [label for kind, label, pins in self.cells if kind == rtlil.GATE and pins["rst_ni"] == ["1"]]

    def clocked(self, library, energies):
        """{clock gate: (flip-flops, J of a cycle)}, energies by kind of cell; without a gate of gating.py under ""."""
        gates = set(self.gates())
        gate_of = {pins["clk_o"][0]: label for _, label, pins in self.cells if label in gates}
        found = {label: (0, 0.0) for label in ["", *gate_of.values()]}
        for kind, _, pins in self.cells:
            if kind in energies:
                label = gate_of.get(pins[library.cells[kind].clock_pin][0], "")
                count, joules = found[label]
                found[label] = (count + 1, joules + energies[kind])
        return found

    def buffer(self, library, loads):
        """Adds the trees; loads: {submodule: {pin: [loads of each bit]}} -> loads of this module's own inputs."""
        sinks, ideal = {}, set()
        for port in IDEAL:
            ideal.update(self.ports.get(port, ("", []))[1])
        for kind, _, pins in self.cells:
            for pin, bits in pins.items():
                if kind in loads:
                    if pin == "clk_o":
                        ideal.update(bits)
                    if pin in loads[kind]:
                        for i, bit in enumerate(bits):
                            sinks.setdefault(bit, []).append((loads[kind][pin][i], bits, i))
                elif pin in library.cells[kind].inputs:
                    sinks.setdefault(bits[0], []).append((1, bits, 0))
        fresh = 1 + max(
            [bit for _, bits in self.ports.values() for bit in bits if isinstance(bit, int)]
            + [bit for _, _, pins in self.cells for bits in pins.values() for bit in bits if isinstance(bit, int)],
            default=0,
        )
        (source,), (sink,) = library.buffer.inputs, library.buffer.outputs
        for bit, pins in sinks.items():
            while (
                isinstance(bit, int)
                and bit not in ideal
                and sum(load for load, _, _ in pins) > FANOUT
                and len(pins) > 1
            ):
                groups, room = [], 0
                for pin in sorted(pins, key=lambda pin: -pin[0]):
                    if pin[0] > room:
                        groups.append([])
                        room = FANOUT
                    groups[-1].append(pin)
                    room -= pin[0]
                pins.clear()
                for group in groups:
                    driver = [bit]
                    self.cells.append([library.buffer.name, f"tree{fresh}", {source: driver, sink: [fresh]}])
                    for _, bits, i in group:
                        bits[i] = fresh
                    pins.append((1, driver, 0))
                    fresh += 1
        return {
            port: [min(FANOUT, sum(load for load, _, _ in sinks.get(bit, ()))) for bit in bits]
            for port, (direction, bits) in self.ports.items()
            if direction == "input"
        }

    def verilog(self, name):
        """Structural Verilog."""
        at, lines = {}, []
        for want in ("input", "output"):
            for port, (direction, bits) in self.ports.items():
                if direction == want:
                    for i, bit in enumerate(bits):
                        place = port if len(bits) == 1 else f"{port}[{i}]"
                        if want == "input" or bit not in at:
                            at.setdefault(bit, place)
                        if at.get(bit) != place or isinstance(bit, str):
                            lines.append(f"  assign {place} = {_constant(bit) or at[bit]};")
        at = {bit: place for bit, place in at.items() if isinstance(bit, int)}
        wires = sorted(
            {bit for _, _, pins in self.cells for bits in pins.values() for bit in bits if isinstance(bit, int)}
            - set(at)
        )

        def net(bit):
            return _constant(bit) or at.get(bit) or f"n{bit}"

        def joined(bits):
            names = [net(bit) for bit in reversed(bits)]
            return names[0] if len(names) == 1 else "{" + ", ".join(names) + "}"

        for kind, label, pins in self.cells:
            ties = ", ".join(f".{pin}({joined(bits)})" for pin, bits in pins.items() if bits)
            lines.append(f"  {kind} {label if label.isidentifier() else chr(92) + label + ' '} ({ties});")
        head = [f"module {name} ({', '.join(self.ports)});"]
        head += [
            f"  {direction} {f'[{len(bits) - 1}:0] ' if len(bits) > 1 else ''}{port};"
            for port, (direction, bits) in self.ports.items()
        ]
        head += [f"  wire n{bit};" for bit in wires]
        return "\n".join(head + lines + ["endmodule", ""])


def alone(cell):
    """A flip-flop with its clock clk_i: Verilog, name and Netlist of a module that holds nothing else."""
    inputs = {pin: "clk_i" if pin == cell.clock_pin else pin.lower() for pin in cell.inputs}
    bits = {pin: [2 + i] for i, pin in enumerate([*inputs, *cell.outputs])}
    ports = {port: ("input", bits[pin]) for pin, port in inputs.items()}
    gates = Netlist(ports, [[cell.name, "q", bits]])
    return gates.verilog("alone"), "alone", gates


def _constant(bit):
    return f"1'b{bit}" if isinstance(bit, str) else None
