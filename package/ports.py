# SPDX-License-Identifier: Apache-2.0
"""ports.py: the ports of rtl/pipegs_axi.sv with widths in a machine and meanings, and the template of an instance.

Names, directions and widths are read from the module; what a port means is said in docs/integration.md, in the tables
of its section Signals, and nowhere else.
"""
import re
import textwrap
from collections import namedtuple

from files import LICENSE, ROOT, TOP, Failed
from uses import constants

Port = namedtuple("Port", "name direction bits what")
COLUMNS = 120


def meanings():
    """{port: what the page says}."""
    page = (ROOT / "docs/integration.md").read_text(encoding="utf-8")
    found, prefix = {}, ""
    for line in re.search(r"^## Signals$(.*?)^## ", page, re.DOTALL | re.MULTILINE).group(1).splitlines():
        prefix = line[1 : line.index("`", 1)] if re.match(r"`[ms]_axi_`", line) else prefix
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if line.startswith("| `") and len(cells) == 4:
            what = re.sub(r" \(\[[^]]*\]\([^)]*\)\)", "", cells[3]).replace("`", "")  # without links
            found |= {prefix + name: what for name in re.findall(r"`(\w+)`", cells[0])}
    return found


def header():
    return (ROOT / f"rtl/{TOP}.sv").read_text(encoding="utf-8").split("\n);")[0]


def ports(package):
    """Every port of the machine of a package, in the order of the module."""
    known = constants(package)
    for name, value in re.findall(r"(?:parameter|localparam) int unsigned +(\w+) += ([\w:]+)", header()):
        known[name] = int(value) if value.isdigit() else known[value.removeprefix("pipegs_pkg::")]
    said, found = meanings(), []
    for way, high, name in re.findall(r"^  (input|output) +logic (?:\[(\S+):0\])? +(\w+)", header(), re.MULTILINE):
        width, _, eighth = high.removesuffix("-1").partition("/")
        bits = 1 if not high else int(high) + 1 if high.isdigit() else known[width] // int(eighth or 1)
        if not said.get(name):
            raise Failed(f"docs/integration.md does not say what {name} is")
        found.append(Port(name, way, bits, said[name]))
    return found


def template(package):
    """Signals for every port, and the instance that they go to."""
    lines = [
        f"// {LICENSE}",
        f"// Printed by package/machine.py: signals for {TOP} and its instance, to be put into a module and edited.",
    ]
    found = ports(package)
    for port in found:
        head = (
            f"  logic {f'[{port.bits - 1}:0]' if port.bits > 1 else '':<8}{port.name + ';':<15} // {port.direction:<6} "
        )
        lines += textwrap.wrap(port.what, COLUMNS, initial_indent=head, subsequent_indent=" " * 32 + "//        ")
    lines += [
        "",
        f"  {TOP} #(",
        "    .AddrW(40),  // bits of an address on m_axi",
        "    .Base(40'h0)  // what is added to every address that software gives, a multiple of 4096",
        "  ) u_pipegs (",
        ",\n".join(f"    .{port.name}({port.name})" for port in found),
        "  );",
    ]
    return "\n".join(lines) + "\n"
