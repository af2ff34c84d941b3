# SPDX-License-Identifier: Apache-2.0
"""What decides a figure, by name, and the hash of each today.

Only code counts. Comments, blanks, include lines and the folder that a file lies in change no figure, so they change no
hash either; nor does what reads scenes, prints, or draws.

    models          a group of GROUPS
    study NAME      sim/studies/NAME without its test and its command
    rtl MACHINE     the modules that the machine instantiates, as Verilator found them when it was measured last: a new
                    instance needs a change of a module's text, of the package or of a setting, so the list is enough
    rtl of FOLDER   a test of units: the modules of rtl/FOLDER, and rtl/lib
    point MACHINE   all settings of the machine
    scene NAME      the scene's file; our own is generated: `models` has it

A MACHINE is a design point, or one and what is changed in it: "exact sim/fine.cfg quads=1".
"""
import functools
import hashlib
import json
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "synth"))
from design_points import design_points  # noqa: E402

SHARED = Path(os.environ.get("PIPEGS_SHARED", ROOT.parent / "shared"))
MODULES = ROOT / "docs/data/modules.json"  # {module of rtl/: the machines that have it}
DRIVER = [f"cpp_model/driver/pipegs_{name}" for name in ("budget.c", "frame.c", "wide.h")]  # what the models call of it
GROUPS = {  # the folders or files that make it; with - before it, what is not of it
    "rtl": ["rtl"],
    "models": ["cpp_model", "-cpp_model/driver", *DRIVER, "-cpp_model/package_sv.cpp", "-cpp_model/control/print",
               "-cpp_model/lib/corners.cpp", "-cpp_model/lib/corners.hpp", "scenes/generate"],
    "timing": ["sim/timing", "-sim/timing/lockstep.cpp", "-sim/timing/lockstep.hpp"],
    "memory": ["sim/memory"],
    "bounds": ["sim/bounds"],
    "effects": ["sim/effects"],
    "layers": ["sim/layers", "sim/photos"],
    "path": ["scenes/cameras/path.cpp"],
    "cost": ["sim/design", "-sim/design/config_file.cpp", "-sim/design/config_file.hpp"],
    "silicon": ["sim/silicon/silicon.cpp", "sim/silicon/process.hpp", "sim/silicon/energy",
                "sim/silicon/area/sram_cost.cpp", "synth/data/sram.csv"],
    "area": ["sim/silicon", "synth/data"],
    "page": ["sim/report/page/package-lock.json", "sim/report/page/viewer", "sim/report/html/viewer.cpp",
             "scenes/packed/write_spz.cpp"],
    "synth": ["synth", "-synth/data", "-synth/fpga", "-synth/prove", "-synth/points.py", "-synth/depends.py",
              "-synth/declared.py", "-synth/design_points.py", "-synth/lint.sh", "-synth/misread.sh",
              "-synth/memories.sh", "-synth/prove.sh"],
    "gates": ["sim/rtl/build_rtl.sh", "sim/rtl/verilate.sh",  # whether a unit is gates
              "sim/timing/lockstep.cpp", "sim/timing/lockstep.hpp"],  # and takes the cycles that the RTL takes
    "fpga": ["synth/fpga"],
    "coverage": ["verif/top/coverage_test.cpp", "verif/top/linked_machine.hpp", "sim/bounds/hostile_scene.cpp"],
    "proofs": ["synth/prove", "synth/prove.sh"],
    "units": [f"verif/{folder}" for folder in ("dopu", "lib", "pu", "ru", "su", "support", "timing")],
    "frames": ["verif/frame", "verif/stability", "verif/support"],
}  # fmt: skip
SCENES = {  # scene: its file or folder in the folder of scenes
    "terrace": "terrace/terrace.ply.xz",
    "statue": "statue/statue.ply.xz",
    "plushdog": "plushdog/point_cloud_29999_clean.ply",
    "flowers": "flowers/flowers",
    "showroom": "showroom/lacadiere",
    "campsite": "campsite/campsite",
}
PHOTOGRAPHS = {"plush"}  # folders of photographs, beside the scenes
CODE = {".sv", ".svh", ".c", ".h", ".cpp", ".hpp", ".def", ".py", ".sh", ".sby", ".mjs", ".json", ".csv", ".vlt"}
IGNORED = re.compile(rb"^[ \t]*[#`]include[^\n]*|/\*.*?\*/|//[^\n]*|\s+", re.DOTALL | re.MULTILINE)
CHECKS = re.compile(rb"^`ifndef SYNTHESIS\b.*?^`(?:else|endif)", re.DOTALL | re.MULTILINE)
SHARP = re.compile(rb"^[ \t]*#[^\n]*|\s+", re.MULTILINE)  # of scripts and tables


def digest(parts):
    return hashlib.sha256(b"".join(sorted(parts))).hexdigest()[:12]


