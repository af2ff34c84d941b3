# SPDX-License-Identifier: Apache-2.0
"""gates.py: a mapped, buffered module as Verilog for simulation.

Idea    Each gate is an expression, the library's own function of it, and no instance of a cell; modules stay modules,
        with their ports. Gates that only flip-flops look at stand in the process that clocks these, in order, so that
        they are computed once for each edge: Verilator would order the others and write each of them three times.
Rule    Flip-flops and latches do what the `ff` and `latch` groups of the library say, clear and preset included; what
        they hold at the beginning is up to the simulator. A memory stays rtl/lib/pipegs_sram.sv.
        A flip-flop behind the clock gate of an enable looks at its data at the edges of the gate's clock at which the
        enable was high: that is what latch and gate do, and no edge comes later than another. A unit's gate stays one.
        What is not understood raises ValueError.
"""
import collections
import itertools
import re

import rtlil
from liberty import operators

LONG = 300  # an expression with more letters is a wire
HEAD = "// A netlist for simulation, written by synth/synth.py --netlist: this module and all below it.\n"


class Nets:
    """Verilog's names of the bits of one module."""

    def __init__(self):
        self.names = {}

    def place(self, bits, name):
        """Bits that stand in a port or wire of this name."""
        for i, bit in enumerate(bits):
            self.names.setdefault(bit, name if len(bits) == 1 else f"{name}[{i}]")

    def bit(self, bit):
        return f"1'b{bit}" if isinstance(bit, str) else self.names.get(bit) or f"n{bit}"

    def bus(self, bits):
        return concatenation([self.bit(bit) for bit in reversed(bits)])


def concatenation(parts):
    """Verilog of single bits, highest first; neighbours in one signal are a slice of it.

    Verilator copies all before each part."""
    slices = []
    for part in parts:
        name, _, at = part.rstrip("]").partition("[")
        if at.isdigit() and slices and slices[-1][0] == name and slices[-1][2] == int(at) + 1:
            slices[-1][2] = int(at)
        else:
            slices.append([name, int(at), int(at)] if at.isdigit() and part[-1] == "]" else [part, None, None])
    texts = [
        name if high is None else f"{name}[{high}]" if high == low else f"{name}[{high}:{low}]"
        for name, high, low in slices
    ]
    return texts[0] if len(texts) == 1 else "{" + ",\n      ".join(texts) + "}"


def short_circuit(gates, library):
    """What a buffer drives is what drives it: a tree keeps its wiring and costs no gate."""
    source, cells = {}, []
    for kind, label, pins in gates.cells:
        cell = library.cells.get(kind)
        output = next(iter(cell.outputs), None) if cell and not cell.rules else None
        input_pin = operators(cell.outputs[output]) if output else None
        if input_pin in pins:
            source[pins[output][0]] = pins[input_pin][0]
        else:
            cells.append([kind, label, pins])
    gates.cells = cells
    for bits in [bits for _, bits in gates.ports.values()] + [bits for _, _, pins in cells for bits in pins.values()]:
        for i, bit in enumerate(bits):
            while bit in source:
                bit = source[bit]
            bits[i] = bit


def module_text(module, gates, library):
    short_circuit(gates, library)
    nets, lines, boxes = Nets(), [], {box.name: box for box in module.boxes()}
    for port, (direction, bits) in gates.ports.items():
        if direction == "input":
            nets.place(bits, port)
    enable_gates = set(gates.gates())
    instances = [cell for cell in gates.cells if cell[0] in boxes and cell[1] not in enable_gates]
    for number, (kind, _, pins) in enumerate(instances):  # first, for they name nets
        for port, direction, width in boxes[kind].ports():
            if direction == "output" and pins.get(port):
                nets.place(pins[port], f"u{number}_{port}")
                lines.append(f"  wire [{width - 1}:0] u{number}_{port};" if width > 1 else f"  wire u{number}_{port};")
    shown = [bit for _, (direction, bits) in gates.ports.items() if direction == "output" for bit in bits]
    shown += [
        bit
        for kind, _, pins in instances
        for port, direction, _ in boxes[kind].ports()
        if direction == "input"
        for bit in pins.get(port, [])
    ]
    enables = {
        pins["clk_o"][0]: (pins["clk_i"][0], pins["enable_i"][0])
        for _, label, pins in gates.cells
        if label in enable_gates
    }
    logic = Logic([cell for cell in gates.cells if cell[0] not in boxes], enables, library, nets)
    lines += logic.lines(shown)
    lines += [_instance(boxes[kind], number, label, pins, nets) for number, (kind, label, pins) in enumerate(instances)]
    lines += [
        f"  assign {port} = {nets.bus(bits)};"
        for port, (direction, bits) in gates.ports.items()
        if direction == "output"
    ]
    ports = [
        f"  {direction} {f'[{len(bits) - 1}:0] ' if len(bits) > 1 else ''}{port}"
        for port, (direction, bits) in gates.ports.items()
    ]
    return "\n".join([f"module {module.name} ("] + [",\n".join(ports)] + [");"] + lines + ["endmodule", ""])


