#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""files.py (pipegs.f | pipegs.core | Bender.yml | vivado.tcl): the RTL as tools for systems on a chip take it.

Each is printed from what lies in rtl/: the package first, then every module, one in a file of its name. `make package`
writes them, the test `package` compares. The machine is that of rtl/pipegs_pkg.sv; another one is a package printed by
`package_sv key=value ...` in its place (machine.py).
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
TOP = "pipegs_axi"
LICENSE = "SPDX-License-Identifier: Apache-2.0"
PRINTED = "Printed by package/files.py (`make package`): change that, never this file."


def sources():
    files = sorted(str(path.relative_to(ROOT)) for path in ROOT.glob("rtl/**/*.sv"))
    package = "rtl/pipegs_pkg.sv"
    return [package] + [file for file in files if file != package]


def version():
    """Of the registers, which is what a system sees: registers.def."""
    text = (ROOT / "cpp_model/control/registers.def").read_text()
    fields = text[text.index("PIPEGS_REGISTER(VERSION") :]
    minor, major = re.findall(r"REGISTER_FIELD\(\w+, \d+, 16, Constant, (\d+),", fields)[:2]
    return f"{major}.{minor}.0"


def filelist():
    head = [f"// {LICENSE}", f"// {PRINTED}", f"// Paths from the root of the project; top: {TOP}."]
    return "\n".join(head + sources()) + "\n"


def fusesoc():
    lines = [
        "CAPI=2:",
        f"# {LICENSE}",
        f"# {PRINTED}",
        f"name: pipegs:core:pipegs:{version()}",
        "description: 3D Gaussian splatting, AXI4 to memory, AXI4-Lite to its registers",
        "filesets:",
        "  rtl:",
        "    file_type: systemVerilogSource",
        "    files:",
        *[f"      - {file}" for file in sources()],
        "targets:",
        "  default: &default",
        "    filesets: [rtl]",
        f"    toplevel: {TOP}",
        "  lint:",
        "    <<: *default",
        "    default_tool: verilator",
        "    tools:",
        "      verilator:",
        "        mode: lint-only",
    ]
    return "\n".join(lines) + "\n"


def bender():
    lines = [
        f"# {LICENSE}",
        f"# {PRINTED}",
        "package:",
        "  name: pipegs",
        "sources:",
        "  - files:",
        *[f"      - {file}" for file in sources()],
    ]
    return "\n".join(lines) + "\n"


def vivado():
    lines = [
        f"# {LICENSE}",
        f"# {PRINTED}",
        "#",
        "# vivado -mode batch -source package/vivado.tcl, from the root of the project: packs the core as an IP in",
        "# build/ip. Vivado finds the AXI interfaces by the names of the ports. Another list of files, of",
        "# package/machine.py: -tclargs FOLDER/pipegs.f.",
        "create_project -in_memory",
        "set list [open [expr {$argc > 0 ? [lindex $argv 0] : {package/pipegs.f}}]]",
        "read_verilog -sv [regexp -all -inline -line {^.*[.]sv$} [read $list]]",
        "close $list",
        f"set_property top {TOP} [current_fileset]",
        "ipx::package_project -root_dir build/ip -vendor pipegs -library core -taxonomy /Video -import_files -force",
        "set core [ipx::current_core]",
        "set_property name pipegs $core",
        f"set_property version {'.'.join(version().split('.')[:2])} $core",
        "foreach bus {s_axi m_axi} { ipx::associate_bus_interfaces -busif $bus -clock aclk $core }",
        "set reset [ipx::get_bus_interfaces aresetn -of_objects $core]",
        "set_property value ACTIVE_LOW [ipx::add_bus_parameter POLARITY $reset]",
        "ipx::create_xgui_files $core",
        "ipx::update_checksums $core",
        "ipx::check_integrity $core",
        "ipx::save_core $core",
    ]
    return "\n".join(lines) + "\n"


PRINTS = {"pipegs.f": filelist, "pipegs.core": fusesoc, "Bender.yml": bender, "vivado.tcl": vivado}

if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1] not in PRINTS:
        print(f"files.py: expected one of {', '.join(PRINTS)}", file=sys.stderr)
        sys.exit(2)
    sys.stdout.write(PRINTS[sys.argv[1]]())
