# SPDX-License-Identifier: Apache-2.0
"""python3 docs/figures [--page NAME] [--only NAMES] [--classes a,b,c] | --fill | --check: true figures.

Without an option it measures what is cheap, and what is older than the sources, stores it under docs/data and fills the
pages.
"""
import argparse
import collections
import datetime
import fnmatch
import os
import signal
import subprocess
import sys
from pathlib import Path

import markers
import tables
from data import store, stored
from equal import unequal
from lint import complaints
from measurements import TABLE
from run import again, planned, prepare, run_all
from sources import ROOT


def chosen(page):
    """The measurements of a page, or all: those that the page's module names."""
    if page is None:
        return TABLE
    paths = [path for path in markers.pages() if markers.name_of(path) == page]
    module = markers.module_of(paths[0]) if paths else None
    if module is None:
        names = sorted(path.stem for path in (Path(__file__).parent / "pages").rglob("*.py"))
        raise markers.PageError(f"--page {page}: expected one of {', '.join(names)}")
    return [one for one in TABLE if any(fnmatch.fnmatch(one.name, name) for name in module.MEASURED)]


def measure_all(arguments, build):
    """The names of those that failed. Class c comes first: models read what it leaves in synth/data."""
    entries, classes = stored(), arguments.classes.split(",")
    table = [one for one in chosen(arguments.page) if fnmatch.fnmatch(one.name, arguments.only) and one.kind in classes]
    if not table:
        raise markers.PageError(
            f"--only {arguments.only}: no measurement of the classes {arguments.classes} is so named"
        )
    found, failed = planned(table, entries, arguments.all), []
    prepare(found, build)
    try:
        if "c" in classes and not arguments.page and arguments.only == "*":
            tables.measure(build)
        slow = [one for one in found if one.kind == "c"]
        if slow:
            failed += run_all(slow, entries, build)
            fill()
        failed += run_all([one for one in found if one.kind != "c"], entries, build)
    except KeyboardInterrupt:
        print("\nstopped: what has ended is stored", flush=True)
    return failed


def fill():
    """Writes the pages, and leaves in the data what they read. 2 when a marker is refused, else 0."""
    entries = stored()
    texts, nodes = markers.filled(entries)
    refused = list(markers.refused)
    for page, text in texts.items():
        if text != markers.kept(page):
            (ROOT / page).write_text(text)
            print(f"{page}: filled")
    pruned = {name: entry | {"figures": nodes[name].pruned()} for name, entry in entries.items()}
    if markers.filled(pruned)[0] != texts:
        print("docs/data: not pruned: from what the pages read they would be other pages", file=sys.stderr)
    elif pruned != entries:
        store({name: entry for name, entry in pruned.items() if entry != entries[name]})
    print("\n".join(refused), end="\n" if refused else "", file=sys.stderr)
    return 2 if refused else 0


def stale(entries, classes):
    """Entries of these classes that today's sources would measure anew, and why."""
    reasons = collections.defaultdict(list)
    for one in TABLE:
        if one.kind in classes:
            older = one.older(entries[one.name]) if one.name in entries else ["never measured"]
            kinds = dict.fromkeys(name if name == "never measured" else name.split(" ")[0] for name in older)
            reasons[one.kind, ", ".join(kinds)].append(one.name)
    return [f"stale ({kind}: {why}): {' '.join(names)}" for (kind, why), names in sorted(reasons.items()) if why]


def differing(entries):
    """Where pages differ from their data, and figures of nobody."""
    found = []
    for page, text in markers.filled(entries)[0].items():
        content = markers.kept(page)
        difference = markers.first_difference(page, content, text)
        found += [difference] if difference else []
        found += complaints(page, content) if page.suffix == ".md" else []
    planned = {one.name for one in TABLE}
    unknown = sorted(entries.keys() - planned)
    return found + [f"docs/data: {name}: no measurement of this name in measurements.py" for name in unknown]


def check(arguments):
    """Prints what is wrong: of pages and their data, what is stale, or both."""
    entries, found = stored(), []
    if arguments.check in ("all", "pages"):
        found += differing(entries)
    if arguments.check in ("all", "stale"):
        found += stale(entries, arguments.classes)
    if arguments.check == "all":
        found += markers.refused
        found += [*tables.stale().values(), *unequal(entries)]
    print("\n".join(found), end="\n" if found else "")
    return len(found)


def main():
    parser = argparse.ArgumentParser(prog="figures", description=__doc__.split("\n")[0])
    parser.add_argument("--page", help="measure only what this page shows, e.g. ladder")
    parser.add_argument("--only", default="*", metavar="NAMES", help="of these, the measurements so named: 'model/*'")
    parser.add_argument("--classes", default="a,b,c", help="of these, or of what --check calls stale, classes: a,b")
    parser.add_argument("--all", action="store_true", help="measure b and c too where they are as new as the sources")
    parser.add_argument("--fill", action="store_true", help="measure nothing: write data into pages")
    parser.add_argument(
        "--check",
        nargs="?",
        const="all",
        choices=("all", "pages", "stale"),
        help="measure nothing: print what is wrong, of pages and their data or stale; 1 when it is",
    )
    parser.add_argument("--again", metavar="COUNT", type=int, help="measure so many quick entries anew, compare them")
    parser.add_argument("--day", default=str(datetime.date.today()), help="that chooses those; today")
    arguments = parser.parse_args()
    if arguments.check:
        return 1 if check(arguments) else 0
    if arguments.fill:
        return fill()
    build = (ROOT / os.environ.get("BUILD", "build")).resolve()
    os.environ.pop("PIPEGS_DAY", None)  # figures are those of the default seed
    if arguments.again:
        return 1 if again(TABLE, stored(), arguments.again, arguments.day, build) else 0
    failed = measure_all(arguments, build)
    filled = fill()
    if failed:
        print(f"failed: {' '.join(failed)}")
    return 3 if failed else filled


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # as control-C: ends what was started
    try:
        sys.exit(main())
    except markers.PageError as error:
        print(f"figures: {error}", file=sys.stderr)
        sys.exit(2)
    except (OSError, subprocess.CalledProcessError) as error:
        print(f"figures: {error}", file=sys.stderr)
        sys.exit(3)