def choice(name, variants):
    """A module with parameters that is one of these, which have one each of the values that the machine gives them."""
    ports = variants[0].ports()
    parameters = ", ".join(f"parameter int unsigned {key} = {value}" for key, value in variants[0].parameters.items())
    lines = [HEAD + "// verilator lint_off WIDTH", f"module {name} #({parameters}) ("]  # a parameter of one bit
    lines += [
        ",\n".join(f"  {way} logic {f'[{width - 1}:0] ' if width > 1 else ''}{port}" for port, way, width in ports)
    ]
    lines += [");"]
    for module in variants:
        chosen = " && ".join(f"{key} == {value}" for key, value in module.parameters.items())
        lines += [f"  if ({chosen}) begin : gen_{module.name}", f"    {module.name} u_gates (.*);", "  end"]
    return "\n".join(lines + ["endmodule", "// verilator lint_on WIDTH", ""])


class Logic:
    """The gates of one module: the drivers of its combinational nets, flip-flops by clock and reset, latches.

    enables: {gated clock: (clock, enable)}"""

    def __init__(self, cells, enables, library, nets):
        self.nets, self.drivers, self.flops, self.latches = nets, {}, {}, []
        self.enables = enables
        for kind, _, pins in cells:
            cell, pins = library.cells[kind], {pin: bits[0] for pin, bits in pins.items() if bits}
            outputs = [pin for pin in cell.outputs if pin in pins]
            if cell.rules and outputs:
                self._hold(cell, pins, outputs)
            else:
                inputs = [pin for pin in pins if pin in cell.inputs]
                for pin in outputs:
                    self.drivers[pins[pin]] = (operators(cell.outputs[pin]), {name: pins[name] for name in inputs})

    def _hold(self, cell, pins, outputs):
        """A flip-flop or latch: its output is the register, another one its complement."""
        register = pins[outputs[0]]
        if operators(cell.outputs[outputs[0]]).strip("()") != cell.held[0]:
            raise ValueError(f"{cell.name}: {cell.outputs[outputs[0]]} is not what it holds")
        for pin in outputs[1:]:
            self.drivers[pins[pin]] = ("!A", {"A": register})
        if cell.latch:
            self.latches.append((cell.latch, pins, register))
            return
        resets = [
            _reset(self.filled(cell.rules[rule], pins)) if rule in cell.rules else None for rule in ("clear", "preset")
        ]
        clock, enable = self.enables.get(pins[cell.clock_pin], (pins[cell.clock_pin], None))
        key = (_literal(self.filled(cell.rules["clocked_on"], pins | {cell.clock_pin: clock})), *resets)
        self.flops.setdefault(key, {}).setdefault(enable, []).append((register, cell.rules["next_state"], pins))

    def filled(self, function, pins):
        return re.sub(r"[A-Za-z_]\w*", lambda name: self.nets.bit(pins[name[0]]), function)

    def cone(self, bits):
        """The gates behind these bits, in order."""
        order, found, stack = [], set(), [(bit, False) for bit in bits]
        while stack:
            bit, done = stack.pop()
            if done:
                order.append(bit)
            elif bit not in found and bit in self.drivers:
                found.add(bit)
                stack.append((bit, True))
                stack += [(below, False) for below in self.drivers[bit][1].values()]
        return order

    def lines(self, shown):
        lines = []
        flops = [
            (key, [(enable, *flop) for enable, held in by_enable.items() for flop in held])
            for key, by_enable in self.flops.items()
        ]
        for number, (_, group) in enumerate(flops):
            self.nets.place([register for _, register, _, _ in group], f"q{number}")
            lines.append(f"  logic [{len(group) - 1}:0] q{number};" if len(group) > 1 else f"  logic q{number};")
        controls = {literal[1] for key in self.flops for literal in key if literal}
        shown = (
            shown
            + [bit for _, pins, _ in self.latches for bit in pins.values()]
            + [bit for bit in self.drivers if self.nets.bit(bit) in controls]
        )
        cones = [
            self.cone([bit for enable, _, _, pins in group for bit in (enable, *pins.values())]) for _, group in flops
        ]
        counts = collections.Counter(bit for cone in cones for bit in cone)
        eager = self.cone(shown + [bit for bit in counts if counts[bit] > 1])
        known = set(eager)
        lines += [f"  logic {self.nets.bit(bit)};" for bit in eager]
        lines += [f"  assign {self.nets.bit(bit)} = {self.filled(*self.drivers[bit])};" for bit in eager]
        for (data, enable), pins, register in self.latches:
            lines.append(
                f"  logic n{register};\n"
                f"  always_latch if ({self.filled(enable, pins)}) n{register} = {self.filled(data, pins)};"
            )
        for number, (key, group) in enumerate(flops):
            lines += self.process(number, *key, group, [bit for bit in cones[number] if bit not in known])
        return lines

    def process(self, number, clock, clear, preset, group, cone):
        """Flip-flops of one clock and reset, with the gates that only they look at; an enable's are neighbours."""
        uses, names = collections.Counter({enable: 1 for enable, _, _, _ in group}), {}
        data = [
            (function, {pin: pins[pin] for pin in re.findall(r"[A-Za-z_]\w*", function)})
            for _, _, function, pins in group
        ]
        for _, pins in [self.drivers[bit] for bit in cone] + data:
            uses.update(pins.values())
        filled = lambda function, pins: re.sub(
            r"[A-Za-z_]\w*", lambda pin: names.get(pins[pin[0]]) or self.nets.bit(pins[pin[0]]), function
        )
        body, wires = [], []
        for bit in cone:
            text = filled(*self.drivers[bit])
            if uses[bit] == 1 and len(text) < LONG or re.fullmatch(r"\w+(\[\d+\])?", text):
                names[bit] = text
            else:
                wires.append(bit)
                body.append(f"    {self.nets.bit(bit)} = {text};")
        edge = lambda literal: f"{'negedge' if literal[0] else 'posedge'} {literal[1]}"
        text = f"  always_ff @({' or '.join(edge(literal) for literal in (clock, clear, preset) if literal)})"
        for literal, value in ((clear, "'0"), (preset, "'1")):
            if literal:
                text += f" if ({'!' if literal[0] else ''}{literal[1]}) q{number} <= {value}; else"
        return (
            [text + f" begin : next{number}"]
            + [f"    automatic logic {self.nets.bit(bit)};" for bit in wires]
            + body
            + self._assignments(f"q{number}", group, [filled(*item) for item in data], names)
            + ["  end"]
        )

    def _assignments(self, name, group, data, names):
        """The register's new bits, enable by enable."""
        lines, at = [], 0
        for enable, held in itertools.groupby(group, key=lambda flop: flop[0]):
            end = at + len(list(held))
            if enable is not None:
                lines.append(f"    if ({names.get(enable) or self.nets.bit(enable)}) begin")
            lines += _words(name, data[at:end], at, len(group))
            lines += ["    end"] if enable is not None else []
            at = end
        return lines


