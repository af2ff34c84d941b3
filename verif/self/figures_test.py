#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""figures_test.py: pages agree with docs/data, and the check that says so finds what it must; stale figures do not
fail it.

Every marker of every page has one digit changed in turn, and each must be found. On a copy of docs the program itself
must fail for a changed digit in a page or in an image that the data make, a changed figure in the data, and a figure
outside markers.
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
import drawing  # noqa: E402
import lint  # noqa: E402
import markers  # noqa: E402
import sources  # noqa: E402
import tree  # noqa: E402
from data import stored  # noqa: E402
from equal import unequal  # noqa: E402
from measurement import Measurement  # noqa: E402
from run import difference  # noqa: E402

failures = []
template = tempfile.TemporaryDirectory()


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
            markers.refused.clear()
            expect(
                markers.first_difference(page, wrong, markers.render(page, wrong))
                or any(f": {marker['what']}: " in one for one in markers.refused),
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


BELIEVE = """
import sys
sys.path.insert(0, sys.argv[1] + "/docs/figures")
import sources
import tables
from data import store, stored
from measurements import TABLE
entries = stored()
store({one.name: entries[one.name] | {"by": one.hashes()} for one in TABLE if one.name in entries})
write = lambda path, lines: (sources.ROOT / path).write_text("\\n".join(lines) + "\\n")
_, *rows = (sources.ROOT / tables.DEPENDS).read_text().splitlines()
write(tables.DEPENDS, [tables.whole_line(), *rows])
for path in (tables.POINTS, tables.PATHS):
    now, rows = tables.today(path), tables.rows_of(path)
    head = next(line for line in (sources.ROOT / path).read_text().splitlines() if line.startswith("configuration,"))
    write(path, [head, *(text for key, (_, own) in rows.items() for text in (now[key], *own))])
"""  # all is as if these sources had measured it


def copy_into(folder):
    for name in ("docs", "synth", "rtl", "cpp_model", "sim", "scenes", "verif/mutation"):
        shutil.copytree(ROOT / name, Path(folder) / name, ignore=shutil.ignore_patterns("__pycache__", "node_modules"))
    shutil.copy(ROOT / "README.md", folder)


def believed(folder):
    """A copy of the sources whose entries are all measured with them."""
    if not Path(template.name, "docs").exists():
        copy_into(template.name)
        subprocess.run([sys.executable, "-B", "-c", BELIEVE, template.name], check=True)
        expect(program(template.name, "--fill").returncode == 0, "--fill fails")
    shutil.copytree(template.name, folder, dirs_exist_ok=True)


def program(folder, *options):
    words = [sys.executable, "-B", Path(folder) / "docs/figures", *options]
    return subprocess.run(words, capture_output=True, text=True)


def changed(folder, path, old, new):
    file = Path(folder) / path
    text = file.read_text()
    expect(old in text, f"{path} has no {old}")
    file.write_text(text.replace(old, new, 1))


def sources_are_there():
    """A hash of a folder that has moved would never change."""
    for group, places in sources.GROUPS.items():
        for place in places:
            expect((ROOT / place.removeprefix("-")).exists(), f"sources.py: {group}: no {place}")


def what_makes_stale():
    """Comments and readers of scenes change no figure; a constant of one module does, of the machines that have it."""
    with tempfile.TemporaryDirectory() as folder:
        believed(folder)

        def stale():
            return [line for line in program(folder, "--check").stdout.splitlines() if line.startswith("stale")]

        before = [line for line in stale() if "never measured" not in line]
        expect(not before, f"stale although just measured: {before}")
        before = stale()
        changed(folder, "rtl/pu/front/pu_cull.sv", "// before the output", "// a comment before the output")
        changed(folder, "scenes/formats/spz.cpp", "return", "throw 1; return")
        changed(folder, "sim/report/table.cpp", "return", "throw 1; return")
        expect(stale() == before, f"a comment, a reader or a writer makes stale: {stale()}")
        changed(folder, "rtl/pu/front/pu_cull.sv", "Stages  = 7", "Stages  = 6")
        now = "\n".join(stale())
        for name in ("(b: rtl)", "rtl/own", "synth/data/points.csv ("):
            expect(name in now, f"a constant of pu_cull: {name} is not called stale: {now}")
        for name in ("model/own", "viewer/own"):
            expect(f" {name} " not in now.replace("\n", " ") + " ", f"a constant of pu_cull makes {name} stale: {now}")
        expect("runs/" not in now, f"a record is called stale: {now}")


def pruning_loses_nothing():
    """Figures that no page reads go, those that one reads stay, and lists keep their length."""
    raw = {"a": {"b": 1, "c": 2}, "list": [{"x": 1, "y": 2}, {"x": 3, "y": 4}], "all": {"d": 5, "e": 6}, "rest": [7]}
    node = tree.wrap(raw, "some/entry")
    tree.entries_read.clear()
    read = (node.a.b, [one.x for one in node.list], sum(node["all"].values()), "c" in node.a, node.get("none"))
    kept = {"a": {"b": 1, "c": 2}, "list": [{"x": 1}, {"x": 3}], "all": {"d": 5, "e": 6}}
    expect(node.pruned() == kept, f"pruned to {node.pruned()}")
    expect(tree.entries_read == {"some/entry"}, f"read: {tree.entries_read}")
    expect(read == (1, [1, 3], 11, True, None), f"read {read}")
    expect(tree.wrap({"a": [1, 2]}).pruned() == {}, "what nobody read stays")
    with tempfile.TemporaryDirectory() as folder:
        believed(folder)
        data = Path(folder) / "docs/data/rtl.json"
        before = data.read_text()
        changed(folder, "docs/data/rtl.json", '"figures": {', '"figures": {"nobody": {"reads": 12345},')
        expect(program(folder, "--fill").returncode == 0 and data.read_text() == before, "not pruned to what it was")


def equality_is_held():
    """One quantity with two values is found; another scene, another option or a stated reason is none."""

    def entries(*values):
        return {name: {"figures": figures} for name, figures in zip(("a/a", "b/b"), values)}

    one = Measurement("a/a", "build/pipegs sim --design dop --json", ("models",))
    for command, found, *more in (
        ("build/pipegs model --designs dop,fast --json", True),
        ("build/pipegs model --designs dop,fast --memory x --json", False),
        ("build/pipegs model --designs dop,fast --json", False, "cycles: another"),
        ("build/pipegs model --designs exact,fast --json", False),
        ("build/pipegs model --designs dop,fast --set records=512 --json", False),
    ):
        two = Measurement("b/b", command, ("models",), differs=more[0] if more else "")
        said = unequal(entries({"cycles": 1}, {"designs": [{"cycles": 2}, {"cycles": 1}]}), [one, two])
        expect(bool(said) == found, f"{command}: {said}")
        expect(not unequal(entries({"cycles": 2}, {"dop": {"cycles": 2}}), [one, two]), "equal, and complained about")


def mixing_is_refused():
    """A figure of two entries whose sources differ is not written, and said with its page, line and entries."""
    with tempfile.TemporaryDirectory() as folder:
        believed(folder)
        ladder = Path(folder) / "docs/cycles/ladder.md"
        ladder.write_text(
            ladder.read_text() + "\n\nIt is <!--fig data.rtl.terrace_fast.cycles + data.rtl.terrace_dop.cycles-->"
            "<!--/--> of both.\n"
        )
        expect(program(folder, "--fill").returncode == 0, "a sum of what the same sources measured is refused")
        text = re.sub(r'("terrace_dop": \{\n  "by": \{[^}]*"models": ")', r"\g<1>0", read(folder, "docs/data/rtl.json"))
        (Path(folder) / "docs/data/rtl.json").write_text(text)
        run = program(folder, "--fill")
        expect(run.returncode == 2, f"mixed sources: exit code {run.returncode}")
        for word in ("docs/cycles/ladder.md:", "rtl/terrace_dop", "rtl/terrace_fast", "models"):
            expect(word in run.stderr, f"mixed sources: no word of {word}: {run.stderr}")
        expect("rtl/terrace_dop" in program(folder, "--check").stdout, "--check says nothing of mixed sources")


def a_new_measurement_is_compared():
    """With all that is kept of the old one, but for what a computer takes."""
    kept = {"cycles": 1, "rows": [{"psnr_db": 2.5}, {}], "seconds": {"model": 3}}
    found = {"cycles": 1, "rows": [{"psnr_db": 2.5, "more": 1}, {"psnr_db": 7}], "seconds": {"model": 4}, "new": 1}
    expect(difference(kept, found) is None, f"equal, and {difference(kept, found)}")
    for wrong in ({"cycles": 2}, {"rows": [{"psnr_db": 2.25}, {}]}, {"rows": [{"psnr_db": 2.5}]}, {"cycles": None}):
        expect(difference(kept, found | wrong), f"not found: {wrong}")


def names_lie_free():
    """In a drawing the name of each line stands by itself: on no line, and on no other name."""
    series = [(f"scene <{i}>", "60 k", [(100, 68), (70 - 5 * i, 50 - i), (30 + 3 * i, 31)]) for i in range(4)]
    text = drawing.lines("title", "across", "up", (48, "step"), series)
    number = r"(-?[\d.]+)"
    places = {
        name: (float(x), float(y))
        for x, y, name in re.findall(rf'<text x="{number}" y="{number}"[^>]*>(scene [^<]*)<', text)
    }
    expect(sorted(places) == [f"scene &lt;{i}&gt;" for i in range(4)], f"names in the drawing: {places}")
    lines = [re.findall(rf"{number},{number}", line) for line in re.findall(r'<polyline points="([^"]*)"', text)]
    for name, (x, y) in places.items():
        for points in (line for line in lines if len(line) == 3):
            near = [p for p in drawing.between([(float(a), float(b)) for a, b in points])
                    if abs(p[0] - x) < 25 and abs(p[1] - y) < 12]  # fmt: skip
            expect(not near, f"{name} at {x}, {y} lies on a line, {near[:1]}")
        for other, (a, b) in places.items():
            expect(name == other or abs(a - x) > 50 or abs(b - y) > 25, f"{name} lies on {other}")


def read(folder, path):
    return (Path(folder) / path).read_text()


def program_fails_on(what, path, change, named="docs/cycles/ladder.md"):
    with tempfile.TemporaryDirectory() as folder:
        believed(folder)
        file = Path(folder) / path
        before = file.read_text()
        file.write_text(change(before))
        expect(file.read_text() != before, f"{what}: nothing was changed")
        run = program(folder, "--check", "pages")
        expect(
            run.returncode == 1 and named in run.stdout,
            f"{what}: exit code {run.returncode}\n{run.stdout}{run.stderr}",
        )


every_marker_is_held()
lint_finds()
sources_are_there()
what_makes_stale()
pruning_loses_nothing()
equality_is_held()
mixing_is_refused()
a_new_measurement_is_compared()
names_lie_free()
ladder = "docs/cycles/ladder.md"
program_fails_on("a digit of a page", ladder, lambda text: re.sub(r"(\| `exact` \| \d)", r"\g<1>9", text, count=1))
drawn = "docs/images/tradeoff.svg"
program_fails_on("a digit of an image", drawn, lambda text: re.sub(r'(cx="\d)', r"\g<1>9", text, count=1), drawn)
program_fails_on(
    "a figure of the data",
    "docs/data/model.json",
    lambda text: re.sub(r'("cycles": \d)', r"\g<1>9", text, count=1),
)
program_fails_on("a figure outside markers", ladder, lambda text: text + "\nIt takes 12 345 cycles.\n")
check = subprocess.run([sys.executable, "-B", ROOT / "docs/figures", "--check", "pages"])
expect(check.returncode == 0, "pages and data differ, see above; `python3 docs/figures --fill` writes data into pages")
print("\n".join(failures))
sys.exit(1 if failures else 0)