def files_of(place):
    return [place] if place.is_file() else sorted(f for f in place.rglob("*") if f.is_file())


@functools.cache
def text_hash(file):
    ignored = SHARP if file.suffix in (".py", ".sh", ".csv") else IGNORED
    return hashlib.sha256(ignored.sub(b"", file.read_bytes())).digest()


def hash_of_files(places):
    found = set()
    for place in places:
        files = files_of(ROOT / place.removeprefix("-"))
        found = found - set(files) if place.startswith("-") else found | set(files)
    return digest(text_hash(file) for file in found if file.suffix in CODE)


def place_of(scene):
    return SHARED / "photos" / scene if scene in PHOTOGRAPHS else SHARED / "scenes" / SCENES[scene]


def scene_hash(scene):
    """None when the scene's folder is not here."""
    place = place_of(scene)
    return digest(hashlib.sha256(f.read_bytes()).digest() for f in files_of(place)) if place.exists() else None


def settings(machine):
    """["key=value", ...] of a machine; a later one goes before an earlier one."""
    point, *changes = machine.split()
    found = list(design_points()[point])
    for change in changes:
        file = ROOT / change
        found += re.findall(r"^ *(\w+ *= *\w+)", file.read_text(), re.MULTILINE) if file.is_file() else [change]
    return list(dict(one.replace(" ", "").split("=") for one in found).items())


@functools.cache
def named_machine(machine):
    """The design point that has just these settings, else the machine as it is called."""
    own = sorted(settings(machine))
    return next((point for point in design_points() if sorted(settings(point)) == own), machine)


@functools.cache
def module_files():
    return {file.stem: file for file in files_of(ROOT / "rtl") if file.suffix == ".sv"}


@functools.cache
def listed():
    return json.loads(MODULES.read_text()) if MODULES.exists() else {}


def rtl_hash(modules, hash_file=text_hash):
    """Of some modules and the package."""
    files = module_files()
    return digest(hash_file(files[name]) for name in {"pipegs_pkg", *modules} if name in files)


@functools.cache
def synthesis_hash(file):
    """Of what synthesis reads of a module: not of its checks, between `ifndef SYNTHESIS and `else or `endif."""
    text = CHECKS.sub(b"", file.read_bytes())
    return hashlib.sha256(IGNORED.sub(b"", text)).digest()


@functools.cache
def hash_of(name):
    """What stands now for a name; None where that cannot be seen, "" where nothing does."""
    kind, _, rest = name.partition(" ")
    if not rest:
        return hash_of_files(GROUPS[kind]) if kind in GROUPS else ""
    if kind == "scene":
        return scene_hash(rest)
    if kind == "point":
        return digest(f"{key}={value}".encode() for key, value in settings(rest))
    if kind == "study":
        folder = f"sim/studies/{rest}"
        return hash_of_files([folder, f"-{folder}/test", f"-{folder}/command.cpp"])
    if rest.startswith("of "):
        folders = [f"rtl/{rest.removeprefix('of ')}", "rtl/lib"]
        return rtl_hash(file.stem for folder in folders for file in files_of(ROOT / folder))
    return rtl_hash(name for name, machines in listed().items() if rest in machines)


def find_modules(machine, machines, build):
    """Asks Verilator which modules a machine instantiates, and keeps that in MODULES, of no machine but these."""
    folders = [word for place in sorted((ROOT / "rtl").rglob("*")) if place.is_dir() for word in ("-y", place)]
    with tempfile.TemporaryDirectory() as work:
        package, tree = Path(work) / "pipegs_pkg.sv", Path(work) / "tree.xml"
        words = [f"{key}={value}" for key, value in settings(machine)]
        package.write_text(subprocess.run([build / "cpp_model/package_sv", *words], capture_output=True, text=True,
                                          check=True).stdout)  # fmt: skip
        words = ["verilator", "--xml-only", "--xml-output", tree, "-Wno-fatal", "-Wno-lint", "--Mdir", work]
        words += ["-y", ROOT / "rtl", *folders, "-y", ROOT / "sim/rtl", "--top-module", "pipegs_sim", package]
        subprocess.run([*words, "pipegs_sim"], check=True, stdout=sys.stderr)
        found = {module.get("origName") for module in xml.parse(tree).iter("module")}
    known = json.loads(MODULES.read_text()) if MODULES.exists() else {}
    for name in {*known, *found}:
        others = {*known.get(name, [])} & set(machines) - {machine}
        known[name] = sorted(others | ({machine} if name in found else set()))
    text = ",\n".join(f" {json.dumps(name)}: {json.dumps(known[name])}" for name in sorted(known) if known[name])
    MODULES.write_text(f"{{\n{text}\n}}\n")
    listed.cache_clear()
    hash_of.cache_clear()
