# SPDX-License-Identifier: Apache-2.0
"""liberty.py: what synthesis needs to know of a liberty file, and models of what no library holds.

Idea    Cells are found by what they do, not by name: the NAND2 that areas are counted in, the inverter of the
        fan-out-of-4 delay, a buffer for large nets, a latch for the clock gates. So any library with these and a plain
        flip-flop will do.
Rule    Cells for delays, clocks, isolation and probing are never used (UNUSED), nor flip-flops with a scan or an enable
        input: they are cut out of the copies that are read from here on. Power is in one of the two copies only: it
        makes no difference to mapping and paths.
        A memory is a flip-flop-like cell: its inputs have a setup, its output shows a stated access time after the
        edge.
        A clock gate is one too: its enable has a setup before the edge that it lets pass, and no path goes through it.
"""
import gzip
import itertools
import re

RULES = ("next_state", "clocked_on", "data_in", "enable", "clear", "preset")
UNUSED = re.compile(r"lpflow|probe|dly|clkbuf|clkinv|macro|decap|fill", re.IGNORECASE)


def _block(text, start):
    """The end of the group whose opening brace is the first at or after start."""
    depth = 0
    for brace in re.compile(r"[{}]").finditer(text, start):
        depth += 1 if brace[0] == "{" else -1
        if depth == 0:
            return brace.end()
    raise ValueError("a group of the liberty file does not end")


def _groups(text, kind):
    """[(name, text, start, end)] of the groups `kind (name) {...}`."""
    found, at = [], 0
    pattern = re.compile(r"\b" + kind + r"\s*\(([^)]*)\)\s*\{")
    while match := pattern.search(text, at):
        at = _block(text, match.end() - 1)
        found.append((match[1].strip(' "'), text[match.start() : at], match.start(), at))
    return found


def _without(text, kind, names=re.compile("")):
    """Without the groups of this kind whose name holds names."""
    kept, at = [], 0
    for name, _, start, end in _groups(text, kind):
        if names.search(name):
            kept.append(text[at:start])
            at = end
    return "".join(kept) + text[at:]


def _value(text, key, default=None):
    match = re.search(r"\b" + key + r'\s*:\s*"?([^";]+?)"?\s*;', text)
    return match[1] if match else default


def operators(function):
    """A function of a liberty file with Verilog's operators; a blank is an and too."""
    function = re.sub(r"(?<=[\w)])\s+(?=[\w!(])", "&", function.strip())
    return function.replace("*", "&").replace("+", "|").replace(" ", "")


class Cell:
    def __init__(self, name, text):
        self.name, self.area = name, float(_value(text, "area", "0"))
        pins = {pin: body for pin, body, _, _ in _groups(text, "pin")}
        self.inputs = {
            pin: float(_value(body, "capacitance", "0"))
            for pin, body in pins.items()
            if _value(body, "direction") == "input"
        }
        self.outputs = {
            pin: _value(body, "function") for pin, body in pins.items() if _value(body, "direction") == "output"
        }
        flop, latch = (next(iter(_groups(text, kind)), None) for kind in ("ff", "latch"))
        held, rules = (flop or latch or ("", ""))[:2]
        self.held = [name.strip(' "') for name in held.split(",")]  # the names of what it holds and of its complement
        self.rules = {rule: operators(_value(rules, rule)) for rule in RULES if _value(rules, rule)}
        self.is_flop, self.latch = (
            flop is not None,
            (self.rules.get("data_in"), self.rules.get("enable")) if latch else None,
        )
        clock = _value(rules, "clocked_on", "").strip("!() '")
        self.clock_pin = clock if flop and clock in self.inputs else None

    def computes(self, inputs, function):
        """Whether it is a gate of so many inputs and one output with this truth."""
        if len(self.inputs) != inputs or len(self.outputs) != 1 or self.is_flop or self.latch:
            return False
        text = next(iter(self.outputs.values()))
        if not text or re.search(r"[^\w\s!&|*+()]", text):
            return False
        python = operators(text).replace("!", " not ").replace("&", " and ").replace("|", " or ")
        try:
            return all(
                bool(eval(python, {}, dict(zip(self.inputs, values)))) == function(*values)
                for values in itertools.product((False, True), repeat=inputs)
            )
        except (SyntaxError, NameError):
            return False


