# SPDX-License-Identifier: Apache-2.0
"""Tables under synth/data that programs read. Lines `# measured_by HASH` in them say of which sources they are.

Those of synth/points.py have such a line before the rows of each configuration, `# measured_by HASH CONFIGURATION`: the
hash of the modules that stand in its rows, of rtl/lib, which is in all of them, and of the scripts of synthesis. So one
configuration is measured again by itself.
"""
import csv

from sources import ROOT, digest, hash_of, module_files, rtl_hash

BY = "# measured_by "
WHOLE = {  # tables with one such line, the first: what measured them
    "synth/data/energy.csv": ["rtl", "models"],
    "synth/data/depends.csv": ["rtl"],
}
POINTS, PATHS = "synth/data/points.csv", "synth/data/paths.csv"
MADE_BY = {
    "synth/data/energy.csv": "pipegs silicon --table, then --stamp",
    "synth/data/depends.csv": "synth/depends.py",
    POINTS: "synth/points.py",
    PATHS: "synth/points.py",
}


def whole_line(path):
    """The first line of a table that is measured from now on."""
    return BY + digest(hash_of(group).encode() for group in WHOLE[path])


def point_line(configuration, blocks):
    """The line before the rows of a configuration that has these blocks."""
    lib = [name for name, file in module_files().items() if "lib" in file.parts]
    parts = [rtl_hash({*blocks, *lib}), hash_of("synth")]
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


def stamp(path):
    """Says of a table that it was measured now."""
    if path in WHOLE:
        lines = (ROOT / path).read_text().splitlines()
        lines = [whole_line(path), *lines[lines[0].startswith(BY) :]]
    else:
        now, (head, *_) = today(path), [text for text in (ROOT / path).read_text().splitlines() if text[:1] != "#"]
        lines = [head, *(text for key, (_, rows) in rows_of(path).items() for text in (now[key], *rows))]
    (ROOT / path).write_text("\n".join(lines) + "\n")


def stale():
    """What is to be said of tables that today's sources would measure anew."""
    found = []
    for path, by in MADE_BY.items():
        if path in WHOLE:
            with open(ROOT / path, encoding="utf-8") as table:
                older = table.readline().strip() != whole_line(path)
            found += [f"stale: {path} ({', '.join(WHOLE[path])}): {by}"] if older else []
        else:
            lines = today(path)
            older = [key for key, (line, _) in rows_of(path).items() if line != lines[key]]
            some = f"{len(older)} of {len(lines)} configurations, {older[0]} the first" if older else ""
            found += [f"stale: {path} ({some}): {by}"] if older else []
    return found
