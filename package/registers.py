# SPDX-License-Identifier: Apache-2.0
"""registers.py: the map of a machine's registers, from its table (pipegs_registers.csv), in SystemRDL 2.0 and IP-XACT.

A slot of 64 bits is two registers here, NAME_low and NAME_high, as software sees it: what of its value lies in each,
the sign above it, else zero.
"""
import csv
from collections import namedtuple

from files import LICENSE

Register = namedtuple("Register", "name offset what fields")
Field = namedtuple("Field", "name low width access reset what")
COLUMNS = 120
RDL = {
    "constant": "sw = r; hw = na;",
    "read": "sw = r; hw = w;",
    "read and write": "sw = rw; hw = r;",
    "1 clears": "sw = rw; onwrite = woclr; hw = r; hwset;",
    "1 acts": "sw = w; singlepulse; hw = r;",
}
XML = {
    "constant": "<ipxact:access>read-only</ipxact:access>",
    "read": "<ipxact:volatile>true</ipxact:volatile><ipxact:access>read-only</ipxact:access>",
    "read and write": "<ipxact:access>read-write</ipxact:access>",
    "1 clears": "<ipxact:volatile>true</ipxact:volatile><ipxact:access>read-write</ipxact:access>"
    "<ipxact:modifiedWriteValue>oneToClear</ipxact:modifiedWriteValue>",
    "1 acts": "<ipxact:access>write-only</ipxact:access>",
}


def bits(text):
    """(lowest, how many) of "13:6 (name)", "5", "absent (name)"."""
    high, _, low = text.split(" ")[0].partition(":")
    return (0, 0) if high == "absent" else (int(low or high), int(high) - int(low or high) + 1)


def word(row, number):
    """One of the two registers of a slot."""
    low, width = bits(row["bits"])
    begin, end = max(low - 32 * number, 0), min(max(low + width - 32 * number, 0), 32)
    fields, unit = [], row["unit"].removesuffix("(signed)").strip()
    if width > 0 and end > begin:
        what = f"bits {32 * number + end - 1} to {32 * number + begin}"
        fields.append(Field("value", begin, end - begin, row["access"], 0, f"{unit}: {what}" if unit else what))
    if width > 0 and row["unit"].endswith("(signed)") and end < 32:
        fields.append(Field("sign", end, 32 - end, "read", 0, "the sign, once more"))
    fields = fields or [Field("zero", 0, 32, "read", 0, "reads 0")]
    name = row["name"].replace(".", "_") + ("_high" if number else "_low")
    return Register(name, int(row["offset"], 16) + 4 * number, row["what"], fields)


def registers(table):
    """The registers of the text of pipegs_registers.csv."""
    found = []
    for row in csv.DictReader(table.splitlines()):
        if not row["access"]:
            found.append(Register(row["name"], int(row["offset"], 16), row["what"], []))
        elif found and row["name"].startswith(f"{found[-1].name}."):
            what = f"{row['unit']}: {row['what']}" if row["unit"] else row["what"]
            reset = int(row["reset"], 0) if row["reset"] else None
            name = row["name"].split(".")[1]
            found[-1].fields.append(Field(name, *bits(row["bits"]), row["access"], reset, what))
        else:
            found += [word(row, 0), word(row, 1)]
    return found


def rdl(table):
    lines = [
        f"// {LICENSE}",
        "// The registers of PipeGS, SystemRDL 2.0. Printed by package/machine.py.",
        "",
        "addrmap pipegs {",
        '  name = "PipeGS";',
        "  default regwidth = 32;",
        "  default accesswidth = 32;",
        "  littleendian;",
    ]
    for reg in registers(table):
        lines.append(f'  reg {{ desc = "{reg.what}";')
        for field in reg.fields:
            reset = "" if field.reset is None else f" = {field.width}'h{field.reset:x}"
            head = f'    field {{ desc = "{field.what}";'
            tail = f" {RDL[field.access]} }} {field.name}[{field.low + field.width - 1}:{field.low}]{reset};"
            lines += [head + tail] if len(head + tail) <= COLUMNS else [head, "     " + tail]
        lines.append(f"  }} {reg.name} @ 0x{reg.offset:03x};")
    return "\n".join([*lines, "};", ""])


def escaped(text):
    return text.replace("&", "&amp;").replace("<", "&lt;")


def ipxact_registers(table):
    """The lines of all registers of an address block of IP-XACT."""
    lines = []
    for reg in registers(table):
        lines.append(
            f"<ipxact:register><ipxact:name>{reg.name}</ipxact:name>"
            f"<ipxact:description>{escaped(reg.what)}</ipxact:description>"
            f"<ipxact:addressOffset>'h{reg.offset:03x}</ipxact:addressOffset><ipxact:size>32</ipxact:size>"
        )
        for field in reg.fields:
            reset = (
                ""
                if field.reset is None
                else f"<ipxact:resets><ipxact:reset><ipxact:value>'h{field.reset:x}</ipxact:value>"
                "</ipxact:reset></ipxact:resets>"
            )
            lines.append(
                f"  <ipxact:field><ipxact:name>{field.name}</ipxact:name>"
                f"<ipxact:description>{escaped(field.what)}</ipxact:description>"
                f"<ipxact:bitOffset>{field.low}</ipxact:bitOffset>{reset}"
                f"<ipxact:bitWidth>{field.width}</ipxact:bitWidth>{XML[field.access]}</ipxact:field>"
            )
        lines.append("</ipxact:register>")
    return lines
