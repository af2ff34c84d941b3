# SPDX-License-Identifier: Apache-2.0
"""Fills what lies between the markers of a page: <!--fig EXPRESSION-->text<!--/-->. Makes files that are figures only.

The expression sees the tree of figures, the formats, and the functions of the page's own module,
pages/FOLDER/NAME.py. A text of several lines (a table) stands alone between blank lines, as Markdown wants it. Code
of the page is left as it is.
"""
import collections
import functools
import importlib
import re
import sys
from pathlib import Path

import formats
import tables
from measurements import TABLE
from data import data, grow
from sources import ROOT
from tree import entries_read

MARKER = re.compile(
    r"(?P<code>^```.*?^```|^ {4}[^\n]*|`[^`\n]+`)|<!--fig (?P<what>.*?)-->(?P<text>.*?)<!--/-->",
    re.DOTALL | re.MULTILINE,
)
OPENED = re.compile(r"<!--fig |<!--/-->")
shown = {}  # the entries that the tree of figures holds
refused = []  # markers that stay as they are: what they read was not measured with the same sources


class PageError(Exception):
    """A page that is not there, or a marker that cannot be filled: page, line, expression, reason."""


def name_of(page):
    """docs/cycles/ladder.md -> ladder; README.md -> readme; a README in a folder -> the folder's name."""
    stem = page.stem if page.stem != "README" else page.parent.name if page.parent.parts else "readme"
    return stem.replace("-", "_")


def module_of(page):
    """The module of a page: pages/, then the folder of the page in docs/."""
    parts = ["pages", *page.parent.parts[1:], name_of(page)]
    if not Path(__file__).parent.joinpath(*parts).with_suffix(".py").exists():
        return None
    return importlib.import_module(".".join(parts))


@functools.cache
def names_for(page):
    names = {key: value for key, value in vars(formats).items() if not key.startswith("_")}
    module = module_of(page)
    return names | {"data": data} | (vars(module) if module else {})


@functools.cache
def value(page, expression):
    """The text of a page's expression, and the names of the entries that it reads."""
    entries_read.clear()
    text = formats.text(eval(expression, names_for(page)))  # the page's own code, as in a template
    return text, frozenset(entries_read)


@functools.cache
def mixed(names):
    """Which parts of the sources entries have in different states, and these entries by their states; "" when none."""
    states = collections.defaultdict(set)
    for name in names:
        for part, state in shown[name]["by"].items():
            states[part].add(state)
    parts = [part for part, of in states.items() if len(of) > 1 and part != "command"]
    groups = collections.defaultdict(list)
    for name in sorted(names):
        own = tuple(shown[name]["by"].get(part) for part in parts)
        groups[own] += [name] if any(own) else []
    return f"different {', '.join(parts)}: {' and '.join(map(' '.join, groups.values()))}" if parts else ""


@functools.cache
def measured_at(names):
    """The line under a table that is not measured by every `make figures`: commits and dates, the oldest first."""
    of = {one.name for one in TABLE if one.kind != "a"}
    found = sorted({(shown[name]["date"], shown[name]["commit"]) for name in names if name in of})
    if not found:
        return ""
    (first, old), (last, new) = found[0], found[-1]
    commits = old if old == new else f"{old} to {new}"
    return f"\n\nMeasured at {commits}, {first if first == last else f'{first} to {last}'}."


def forget():
    """Before other data are shown: what is remembered of those, in modules of pages too."""
    for remembered in (names_for, value, mixed, measured_at):
        remembered.cache_clear()
    for name in [name for name in sys.modules if name.split(".")[0] == "pages"]:
        del sys.modules[name]


def render(page, content):
    """The content with every marker filled from the data."""

    def fill(match):
        if match["code"]:
            return match[0]
        line = content.count("\n", 0, match.start()) + 1
        try:
            text, names = value(page, match["what"])
        except Exception as error:
            raise PageError(f"{page}:{line}: {match['what']}: {error}") from error
        states = mixed(names)
        if states:
            refused.append(f"{page}:{line}: {match['what']}: mixes figures of {states}")
            if match["text"].strip():
                return match[0]
        if text.startswith("| "):
            text += measured_at(names)
        text = f"\n\n{text}\n\n" if "\n" in text else text
        return f"<!--fig {match['what']}-->{text}<!--/-->"

    filled = MARKER.sub(fill, content)
    lone = OPENED.search(MARKER.sub("", content))
    if lone:
        raise PageError(f"{page}: a marker without its end, or an end without its marker")
    return filled


def first_difference(page, content, filled):
    """None, or where the page differs from its data."""
    if content == filled:
        return None
    for number, (old, new) in enumerate(zip(content.split("\n"), filled.split("\n")), 1):
        if old != new:
            return f"{page}:{number}: differs from its data:\n  page  {old}\n  data  {new}"
    return f"{page}: longer or shorter than its data"


def pages():
    """README.md, those of docs, those of studies."""
    found = [*(ROOT / "docs").rglob("*.md"), *ROOT.glob("sim/studies/*/*.md")]
    return [Path("README.md"), *sorted(file.relative_to(ROOT) for file in found)]


def kept(path):
    """What a file holds; nothing when there is none."""
    return (ROOT / path).read_text() if (ROOT / path).exists() else ""


def whole(path, make):
    """The text of a file that holds figures only; what it is when it would mix what different sources measured."""
    entries_read.clear()
    try:
        text = make()
    except Exception as error:
        raise PageError(f"{path}: {error}") from error
    states = mixed(frozenset(entries_read))
    if states:
        refused.append(f"{path}: mixes figures of {states}")
    return kept(path) if states else text


def wholes():
    """{file: what makes it}: energy.csv, and what modules of pages draw (DRAWN)."""
    found = {Path(tables.ENERGY): tables.energy}
    for module in filter(None, map(module_of, pages())):
        found |= {Path("docs/images") / name: make for name, make in getattr(module, "DRAWN", {}).items()}
    return found


def filled(entries):
    """({page: its text}, {name: node}): pages and whole files from these entries, and what was read of each."""
    forget()
    refused.clear()
    shown.clear()
    shown.update(entries)
    nodes = grow(entries)
    texts = {page: render(page, (ROOT / page).read_text()) for page in pages()}
    return texts | {path: whole(path, make) for path, make in wholes().items()}, nodes
