#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""commands.py PIPEGS [--check]: writes the options of all commands into docs/commands.md, from what --help prints.

Between its two markers the page has a table of the options that several commands share, group by group, then for each
command its example, its own options, and which groups it takes. With --check nothing is written; exits 1 when the page
differs.
"""
import collections
import difflib
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs" / "commands.md"
BEGIN, END = "<!-- options -->", "<!-- end -->"
COLUMN = 30  # of the text of an option in what --help prints
SHARED = 4  # so many commands make an option a shared one
SAMPLES = {  # a run of a second or two, from whose JSON the keys are taken; those of other commands are on their pages
    "model": "--scale 0.1",
    "profile": "--scale 0.1",
    "effects": "--scale 0.1",
    "budget": "--count 1000",
    "explain": "--scale 0.1 --no-rtl --pixel 40,40",
    "info": "",
    "config": "",
    "render": "--scale 0.1 --views all --model truth",
    "what-if": "--scale 0.1 --set units=2",
    "shapes": "--scale 0.1 --runs 1 --store shapes",
}
MANY = 16  # so many keys of plain values are a table of their own: NAME.*

TITLES = {"Options": "Of all kinds", "Positionals": "Before the options"}  # CLI11's own groups

Option = collections.namedtuple("Option", "group name takes what")
Command = collections.namedtuple("Command", "name what options notes subcommands")


def read_help(pipegs, *words):
    """The help of a command: what it does, its options in groups, its last paragraphs."""
    run = subprocess.run([pipegs, *words, "--help"], capture_output=True, text=True, check=True)
    head, *rest = run.stdout.split("\n\n")
    what = " ".join(line for line in head.splitlines() if not line.startswith("Usage:"))
    options, subcommands, notes = [], [], []
    for block in rest:
        title, *lines = block.strip("\n").splitlines()
        if title.startswith("Usage:"):
            continue
        if not title.endswith(":") or not lines or not lines[0].startswith("  "):
            notes.append(block.strip())
            continue
        entries = []
        for line in lines:
            if not line.startswith("   "):  # else the text of the entry above, which filled its column
                entries.append([line[2:COLUMN].strip() if line[COLUMN - 1 :].startswith(" ") else line[2:].strip(), ""])
                line = line[COLUMN:] if line[COLUMN - 1 :].startswith(" ") else ""
            entries[-1][1] += line.strip()
        group = title.rstrip(":")
        if "ubcommand" in group or "tudies" in group or "ommands" in group:
            subcommands += [name for name, _ in entries]
        else:
            options += [option(group, name, text) for name, text in entries]
    return Command(" ".join(words), what, [one for one in options if one.name != "-h,--help"], notes, subcommands)


def option(group, name, what):
    """`--lod INT=0 Excludes: --crop`: the name, what it takes with its default, what it goes with, and the text."""
    name, _, takes = name.partition(" ")
    takes, *others = re.split(r" (?=Excludes:|Needs:)", f" {takes}")
    for one in others:
        what += "; " + one.replace("Excludes: ", "not with ").replace("Needs: ", "with ")
    return Option(group, name, takes.strip().replace(f"{ROOT}/", ""), what)


def cell(text):
    return text.replace("|", "\\|").replace("<", "&lt;")


def table(options):
    lines = ["| option | takes | what |", "|---|---|---|"]
    for one in options:
        takes = re.sub(r"^(TEXT|INT|NUMBER)\b", lambda match: match[0].lower(), one.takes)
        lines.append(f"| `{one.name}` | {f'`{takes}`' if takes else ''} | {cell(one.what)} |")
    return "\n".join(lines)


def read_all(pipegs):
    """Every command, and below it its subcommands."""

    def below(*words):
        command = read_help(pipegs, *words)
        return [command] + [one for name in command.subcommands for one in below(*words, name)]

    return below()


def keys_of(value, path=""):
    """Every key of a JSON value, as a.b[].c; * for names whose values are alike."""
    if isinstance(value, list):
        return keys_of(value[0], f"{path}[]") if value else [path]
    if not isinstance(value, dict):
        return [path]
    if len(value) > MANY and not any(isinstance(one, (dict, list)) for one in value.values()):
        return [f"{path}.*"]
    inside = list(value.values())
    if len(inside) > 2 and all(isinstance(one, dict) and one.keys() == inside[0].keys() for one in inside):
        return keys_of(inside[0], f"{path}.*" if path else "*")
    return [key for name, one in value.items() for key in keys_of(one, f"{path}.{name}" if path else name)]


def json_keys(pipegs, name):
    """The keys of a command's sample run, in a folder of its own."""
    words = [Path(pipegs).resolve(), *name.split(), *SAMPLES[name.split()[-1]].split(), "--json"]
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(words, cwd=folder, capture_output=True, check=True)
    found = json.loads(run.stdout)
    found.pop("charts", None)  # the same of all commands: the page's head has them
    return "Keys of `--json`: " + ", ".join(f"`{key}`" for key in keys_of(found)) + "."


def page(commands, pipegs):
    times = collections.Counter(one for command in commands for one in command.options)
    shared = collections.defaultdict(list)
    for one in times:
        if times[one] >= SHARED:
            shared[one.group].append(one)
    lines = ["## Options that commands share"]
    for group, options in shared.items():
        lines += ["", f"### {TITLES.get(group, group)}", "", table(options)]
    for command in commands[1:]:
        lines += ["", f"## `pipegs {command.name}`", "", f"{command.what[:1].upper()}{command.what[1:]}."]
        own = [one for one in command.options if times[one] < SHARED]
        lines += ["", table(own)] if own else []
        taken = [taken_of(group, options, command) for group, options in shared.items()]
        lines += ["", "Shared: " + ", ".join(filter(None, taken)) + "."] if any(taken) else []
        lines += ["", json_keys(pipegs, command.name)] if command.name.split()[-1] in SAMPLES else []
        lines += [line for note in command.notes for line in ["", shown(note)]]
    return "\n".join(lines)


def taken_of(group, options, command):
    """What a command takes of a group: all, some by name, or nothing."""
    taken = [one for one in options if one in command.options]
    if len(taken) == len(options) > 1 and group not in TITLES:
        return f"all of [{group}](#{group.lower().replace(' ', '-')})"
    return ", ".join(f"`{one.name}`" for one in taken)


def shown(note):
    """A paragraph of the help on one line; an example as code."""
    text = " ".join(note.split())
    example = re.match(r"Example: (.*?)(?= Exit codes: |$)", text)
    return f"    {example[1]}\n\n{text[example.end():].strip()}".strip("\n") if example else text


def main():
    old = PAGE.read_text()
    head, tail = old[: old.index(BEGIN) + len(BEGIN)], old[old.index(END) :]
    new = f"{head}\n\n{page(read_all(sys.argv[1]), sys.argv[1])}\n\n{tail}"
    if sys.argv[2:] != ["--check"]:
        PAGE.write_text(new)
        return 0
    if new == old:
        return 0
    print(f"{PAGE}: not what `pipegs --help` prints: docs/commands.py build/pipegs writes it")
    print("\n".join(difflib.unified_diff(old.splitlines(), new.splitlines(), "page", "help", n=0, lineterm="")))
    return 1


if __name__ == "__main__":
    sys.exit(main())
