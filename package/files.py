# SPDX-License-Identifier: Apache-2.0
"""files.py: the RTL of a machine as tools for systems on a chip take it: lists of files, FuseSoC, Bender, Vivado.

A list has the machine's package first, then every module that the machine has (uses.py), one in a file of its name.
"""
import functools
import pathlib
import re
import sys

from uses import used

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "synth"))
from design_points import design_points  # noqa: E402, F401
from jobs import Failed  # noqa: E402, F401

TOP = "pipegs_axi"
LICENSE = "SPDX-License-Identifier: Apache-2.0"
PRINTED = "Printed by package/machine.py (`make package`): change that, never this file."


@functools.cache
def modules():
    """{module: its file}."""
    return {path.stem: path for path in sorted(ROOT.glob("rtl/**/*.sv")) if path.stem != "pipegs_pkg"}


def sources(package):
    """The files of the modules of the machine of a package's text, from the root of the project."""
    texts = {name: path.read_text(encoding="utf-8") for name, path in modules().items()}
    found = used(package, texts, TOP)
    return [path.relative_to(ROOT) for name, path in modules().items() if name in found]


def version():
    """Of the registers, which is what a system sees: registers.def."""
    text = (ROOT / "cpp_model/control/registers.def").read_text()
    fields = text[text.index("PIPEGS_REGISTER(VERSION") :]
    minor, major = re.findall(r"REGISTER_FIELD\(\w+, \d+, 16, Constant, (\d+),", fields)[:2]
    return f"{major}.{minor}.0"


def filelist(files):
    return "\n".join([f"// {LICENSE}", f"// {PRINTED}", f"// Top: {TOP}.", *map(str, files)]) + "\n"


def fusesoc(files):
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
        *[f"      - {file}" for file in files],
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


def bender(files):
    lines = [
        f"# {LICENSE}",
        f"# {PRINTED}",
        "package:",
        "  name: pipegs",
        "sources:",
        "  - files:",
        *[f"      - {file}" for file in files],
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
