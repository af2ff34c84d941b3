# SPDX-License-Identifier: Apache-2.0
"""Of commands that print text: proofs, tables that tests print, what a page shows as it stands."""
import re


def tables(*names):
    """Of a text: its Markdown tables, as rows of cells, in this order."""

    def keep(text):
        blocks = [block.strip().split("\n") for block in re.split(r"\n\s*\n", text) if block.lstrip().startswith("|")]
        rows = [[[cell.strip() for cell in line.strip("|").split("|")] for line in block] for block in blocks]
        return {name: {"header": block[0], "rows": block[2:]} for name, block in zip(names, rows, strict=True)}

    return keep


def difference(text):
    """Of `pipegs render --compare`: how many pixels of two pictures differ, and by how much."""
    differ, pixels, codes = map(int, re.search(r"(\d+) of (\d+) pixels differ, by (\d+) codes", text).groups())
    return {"differ": differ, "pixels": pixels, "codes": codes}


def proofs(text):
    """Of synth/prove.sh: by proof its sets of parameters, its mutants, and the seconds of both."""
    found, name = {}, None
    for start, verdict, seconds, what in re.findall(r"^(\S*) +(proved|refuted) +([\d.]+) s  (.*)$", text, re.MULTILINE):
        name = start or name
        row = found.setdefault(name, {"sets": 0, "seconds": 0, "mutants": 0, "seconds_of_mutants": 0})
        if verdict == "proved":
            row |= {"sets": int(what.split()[0]), "seconds": float(seconds)}
        else:
            row["mutants"] += 1
            row["seconds_of_mutants"] = round(row["seconds_of_mutants"] + float(seconds), 1)
    return found


def printed(pattern, *names):
    """Of what a test prints: for each line that fits, its numbers by name."""

    def keep(text):
        rows = [dict(zip(names, map(float, found.groups()))) for found in re.finditer(pattern, text)]
        if not rows:
            raise ValueError(f"no line fits {pattern}")
        return {"lines": rows}

    return keep


def shown(text):
    """What a command prints, line by line; a path begins at the build folder, wherever that lies."""
    return {"lines": [line.rstrip() for line in re.sub(r"/\S*/(?=build/)", "", text).rstrip("\n").split("\n")]}
