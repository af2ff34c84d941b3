# SPDX-License-Identifier: Apache-2.0
"""Tables under synth/data that programs read: what the models of area, clock and energy are fitted to.

points.csv and paths.csv have a line `# measured_by HASH CONFIGURATION` before the rows of each configuration: the hash
of the modules that stand in its rows, of rtl/lib, which is in all of them, and of the scripts of synthesis. So one
configuration is measured again by itself. depends.csv has one such line, the first. energy.csv holds figures of the
entries silicon/*, so it is filled like a page.
"""
import csv
import subprocess
import sys

from data import data
from sources import ROOT, design_points, digest, hash_of, module_files, rtl_hash, synthesis_hash

BY = "# measured_by "
POINTS, PATHS, DEPENDS = "synth/data/points.csv", "synth/data/paths.csv", "synth/data/depends.csv"
ENERGY = "synth/data/energy.csv"
MADE_BY = {DEPENDS: "synth/depends.py", POINTS: "synth/points.py", PATHS: "synth/points.py"}


def whole_line():
    """The first line of depends.csv as measured from now on."""
    return BY + digest([hash_of("rtl").encode()])


def points():
    """The points of points.txt; a line there that begins with a blank goes on."""
    lines = (ROOT / "synth/data/points.txt").read_text().replace("\n ", " ").splitlines()
    return [" ".join(line.split()) for line in lines if line.strip() and not line.startswith("#")]


def point_line(configuration, blocks):
    """The line before the rows of a configuration that has these blocks."""
    lib = [name for name, file in module_files().items() if "lib" in file.parts]
    parts = [rtl_hash({*blocks, *lib}, synthesis_hash), hash_of("synth")]
    return f"{BY}{digest(part.encode() for part in parts)} {configuration}"


def rows_of(path):
    """{configuration: (its line `measured_by` or "", its rows)} of a table of synth/points.py."""
    found, line = {}, ""
    for text in (ROOT / path).read_text().splitlines():
        if text.startswith(BY):
            line = text
        elif not text.startswith("configuration,"):
            configuration = next(csv.reader([text]))[0]
            _, rows = found.setdefault(configuration, (line if line.endswith(f" {configuration}") else "", []))
            rows.append(text)
    return found


def today(path):
    """{configuration: the line that its rows would have if they were measured now}"""
    blocks = {key: {next(csv.reader([row]))[2] for row in rows} for key, (_, rows) in rows_of(POINTS).items()}
    return {key: point_line(key, blocks.get(key, ())) for key in rows_of(path)}


def stale():
    """{table: what is to be said of it}: those that today's sources would measure anew."""
    found = {}
    if (ROOT / DEPENDS).read_text().split("\n")[0] != whole_line():
        found[DEPENDS] = f"stale: {DEPENDS} (rtl): {MADE_BY[DEPENDS]}"
    for path in (POINTS, PATHS):
        lines = today(path)
        older = [key for key, (line, _) in rows_of(path).items() if line != lines[key]]
        older += ["one that is not in it"] * (len(points()) - len(lines))
        if older:
            some = f"{len(older)} of {max(len(points()), len(lines))} configurations, {older[0]} the first"
            found[path] = f"stale: {path} ({some}): {MADE_BY[path]}"
    return found


def measure(build):
    """Measures what is stale."""
    for program in dict.fromkeys(MADE_BY[path] for path in stale()):
        print(f"{program}: hours on two cores from nothing; what is done is kept", flush=True)
        subprocess.run([sys.executable, "-B", ROOT / program, "--build", build], check=True)


def energy():
    """energy.csv: cycles, gates and joules of the units in each frame that `pipegs silicon` measured."""
    rows = ["scene,configuration,cycles,row,kilo_nand2,frame_uj"]
    for name, entry in data.silicon.items():
        scene, _, point = name.partition("_")
        if point not in design_points():
            continue  # of another library
        (machine,) = entry.designs
        gates = {one.name: one.kilo_nand2 or 0 for one in machine.rows if one.name != "Total"}
        joules = {one.name: one.frame_j.mid for one in machine.energy if one.name in gates}
        frame = f'{scene},"{machine.configuration}",{machine.cycles}'
        rows += [f"{frame},{unit},{gates[unit]:.1f},{1e6 * joule:.3f}" for unit, joule in joules.items()]
    return "\n".join(rows) + "\n"
