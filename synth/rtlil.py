# SPDX-License-Identifier: Apache-2.0
"""rtlil.py: a design as Yosys writes it (write_rtlil), cut into its modules.

Idea    One elaboration reads all sources; each module's text, freed of source lines and of numbers that depend on other
        modules, is all that its own synthesis reads. So the text is the job's key in the cache, and a change in one
        module leaves the others alone.
Rule    Modules of the same name and parameters are one. A module is named NAME, or NAME__Parameter_value... where the
        design holds it with several parameters. As somebody's submodule it is a black box: its ports only.
"""
import re

MEMORY = "pipegs_sram"  # the only module that stands for a memory macro (rtl/lib/pipegs_sram.sv)
GATE = "pipegs_clock_gate"  # the only one that may hold a latch


class Module:
    def __init__(self, base, parameters, lines):
        self.base, self.parameters, self.lines = base, parameters, lines
        self.name = base
        self.children = []  # (instance, Module)
        self.gates = []  # the same of the clock gates that synthesis adds for enables

    def ports(self):
        """[(name, direction, width)]"""
        found = []
        for line in self.lines:
            match = re.match(
                r"  wire (?:width (\d+) )?(?:upto |offset \d+ |signed )*(input|output) \d+ (?:signed )?\\(\S+)$", line
            )
            if match:
                found.append((match[3], match[2], int(match[1] or 1)))
        return found

    def text(self):
        return "\n".join([f"module \\{self.name}"] + self.lines + ["end", ""])

    def black_box(self):
        ports = [line for line in self.lines if re.match(r"  wire .*\b(input|output) \d+ ", line)]
        return "\n".join(["attribute \\blackbox 1", f"module \\{self.name}"] + ports + ["end", ""])

    def below(self):
        """Every module of its hierarchy once, itself first."""
        found = {self.name: self}
        for _, child in self.children + self.gates:
            for module in child.below():
                found.setdefault(module.name, module)
        return list(found.values())

    def boxes(self):
        """The modules of its own instances, each once."""
        return list({child.name: child for _, child in self.children + self.gates}.values())


def variant(module):
    """Its name where the design holds it with several parameters."""
    return module.base + "".join(f"__{key}_{value}" for key, value in module.parameters.items())


def _without_numbers(lines):
    """Names that Yosys made up hold source paths and counts over the whole design: number them in this module."""
    numbers = {}

    def rename(name):
        return numbers.setdefault(name, f"${len(numbers) + 1}")

    for i, line in enumerate(lines):
        if line.startswith("  cell "):
            head, name = line.rsplit(" ", 1)
            lines[i] = head + " " + (rename(name) if name.startswith("$") else name)
        elif line.startswith("    parameter \\MEMID"):
            lines[i] = re.sub(r"\$[^\s\"]+", lambda match: rename(match[0]), line)
        elif not line.startswith("    parameter"):
            lines[i] = re.sub(r"(?<=\s)\$\S+", lambda match: rename(match[0]), line)


def _cut(path):
    """{name: lines} of a file of RTLIL, without the attributes that name source lines."""
    cut, name, lines = {}, None, []
    with open(path, encoding="utf-8") as file:
        for line in file:
            line = line.rstrip("\n")
            if line.startswith("module "):
                name, lines = line[7:], []
            elif line == "end":
                cut[name], name = lines, None
            elif name and not re.match(
                r"\s*attribute \\(src|module_not_derived|dynports|hdlname|wiretype|enum_value_\S+) ", line
            ):
                lines.append(line)
    return cut


def read(path):
    """{name: Module} of a file of RTLIL."""
    unique, by_raw = {}, {}
    for raw_name, lines in _cut(path).items():
        base, parameters = raw_name.split("\\")[1], {}
        while lines and lines[0].startswith("  parameter "):
            _, key, value = lines.pop(0).split()
            parameters[key[1:]] = int(value.split("'")[-1], 2) if "'" in value else int(value)
        key = (base, tuple(parameters.items()))
        by_raw[raw_name] = unique.setdefault(key, Module(base, parameters, lines))
    bases = [module.base for module in unique.values()]
    for module in unique.values():
        if bases.count(module.base) > 1:
            module.name = variant(module)
    for module in unique.values():
        for i, line in enumerate(module.lines):
            if line.startswith("  cell ") and line.split()[1] in by_raw:
                _, kind, instance = line.split()
                module.lines[i] = f"  cell \\{by_raw[kind].name} {instance}"
                module.children.append((instance[1:], by_raw[kind]))
        _without_numbers(module.lines)
    return {module.name: module for module in unique.values()}
