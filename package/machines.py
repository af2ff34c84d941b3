# SPDX-License-Identifier: Apache-2.0
"""machines.py: the package and the registers of every design point, without a build.

C++ alone knows what follows from config.def (cpp_model/package_sv.cpp, control/print). What it prints for `fast` is
committed whole, the package in rtl/, and of the other design points what is different: a row of machines.csv says which
lines of which file a machine has others for. `make package` writes them, and the test `package` holds them against the
programs. All are without taps, which are for the harness alone.
"""
import csv
import difflib
import io
import subprocess

from files import ROOT, Failed, design_points

DEFAULT = "fast"
PRINTED = ("pipegs_pkg.sv", "pipegs_registers.csv")
TABLE = ROOT / "package/machines.csv"
HEAD = ["file", "line", "lines", "machines", "text"]  # `lines` lines from `line` on, the first 0, give way to `text`


def committed(file):
    """Where a file of the default machine lies, from the root of the project."""
    return f"rtl/{file}" if file == "pipegs_pkg.sv" else f"package/{file}"


def printed(build, settings):
    """{file: text} of the machine of these settings, by the programs of a build folder."""
    programs = {
        "pipegs_pkg.sv": [f"{build}/cpp_model/package_sv"],
        "pipegs_registers.csv": [f"{build}/cpp_model/control/print/registers_print", "csv"],
    }
    texts = {}
    for name, program in programs.items():
        try:
            run = subprocess.run([*program, *settings], capture_output=True, text=True, check=False)
        except OSError:
            raise Failed(
                f"{program[0]} is missing: cmake --build {build} --target package_sv registers_print"
            ) from None
        if run.returncode != 0:
            raise Failed(run.stderr.strip().splitlines()[-1])
        texts[name] = run.stdout
    return texts


def changes(base, text):
    """(line, lines, new lines) wherever a text is another; line by line where as many come as go."""
    matcher = difflib.SequenceMatcher(None, base, text, autojunk=False)
    for kind, begin, end, new_begin, new_end in matcher.get_opcodes():
        if kind == "delete":  # of two lines one is left
            begin, new_begin = begin - 1, new_begin - 1
        if end - begin == new_end - new_begin and kind != "equal":
            yield from ((begin + i, 1, (text[new_begin + i],)) for i in range(end - begin))
        elif kind != "equal":
            yield begin, end - begin, tuple(text[new_begin:new_end])


def table(texts):
    """The text of machines.csv; `texts` is {machine: {file: text}}."""
    found = {}
    for machine, files in texts.items():
        for name, text in files.items():
            for change in changes(texts[DEFAULT][name].splitlines(), text.splitlines()):
                found.setdefault((name, *change), []).append(machine)
    out = io.StringIO()
    rows = csv.writer(out, lineterminator="\n")
    rows.writerow(HEAD)
    for (name, line, lines, new), machines in sorted(found.items()):
        for i, text in enumerate(new):
            rows.writerow([name, line, 0 if i else lines, " ".join(machines), text])
    return out.getvalue()


def named(machine):
    """{file: text} of a design point."""
    if machine not in design_points():
        raise Failed(f"unknown design point '{machine}'; known: {', '.join(design_points())}")
    with open(TABLE, encoding="utf-8", newline="") as file:
        rows = [row for row in csv.DictReader(file) if machine in row["machines"].split()]
    texts = {}
    for name in PRINTED:
        base, out, at = (ROOT / committed(name)).read_text(encoding="utf-8").splitlines(), [], 0
        for row in (row for row in rows if row["file"] == name):
            if int(row["lines"]) or int(row["line"]) > at:
                out += base[at : int(row["line"])]
                at = int(row["line"]) + int(row["lines"])
            out.append(row["text"])
        texts[name] = "\n".join(out + base[at:]) + "\n"
    return texts
