#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""figures_test.py: pages agree with docs/data, and the check that says so finds what it must.

Every marker of every page has one digit changed in turn, and each must be found. On a copy of docs the program itself
must fail for a changed digit in a page, a changed figure in the data, and a figure outside markers.
"""
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "docs/figures"))
import lint  # noqa: E402
import markers  # noqa: E402
from data import stored  # noqa: E402

failures = []


def expect(true, what):
    if not true:
        failures.append(what)


def other_digit(text):
    """The text with its last digit changed, or None when it has none."""
    found = re.search(r"\d(?=\D*$)", text)
    return found and text[: found.start()] + str((int(found[0]) + 1) % 10) + text[found.end() :]


def every_marker_is_held():
    count = 0
    markers.filled(stored())
    for page in markers.pages():
        content = (ROOT / page).read_text()
        for marker in markers.MARKER.finditer(content):
            changed = None if marker["code"] else other_digit(marker["text"])
            if changed is None:
                continue
            wrong = content[: marker.start("text")] + changed + content[marker.end("text") :]
            count += 1
            expect(
                markers.first_difference(page, wrong, markers.render(page, wrong)),
                f"{page}: a digit changed in {marker['what']} was not found",
            )
    expect(count > 0, "no page has a marker")


def lint_finds():
    page = Path("docs/cycles/none.md")
    for text in (
        "It takes 12 345 cycles.",
        "It takes 12345.",
        "Half of it: 48.8 %.",
        "38 dB",
        "2.5 mm2",
        "1.24x",
        "| own | 878 994 |",
        "| own | 1.5 |",
        "3 ms",
        "1.2 M of them",
        "- <!--fig 1-->1<!--/--> is first",
        "It has <!--fig 1--1-->2<!--/-->",
        "error 2^-16.11",
        "at most 3.5e-5 off",
        "within 6e-05",
        "| a | <!--fig 1|1-->1<!--/--> |",
    ):
        expect(lint.complaints(page, text), f"not complained about: {text}")
    for text in (
        "It takes <!--fig 12345-->12 345<!--/--> cycles.",
        "The paper has 26.42 dB.",
        "of 1024x768 pixels",
        "`12345`",
        "    12345 cycles",
        "[a](b_12345.md)",
        "two of 64 lines",
        "2^-13 of it",
        "```\n12345 cycles\n```",
    ):
        expect(not lint.complaints(page, text), f"complained about: {text}: {lint.complaints(page, text)}")


def copy_into(folder):
    shutil.copytree(ROOT / "docs", Path(folder) / "docs", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copytree(ROOT / "synth", Path(folder) / "synth", ignore=shutil.ignore_patterns("__pycache__"))
    points = Path(folder) / "sim/design"  # whose settings data carry a hash of
    points.mkdir(parents=True)
    shutil.copy(ROOT / "sim/design/design_points.def", points)
    shutil.copy(ROOT / "README.md", folder)


def program(folder, *options):
    words = [sys.executable, "-B", Path(folder) / "docs/figures", *options]
    return subprocess.run(words, capture_output=True, text=True)


def stamps():
    table = "synth/data/points.csv"
    with tempfile.TemporaryDirectory() as folder:
        copy_into(folder)
        first = (Path(folder) / table).read_text()
        for _ in range(2):  # the second stamp takes the place of the first
            expect(program(folder, "--stamp", table).returncode == 0, "--stamp fails")
        line, rest = (Path(folder) / table).read_text().split("\n", 1)
        expect(re.fullmatch(r"# measured_by [0-9a-f]{12}", line) and first.endswith(rest), f"a stamp as {line}")
        expect(table not in program(folder, "--check").stdout, "a stamped table counts as older")


def program_fails_on(what, path, change):
    with tempfile.TemporaryDirectory() as folder:
        copy_into(folder)
        file = Path(folder) / path
        before = file.read_text()
        file.write_text(change(before))
        expect(file.read_text() != before, f"{what}: nothing was changed")
        run = program(folder, "--check")
        expect(
            run.returncode == 1 and "docs/cycles/ladder.md" in run.stdout,
            f"{what}: exit code {run.returncode}\n{run.stdout}{run.stderr}",
        )


every_marker_is_held()
lint_finds()
stamps()
ladder = "docs/cycles/ladder.md"
program_fails_on("a digit of a page", ladder, lambda text: re.sub(r"(\| `exact` \| \d)", r"\g<1>9", text, count=1))
program_fails_on(
    "a figure of the data",
    "docs/data/model.json",
    lambda text: re.sub(r'("cycles": \d)', r"\g<1>9", text, count=1),
)
program_fails_on("a figure outside markers", ladder, lambda text: text + "\nIt takes 12 345 cycles.\n")
check = subprocess.run([sys.executable, "-B", ROOT / "docs/figures", "--check"])
expect(check.returncode == 0, "pages and data differ, see above; `python3 docs/figures --fill` writes data into pages")
print("\n".join(failures))
sys.exit(1 if failures else 0)
