# SPDX-License-Identifier: Apache-2.0
"""ipxact.py: a machine as a component of IP-XACT (IEEE 1685-2014): bus interfaces, ports, registers, files.

Buses have the names of AMBA's own definitions (amba.com, AMBA4, AXI4 and AXI4-Lite, r0p0_0), so tools that hold these
connect them by name.
"""
from files import LICENSE, TOP, version
from ports import ports
from registers import escaped, ipxact_registers

BUSES = {  # prefix: (bus of AMBA4, our side of it, what hangs on that side)
    "s_axi": ("AXI4-Lite", "slave", '<ipxact:memoryMapRef memoryMapRef="registers"/>'),
    "m_axi": ("AXI4", "master", '<ipxact:addressSpaceRef addressSpaceRef="memory"/>'),
}
SPACE = "http://www.accellera.org/XMLSchema/IPXACT/1685-2014"


def tag(name, *inner):
    return f"<ipxact:{name}>{''.join(inner)}</ipxact:{name}>"


def bus(prefix, names):
    kind, side, what = BUSES[prefix]
    reference = 'vendor="amba.com" library="AMBA4" name="{}" version="r0p0_0"'
    lines = ["<ipxact:busInterface>", tag("name", prefix), f"<ipxact:busType {reference.format(kind)}/>"]
    lines.append("<ipxact:abstractionTypes><ipxact:abstractionType>")
    lines.append(f"<ipxact:abstractionRef {reference.format(kind + '_rtl')}/><ipxact:portMaps>")
    for name in names:
        logical = tag("logicalPort", tag("name", name.removeprefix(f"{prefix}_").upper()))
        lines.append(f"  {tag('portMap', logical, tag('physicalPort', tag('name', name)))}")
    lines.append("</ipxact:portMaps></ipxact:abstractionType></ipxact:abstractionTypes>")
    return [*lines, tag(side, what), "</ipxact:busInterface>"]


def component(package, table, files):
    """The text of the component: of the machine of this package, with these registers and files."""
    found = ports(package)
    bus_w = next(str(port.bits) for port in found if port.name == "m_axi_rdata")
    names = {prefix: [p.name for p in found if p.name.startswith(f"{prefix}_")] for prefix in BUSES}
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f"<!-- {LICENSE}. Printed by package/machine.py. -->",
        f'<ipxact:component xmlns:ipxact="{SPACE}">',
        *[tag(key, value) for key, value in (("vendor", "pipegs"), ("library", "core"), ("name", "pipegs"))],
        tag("version", version()),
        "<ipxact:busInterfaces>",
        *[line for prefix in BUSES for line in bus(prefix, names[prefix])],
        "</ipxact:busInterfaces>",
        tag("addressSpaces", tag("addressSpace", tag("name", "memory"), tag("range", "'h100_0000_0000"),
                                 tag("width", bus_w))),
        "<ipxact:memoryMaps><ipxact:memoryMap><ipxact:name>registers</ipxact:name><ipxact:addressBlock>",
        "<ipxact:name>registers</ipxact:name><ipxact:baseAddress>'h0</ipxact:baseAddress>"
        "<ipxact:range>'h1000</ipxact:range><ipxact:width>32</ipxact:width><ipxact:usage>register</ipxact:usage>",
        *ipxact_registers(table),
        "</ipxact:addressBlock>",
        tag("addressUnitBits", "8") + "</ipxact:memoryMap></ipxact:memoryMaps>",
        "<ipxact:model>",
        tag("views", tag("view", tag("name", "rtl"), tag("envIdentifier", ":*Synthesis:"),
                         tag("componentInstantiationRef", "rtl"))),
        tag("instantiations", tag("componentInstantiation", tag("name", "rtl"), tag("language", "SystemVerilog"),
                                  tag("moduleName", TOP), tag("fileSetRef", tag("localName", "rtl")))),
        "<ipxact:ports>",
    ]  # fmt: skip
    for port in found:
        vector = tag("vector", tag("left", str(port.bits - 1)), tag("right", "0"))
        wire = [tag("direction", port.direction.removesuffix("put")), *([tag("vectors", vector)] * (port.bits > 1))]
        lines.append(tag("port", tag("name", port.name), tag("description", escaped(port.what)), tag("wire", *wire)))
    lines += ["</ipxact:ports></ipxact:model>", "<ipxact:fileSets><ipxact:fileSet><ipxact:name>rtl</ipxact:name>"]
    lines += [tag("file", tag("name", str(file)), tag("fileType", "systemVerilogSource")) for file in files]
    lines += ["</ipxact:fileSet></ipxact:fileSets>", "</ipxact:component>", ""]
    return "\n".join(lines)
