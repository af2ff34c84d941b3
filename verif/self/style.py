#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""style.py: the rules of the tree that need no tool: lines, SPDX, Markdown, includes. style.sh calls it.

Rules   Text: at most COLUMNS columns (not Markdown, CSV, JSON, XML, nor the packaged machine, which names its
        settings), no blanks at the end of a line, one newline at the end of the file, and `SPDX-License-Identifier` in
        the first two lines of each source file.
        Markdown: a paragraph or list item is one line; a relative link names a file that is there, and its anchor a
        heading of that file.
        Includes: never upward in LAYERS; a file of a folder includes its own folder and those before it.
        Random numbers: no distribution of the C++ library, whose numbers differ from one library to the next.
Output  One line for each find: file, line, what is wrong. Exits 1 when there is any.
"""
import os
import re
import subprocess
import sys

COLUMNS = 120
# From the bottom up. progress.hpp lies in sim/ itself, for all its folders.
LAYERS = (
    "cpp_model/driver scenes cpp_model/float cpp_model sim sim/memory sim/rtl sim/compare sim/bounds sim/timing "
    "sim/design sim/layers sim/photos sim/report sim/silicon sim/effects sim/ladder sim/command sim/studies verif"
).split()
SOURCES = (
    ".cpp",
    ".hpp",
    ".def",
    ".sv",
    ".svh",
    ".vlt",
    ".py",
    ".sh",
    ".cmake",
    ".cfg",
    ".toml",
    ".cff",
    "CMakeLists.txt",
)
WIDE = (".md", ".csv", ".json", ".jsonl", ".svg", ".xml", "rtl/pipegs_pkg.sv")
BINARY = (".png", ".ply", ".splat", ".ksplat", ".spz", ".glb", ".sog", ".pfm", ".exr", ".zip", ".bin", ".fst")

finds = []


def find(path, line, what):
    finds.append(f"{path}:{line}: {what}")


def tracked():
    """Files of the tree: those that Git knows or would, else all but build folders and hidden ones."""
    known = subprocess.run(
        ["git", "ls-files", "-co", "--exclude-standard"], capture_output=True, text=True, check=False
    )
    if known.returncode == 0:
        return sorted(path for path in known.stdout.split("\n") if path and os.path.isfile(path))
    found = []
    for folder, inner, files in os.walk("."):
        inner[:] = [name for name in inner if not name.startswith((".", "build", "out"))]
        found += [os.path.relpath(os.path.join(folder, name)) for name in files if not name.startswith(".")]
    return sorted(found)


def check_text(path, lines, text):
    if text and (not text.endswith("\n") or text.endswith("\n\n")):
        find(path, len(lines), "the file does not end in one newline")
    for number, line in enumerate(lines, 1):
        if line != line.rstrip():
            find(path, number, "blanks at the end of the line")
        if len(line) > COLUMNS and not path.endswith(WIDE):
            find(path, number, f"{len(line)} columns, at most {COLUMNS}")
    source = path.endswith(SOURCES) or os.path.basename(path) in ("Makefile", ".clang-format", "run")
    if source and not any("SPDX" in line for line in lines[:3]):
        find(path, 1, "no SPDX-License-Identifier")


def slug(heading):
    """The anchor that GitHub gives a heading."""
    heading = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).strip().lower().replace("`", "")
    return re.sub(r"[^\w\- ]", "", heading).replace(" ", "-")


def anchors(lines):
    return {slug(line.lstrip("#")) for line in lines if re.match(r"#+ ", line)}


def prose(line):
    """Text of a paragraph or list item, as opposed to a heading, table, picture, comment or rule."""
    return bool(line.strip()) and not re.match(r"\s*([#|<>]|!\[|-{3,}$|```)", line)


def check_markdown(path, lines, all_anchors):
    fenced, before = False, ""  # before: the line above when it is prose
    for number, line in enumerate(lines, 1):
        if line.strip().startswith("```"):
            fenced = not fenced
            before = ""
            continue
        if fenced or (line.startswith("    ") and not before):
            continue
        begins = re.match(r"\s*([-*+]|\d+[.)])\s", line)
        if prose(line) and before and not begins:
            find(path, number, "a paragraph goes on after a line break: one paragraph or list item is one line")
        before = line if prose(line) else ""
        for target in re.findall(r"\]\(([^)\s]+)\)", re.sub(r"`[^`]*`", "", line)):
            if re.match(r"[a-z]+:", target):
                continue
            file, _, anchor = target.partition("#")
            file = os.path.normpath(os.path.join(os.path.dirname(path), file)) if file else path
            if not os.path.exists(file):
                find(path, number, f"dead link: {target}")
            elif anchor and anchor not in all_anchors.get(file, set()):
                find(path, number, f"dead link: no heading #{anchor} in {file}")


def layer(path):
    """The place of a file in LAYERS: the longest of its folders that is there, the last for a test; None outside."""
    folder = "verif" if "/test/" in path else os.path.dirname(path)
    while folder and folder not in LAYERS:
        folder = os.path.dirname(folder)
    return LAYERS.index(folder) if folder else None


def check_random(path, lines):
    for number, line in enumerate(lines, 1):
        if re.search(r"std::\w+_distribution", line):
            find(path, number, "a distribution of the library: draws.hpp draws the same numbers everywhere")


def check_includes(path, lines):
    for number, line in enumerate(lines, 1):
        match = re.match(r'\s*#\s*include\s+"([^"]+)"', line)
        own, other = layer(path), layer(match.group(1)) if match else None
        if other is not None and own is not None and other > own:
            find(path, number, f"{LAYERS[own]} includes {match.group(1)}, a layer above it")


def main():
    os.chdir(sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), "../.."))
    paths = [path for path in tracked() if path != "LICENSE"]
    texts = {}
    for path in paths:
        if not path.endswith(BINARY):
            try:
                with open(path, encoding="utf-8", newline="") as file:
                    texts[path] = file.read()
            except UnicodeDecodeError:
                find(path, 0, "not UTF-8")
    split = {path: text.split("\n")[:-1] if text.endswith("\n") else text.split("\n") for path, text in texts.items()}
    all_anchors = {path: anchors(lines) for path, lines in split.items() if path.endswith(".md")}
    for path, lines in split.items():
        if not path.endswith((".svg", ".csv")):
            check_text(path, lines, texts[path])
        if path.endswith(".md"):
            check_markdown(path, lines, all_anchors)
        if path.endswith((".cpp", ".hpp")):
            check_includes(path, lines)
            check_random(path, lines)
    print("\n".join(finds + [f"{len(paths)} files read, {len(finds)} finds"]))
    return 1 if finds else 0


if __name__ == "__main__":
    sys.exit(main())