def _instance(box, number, label, pins, nets):
    kind = box.name
    if box.base == rtlil.MEMORY:
        kind = f"{box.base} #({', '.join(f'.{key}({value})' for key, value in box.parameters.items())})"
    ties = [
        f".{port}({f'u{number}_{port}' if direction == 'output' else nets.bus(pins[port])})"
        if pins.get(port)
        else f".{port}()"
        for port, direction, _ in box.ports()
    ]
    return f"  {kind} {label if label.isidentifier() else chr(92) + label + ' '} ({', '.join(ties)});"


def _words(name, expressions, first, width):
    """Bits of a signal, 32 with each line: in one piece they would cost Verilator a wide intermediate for each bit."""
    if width == 1:
        return [f"    {name} <= {expressions[0]};"]
    return [
        f"    {name}[{first + at} +: {len(expressions[at:at + 32])}] <= {concatenation(expressions[at:at + 32][::-1])};"
        for at in range(0, len(expressions), 32)
    ]


def _literal(expression):
    """(is low active, signal)"""
    match = re.fullmatch(r"\(?(!?)([\w\[\]']+)\)?", expression)
    if not match:
        raise ValueError(f"{expression} is no signal")
    return match[1] == "!", match[2]


def _reset(expression):
    """_literal, None when it is off for ever."""
    low, signal = _literal(expression)
    if not signal.startswith("1'b"):
        return low, signal
    if low != (signal == "1'b1"):
        raise ValueError("a flip-flop is in reset for ever")
    return None


def text(modules, netlists, library):
    """A file with the first of these modules and all that it instantiates; netlists: {name: Netlist}."""
    used = {modules[0].name} | {child.name for module in modules for _, child in module.children}
    return HEAD + "".join(
        module_text(module, netlists[module.name], library)
        for module in modules
        if module.base != rtlil.MEMORY and module.name in used
    )
