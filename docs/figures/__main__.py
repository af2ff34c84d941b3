# SPDX-License-Identifier: Apache-2.0
"""python3 docs/figures [--page NAME] [--only NAMES] [--all] | --fill | --check | --stamp TABLE: figures kept true.

Without an option it measures what is older than the sources, stores it under docs/data and fills the pages.
"""
import argparse
import collections
import datetime
import fnmatch
import json
import os
import shlex
import subprocess
import sys
import time
from pathlib import Path

import markers
from data import store, stored
from lint import complaints
from measurements import TABLE
from scenes import prepared, reference
from sources import CSV, ROOT, csv_older, csv_stamp, measured_by, older_than


def command_line(one, scene, build):
    """The words of a measurement's command as they are run."""
    words = []
    for word in shlex.split(one.command):
        view = ["--view", str(one.view)] if scene and one.view is not None else []
        words += [*scene, *view] if word == "{scene}" else [word]
    words = [str(reference(one.scene, one.view)) if word == "{reference}" else word for word in words]
    words = [str(build / word.removeprefix("build/")) if word.startswith("build/") else word for word in words]
    words = [str(ROOT / word) if (ROOT / word).is_file() else word for word in words]
    return words + (["--svg", str(ROOT / "docs/images" / one.chart)] if one.chart else [])


def now():
    """The commit of the sources, and today."""
    words = ["git", "log", "-1", "--format=%h"]
    return subprocess.run(words, cwd=ROOT, capture_output=True, text=True).stdout.strip(), str(datetime.date.today())


def measure(one, build):
    """Runs a measurement and stores it. None, or why there is none."""
    scene = prepared(one.scene, build)
    if scene is None:
        return f"skipped: no scene {one.scene} (set PIPEGS_SHARED)"
    words = command_line(one, scene, build)
    if one.targets:
        subprocess.run(["cmake", "--build", build, "--target", *one.targets], check=True, stdout=sys.stderr)
    # Before the run: an edit during it makes the data older, not newer.
    hashes = measured_by(one.by, one.scene, one.points)
    start, (commit, date) = time.monotonic(), now()
    run = subprocess.run(words, cwd=build, stdout=subprocess.PIPE, text=True)
    seconds = round(time.monotonic() - start, 1)
    if run.returncode not in one.exit_codes:
        return f"failed: exit code {run.returncode}: {one.shown()}"
    try:
        found = json.loads(run.stdout) if run.stdout.lstrip()[:1] in ("{", "[") else run.stdout
        figures = one.read(found) if one.read else found
    except (KeyError, ValueError, TypeError, AttributeError) as error:
        return f"failed: its output has not the figures expected: {error!r}"
    entry = {"by": hashes, "commit": commit, "date": date, "seconds": seconds, "figures": figures}
    store({one.name: entry})
    return None


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


def measure_all(page, only, everything, build):
    known, failed = stored(), 0
    for one in chosen(page):
        if not fnmatch.fnmatch(one.name, only):
            continue
        if one.name in known and not everything and not older_than(known[one.name]):
            print(f"{one.name}: as new as the sources")
            continue
        print(f"{one.name}: {one.shown()}", flush=True)
        reason = measure(one, build)
        if reason:
            print(f"{one.name}: {reason}", flush=True)
            failed += reason.startswith("failed")
    return failed


def fill():
    """Writes the pages, and leaves in the data what they read."""
    entries = stored()
    texts, nodes = markers.filled(entries)
    for page, text in texts.items():
        if text != (ROOT / page).read_text():
            (ROOT / page).write_text(text)
            print(f"{page}: filled")
    pruned = {name: entry | {"figures": nodes[name].pruned()} for name, entry in entries.items()}
    if markers.filled(pruned)[0] != texts:
        print("docs/data: not pruned: from what the pages read they would be other pages", file=sys.stderr)
    elif pruned != entries:
        store({name: entry for name, entry in pruned.items() if entry != entries[name]})


def check():
    """How many pages differ from their data or hold figures of nobody. Older data are printed."""
    found, entries = [], stored()
    for page, text in markers.filled(entries)[0].items():
        content = (ROOT / page).read_text()
        difference = markers.first_difference(page, content, text)
        found += [difference] if difference else []
        found += complaints(page, content)
    planned, older = {one.name for one in TABLE}, collections.defaultdict(list)
    for name, entry in entries.items():
        older[", ".join(older_than(entry))].append(name)
        if name not in planned:
            found.append(f"docs/data: {name}: no measurement of this name in docs/figures/measurements.py")
    for reasons, names in sorted(older.items()):
        if reasons:
            print(f"older than the sources ({reasons}): {len(names)} of docs/data: {' '.join(names)}")
    for path in CSV:
        if csv_older(path):
            print(f"{path}: older than the sources")
    print("\n".join(found), end="\n" if found else "")
    return len(found)


def main():
    parser = argparse.ArgumentParser(prog="figures", description=__doc__.split("\n")[0])
    parser.add_argument("--page", help="measure only what this page shows, e.g. ladder")
    parser.add_argument("--only", default="*", metavar="NAMES", help="of these, the measurements so named: 'sweep/*'")
    parser.add_argument("--all", action="store_true", help="measure what is as new as the sources, too")
    parser.add_argument("--fill", action="store_true", help="measure nothing: write data into pages")
    parser.add_argument("--check", action="store_true", help="measure nothing: 1 when a page differs from its data")
    parser.add_argument("--stamp", metavar="TABLE", choices=CSV, help="write into a table that it was measured now")
    arguments = parser.parse_args()
    if arguments.stamp:
        csv_stamp(arguments.stamp)
        return 0
    if arguments.check:
        return 1 if check() else 0
    if arguments.fill:
        fill()
        return 0
    build = (ROOT / os.environ.get("BUILD", "build")).resolve()
    failed = measure_all(arguments.page, arguments.only, arguments.all, build)
    filled = subprocess.run([sys.executable, Path(__file__).parent, "--fill"]).returncode
    return 3 if failed else filled


if __name__ == "__main__":
    try:
        sys.exit(main())
    except markers.PageError as error:
        print(f"figures: {error}", file=sys.stderr)
        sys.exit(2)
    except (OSError, subprocess.CalledProcessError) as error:
        print(f"figures: {error}", file=sys.stderr)
        sys.exit(3)
