# SPDX-License-Identifier: Apache-2.0
"""What measures a figure, as short hashes: RTL, models, memory outside the chip, design points, and the scene's file.

Only code counts. Comments, blanks, include lines and the folder that a file lies in change no figure, so they change no
hash either.
"""
import functools
import hashlib
import os
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SHARED = Path(os.environ.get("PIPEGS_SHARED", ROOT.parent / "shared"))
GROUPS = {  # name of a group: the folders or files that make it
    "rtl": ["rtl"],
    "models": ["cpp_model", "cpp_model/driver/pipegs_frame.c", "cpp_model/driver/pipegs_wide.h", "scenes/generate"],
    "timing": ["sim/timing"],
    "memory": ["sim/memory"],
    "path": ["scenes/cameras/path.cpp"],
    "simulator": ["sim/rtl"],
    "cost": ["sim/design"],
    "train": ["sim/studies/train"],
    "page": [
        "sim/report/page/package-lock.json",
        "sim/report/page/viewer",
        "sim/report/html/viewer.cpp",
        "scenes/packed/write_spz.cpp",
    ],
    "synth": ["synth/synth.py", "synth/gating.py"],
    "fpga": ["synth/fpga/fpga.py"],
    "rivals": ["sim/studies/rivals"],
    "proofs": ["synth/prove", "synth/prove.sh"],
}
SCENES = {  # scene: its file or folder in the folder of scenes
    "terrace": "terrace/terrace.ply.xz",
    "statue": "statue/statue.ply.xz",
    "plushdog": "plushdog/point_cloud_29999_clean.ply",
    "flowers": "flowers/flowers",
    "showroom": "showroom/lacadiere",
}
PHOTOGRAPHS = {"plush"}  # folders of photographs, beside the scenes
POINT = "point "  # before the name of a design point whose settings measure too
SCENE = "scene "
CODE = {".sv", ".svh", ".c", ".h", ".cpp", ".hpp", ".def", ".py", ".sh", ".sby", ".mjs", ".json"}
IGNORED = re.compile(rb"^[ \t]*[#`]include[^\n]*|/\*.*?\*/|//[^\n]*|\s+", re.DOTALL | re.MULTILINE)


def digest(parts):
    return hashlib.sha256(b"".join(sorted(parts))).hexdigest()[:12]


def files_of(place):
    return [place] if place.is_file() else sorted(f for f in place.rglob("*") if f.is_file())


@functools.cache
def group_hash(group):
    found = [f for place in GROUPS[group] for f in files_of(ROOT / place) if f.suffix in CODE]
    return digest(hashlib.sha256(IGNORED.sub(b"", f.read_bytes())).digest() for f in found)


def place_of(scene):
    return SHARED / "photos" / scene if scene in PHOTOGRAPHS else SHARED / "scenes" / SCENES[scene]


@functools.cache
def scene_hash(scene):
    """None when the scene's folder is not here. Our own and its parts are generated: the group models has them."""
    place = place_of(scene)
    return digest(hashlib.sha256(f.read_bytes()).digest() for f in files_of(place)) if place.exists() else None


@functools.cache
def point_hash(point):
    """The settings of a design point; a machine that has no name there is none."""
    text = re.sub(r"//[^\n]*", "", (ROOT / "sim/design/design_points.def").read_text())
    settings = re.search(rf"PIPEGS_POINT\({point},.*?PIPEGS_END", text, re.DOTALL)[0]
    return digest(one.encode() for one in re.findall(r"PIPEGS_(?:SETTING|PICTURE)\((\w+, \w+)\)", settings))


def hash_of(name):
    """What stands now for the name of a part; None where nothing does."""
    if name.startswith(SCENE):
        return scene_hash(name.removeprefix(SCENE))
    if name.startswith(POINT):
        return point_hash(name.removeprefix(POINT))
    return group_hash(name) if name in GROUPS else ""


def measured_by(groups, scene, points):
    names = [
        *groups,
        *(POINT + point for point in points),
        *([SCENE + scene] if scene in SCENES or scene in PHOTOGRAPHS else []),
    ]
    return {name: hash_of(name) for name in names}


def older_than(entry):
    """Which of the hashes that an entry carries are no longer those of the sources; a scene not here is no news."""
    return [name for name, value in entry["by"].items() if hash_of(name) not in (None, value)]


CSV = {  # measured tables that programs read: what measured them
    "synth/data/points.csv": ["rtl"],
    "synth/data/paths.csv": ["rtl"],
    "synth/data/energy.csv": ["rtl", "models"],
    "synth/data/depends.csv": ["rtl"],
}
CSV_LINE = "# measured_by "  # the first line of such a table, and one hash


def csv_line(path):
    """The first line of a table that is measured from now on."""
    return CSV_LINE + digest(group_hash(group).encode() for group in CSV[path])


def csv_stamp(path):
    """Says of a table that it was measured now."""
    lines = (ROOT / path).read_text().splitlines(keepends=True)
    rest = lines[1:] if lines[:1] and lines[0].startswith(CSV_LINE) else lines
    (ROOT / path).write_text(csv_line(path) + "\n" + "".join(rest))


def csv_older(path):
    with open(ROOT / path) as table:
        return table.readline().strip() != csv_line(path)