class Library:
    def __init__(self, path):
        with (gzip.open if path.endswith(".gz") else open)(path, "rt", encoding="latin-1") as file:
            text = re.sub(r"/\*.*?\*/", "", file.read(), flags=re.DOTALL)
        muxed = [
            name for name, body, _, _ in _groups(text, "cell") if re.search(r'next_state\s*:\s*"[^"]*[&|*+]', body)
        ]
        self.power_text = _without(
            text, "cell", re.compile("|".join([UNUSED.pattern] + [f"^{name}$" for name in muxed]), re.IGNORECASE)
        )
        text = _without(_without(self.power_text, "leakage_power"), "internal_power")
        self.text, self.cells = text, {name: Cell(name, body) for name, body, _, _ in _groups(text, "cell")}
        unit = re.search(r'capacitive_load_unit\s*\(\s*([\d.]+)\s*,\s*"?(\w)f"?\s*\)', text)
        self.femto = float(unit[1]) * {"p": 1000, "f": 1}[unit[2].lower()]  # of its unit of capacitance
        self.volts = float(_value(text, "nom_voltage", "0") or 0)
        gates = self.cells.values()
        self.nand = min((c for c in gates if c.computes(2, lambda a, b: not (a and b))), key=lambda c: c.area)
        self.inverter = min((c for c in gates if c.computes(1, lambda a: not a)), key=lambda c: min(c.inputs.values()))
        self.buffer = max(
            (c for c in gates if c.computes(1, lambda a: a) and c.area <= 2 * self.nand.area), key=lambda c: c.area
        )
        latches = [
            c for c in gates if c.latch and c.latch[0] in c.inputs and c.latch[1] in c.inputs and len(c.inputs) == 2
        ]
        self.latch = min(latches, key=lambda c: (len(c.outputs), c.area))
        self.latch.area = self.latch.area or min(c.area for c in gates if c.is_flop)  # osu018 states none
        self.nand_load = sum(self.nand.inputs.values()) / 2  # of one input
        self.load = 4 * min(self.inverter.inputs.values())  # in its unit of capacitance

    def latch_map(self):
        """How Yosys' latches become this library's (Verilog for techmap)."""
        data, enable = self.latch.latch
        output = next(iter(self.latch.outputs))
        return "".join(
            f"module \\$_DLATCH_{sign}_ (input E, D, output Q); wire g; {gate}\n"
            f"  {self.latch.name} _TECHMAP_REPLACE_ (.{data}(D), .{enable}(g), .{output}(Q)); endmodule\n"
            for sign, gate in (("P", "assign g = E;"), ("N", "\\$_NOT_ low (.A(E), .Y(g));"))
        )


def _pin(kind, name, width, body):
    if width == 1:
        return f"  pin({name}) {{ {body} }}\n"
    return f"  bus({name}) {{ bus_type : {kind}; {body} }}\n"


def models(memories, gates, library, access_ns, setup_ns):
    """Liberty text: each of memories and gates (rtlil.Module) as a cell with its timing at the edge of clk_i."""
    widths = {width for module in memories for _, _, width in module.ports() if width > 1}
    text = "library(models) {\n delay_model : table_lookup;"
    text += ' time_unit : "1ns"; voltage_unit : "1V"; current_unit : "1mA";\n'
    text += " capacitive_load_unit(1, ff);\n" + "".join(
        f" {key} : 50;\n"
        for key in (
            "input_threshold_pct_rise",
            "input_threshold_pct_fall",
            "output_threshold_pct_rise",
            "output_threshold_pct_fall",
        )
    )
    text += "".join(
        f" slew_{side}_threshold_pct_{edge} : {percent};\n"
        for side, percent in (("lower", 20), ("upper", 80))
        for edge in ("rise", "fall")
    )
    for width in sorted(widths):
        text += f" type(w{width}) {{ base_type : array; data_type : bit; bit_width : {width}; "
        text += f"bit_from : {width - 1}; bit_to : 0; downto : true; }}\n"
    both = lambda first, second, ns: "".join(f'{key}(scalar) {{ values("{ns:.4f}"); }} ' for key in (first, second))
    limits = both("rise_constraint", "fall_constraint", setup_ns)
    setup = f'timing() {{ related_pin : "clk_i"; timing_type : setup_rising; {limits}}}'
    load = f"capacitance : {library.load * library.femto:.4f};"
    for module in memories + gates:
        text += f" cell({module.name}) {{\n"
        for name, direction, width in module.ports():
            if name == "clk_i":
                body = "direction : input; clock : true; capacitance : 0;"
            elif name == "rst_ni":
                body = "direction : input; capacitance : 0;"
            elif direction == "input":
                body = f"direction : input; {load} {setup}"
            elif module in gates:
                body = (
                    'direction : output; function : "clk_i"; '
                    + 'timing() { related_pin : "clk_i"; timing_sense : positive_unate; '
                    + both("cell_rise", "cell_fall", 0)
                    + both("rise_transition", "fall_transition", 0)
                    + "}"
                )
            else:
                body = (
                    'direction : output; timing() { related_pin : "clk_i"; timing_type : rising_edge; '
                    + both("cell_rise", "cell_fall", access_ns)
                    + both("rise_transition", "fall_transition", setup_ns)
                    + "}"
                )
            text += _pin(f"w{width}", name, width, body)
        text += " }\n"
    return text + "}\n"
