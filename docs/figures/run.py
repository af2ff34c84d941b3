# SPDX-License-Identifier: Apache-2.0
"""Runs measurements, two at once, and stores each as it ends: who stops it loses only what is running."""
import concurrent.futures
import datetime
import json
import random
import re
import shlex
import shutil
import subprocess
import sys
import threading
import time

from data import store
from measurement import CLASSES
from measurements import TABLE
from scenes import levels, prepared, reference, truth
from sources import ROOT, find_modules

AT_ONCE = 2
SVG = ROOT / "sim/report/page/svg.sh"
JSON = re.compile(r"\s*({|\[[^=])")  # how it begins; GoogleTest's output does with [===
QUICK = 20  # seconds of one that the tests measure again
TIMES = {"seconds", "wall_seconds", "host", "khz", "speed_ratio"}  # keys of what the computer took
UNKNOWN = 60  # seconds of one that was never measured
shared = threading.Lock()  # of what measurements have in common: scenes, the libraries of charts
running = {}  # process: name of its measurement


def command_line(one, scene, build):
    """The words of a measurement's command as they are run."""
    view = ["--view", str(one.view)] if scene and one.view is not None else []
    stands_for = {
        "{scene}": lambda: [*scene, *view],
        "{levels}": lambda: levels(one.scene),
        "{reference}": lambda: [str(reference(one.scene, one.view))],
        "{truth}": lambda: [str(truth(one.scene, build))],
    }
    words = [word for part in shlex.split(one.command) for word in stands_for.get(part, lambda: [part])()]
    words = [str(build / word.removeprefix("build/")) if word.startswith("build/") else word for word in words]
    words = [str(ROOT / word) if (ROOT / word).is_file() else word for word in words]
    return words


def draw(one, charts, build):
    """The chart and the picture of a measurement, in docs/images."""
    if one.chart:
        with shared:
            words = [SVG, build / "page"]
            drawn = subprocess.run(
                words, input=json.dumps(charts), stdout=subprocess.PIPE, text=True, check=True
            ).stdout
        (ROOT / "docs/images" / one.chart).write_text(drawn)
    if one.picture:
        image, written = one.picture
        shutil.copyfile(build / written, ROOT / "docs/images" / image)


def execute(one, build, drawn=False):
    """(its figures, "") or (None, why there are none); what it draws is drawn when that is asked for."""
    with shared:
        scene = prepared(one.scene, build)
        if scene is None:
            return None, f"skipped: no scene {one.scene} (set PIPEGS_SHARED)"
        words = command_line(one, scene, build)
    process = subprocess.Popen(words, cwd=build, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    running[process] = one.name
    printed, said = process.communicate()
    del running[process]
    if process.returncode not in one.exit_codes:
        log = build / "figures" / f"{one.name.replace('/', '_')}.log"
        log.parent.mkdir(exist_ok=True)
        log.write_text(printed + said, encoding="utf-8")
        return None, f"failed: exit code {process.returncode}: {one.shown()}\n{said[-1000:]}\nits output: {log}"
    try:
        found = json.loads(printed) if JSON.match(printed) else printed
        charts = found.pop("charts", None) if isinstance(found, dict) else None
        if drawn:
            draw(one, charts, build)
        return one.read(found) if one.read else found, ""
    except (KeyError, ValueError, TypeError, AttributeError, OSError, subprocess.CalledProcessError) as error:
        return None, f"failed: its output has not the figures expected: {error!r}"


def measure(one, build, commit):
    """Runs a measurement and stores it. What is to be said of it."""
    hashes = one.hashes()  # before the run: an edit during it makes the data older, not newer
    start = time.monotonic()
    figures, reason = execute(one, build, drawn=True)
    if reason:
        return reason
    seconds = time.monotonic() - start
    today = str(datetime.date.today())
    store({one.name: {"by": hashes, "commit": commit, "date": today, "seconds": round(seconds, 1), "figures": figures}})
    return f"{seconds:.1f} s"


def duration(seconds):
    minutes = round(seconds / 60)
    return f"{minutes // 60} h {minutes % 60} min" if minutes >= 60 else f"{minutes} min" if minutes else "below 1 min"


def last(one, entries):
    return entries.get(one.name, {}).get("seconds", UNKNOWN)


def planned(table, entries, everything):
    """The measurements to run, the longest first; prints how many, and what they took last time."""
    found = [one for one in table if one.kind == "a" or everything or one.older(entries.get(one.name, {"by": {}}))]
    for kind, what in CLASSES.items():
        of, runs = [[one for one in ones if one.kind == kind] for ones in (table, found)]
        unknown = sum("seconds" not in entries.get(one.name, {}) for one in runs)
        took = sum(last(one, entries) for one in runs) / (AT_ONCE if kind < "c" else 1)
        note = f", {unknown} of them never timed (a minute each)" if unknown else ""
        print(f"({kind}) {what}: {len(runs)} of {len(of)} run, {duration(took)} as last time{note}", flush=True)
    return sorted(found, key=lambda one: (one.alone, -last(one, entries)))


def rtl_machines(ones):
    parts = {part.removeprefix("rtl ") for one in ones for part in one.parts() if part.startswith("rtl ")}
    return {machine for machine in parts if not machine.startswith("of ")}


def prepare(ones, build):
    """What the measurements have in common: programs of today's sources, the modules of their machines."""
    targets = {"programs", "package_sv", *(target for one in ones for target in one.targets)}
    subprocess.run(["cmake", "--build", build, "--target", *sorted(targets)], check=True, stdout=sys.stderr)
    machines = rtl_machines(TABLE)
    for machine in sorted(rtl_machines(ones)):
        find_modules(machine, machines, build)


def run_all(ones, entries, build):
    """Runs them; the names of those that failed. One that takes times, and each of class c or d, runs alone."""
    commit = subprocess.run(
        ["git", "log", "-1", "--format=%h"], cwd=ROOT, capture_output=True, text=True
    ).stdout.strip()
    left, failed, number = list(ones), [], 0
    terminal = sys.stderr.isatty()
    with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
        active = {}  # future: measurement, when it began
        try:
            while left or active:
                while left and len(active) < AT_ONCE:
                    by_itself = [
                        one.alone or one.kind >= "c" for one in (left[0], *(one for one, _ in active.values()))
                    ]
                    if active and any(by_itself):
                        break
                    one = left.pop(0)
                    active[pool.submit(measure, one, build, commit)] = one, time.monotonic()
                done, _ = concurrent.futures.wait(active, 1, concurrent.futures.FIRST_COMPLETED)
                for future in done:
                    one, _ = active.pop(future)
                    number += 1
                    said = future.result()
                    failed += [one.name] if said.startswith("failed") else []
                    print(f"{chr(13) * terminal}{number} of {len(ones)}  {one.name}: {said}", flush=True)
                if terminal:
                    rest = sum(last(one, entries) for one in left) + sum(
                        max(0, last(one, entries) - time.monotonic() + began) for one, began in active.values()
                    )
                    names = ", ".join(one.name for one, _ in active.values())
                    line = f"{number} of {len(ones)}, about {duration(rest / AT_ONCE)} left: {names}"
                    print(f"\r{line[:110]:110}", end="", file=sys.stderr, flush=True)
        except KeyboardInterrupt:
            for process in list(running):
                process.terminate()
            raise
    return failed


def difference(kept, found, place=""):
    """Where what is found now is not what is kept of it; None when it is."""
    if isinstance(kept, dict) and isinstance(found, dict):
        pairs = [(key, one, found.get(key)) for key, one in kept.items() if key not in TIMES]
    elif isinstance(kept, list) and isinstance(found, list):
        if kept and len(kept) != len(found):
            return f"{place} has {len(found)} elements, {len(kept)} are kept"
        pairs = [(at, one, found[at]) for at, one in enumerate(kept)]
    else:
        return None if kept == found else f"{place} is {found}, {kept} is kept"
    return next(filter(None, (difference(one, new, f"{place}.{key}") for key, one, new in pairs)), None)


def again(table, entries, count, day, build):
    """Measures some entries anew that are quick and need no scene; how many are not what is kept of them."""
    quick = [one for one in table if one.kind == "a" and one.scene == "own" and not one.alone and not one.targets]
    quick = [one for one in quick if entries.get(one.name, {}).get("seconds", QUICK) < QUICK]
    wrong = 0
    for one in random.Random(day).sample(quick, min(count, len(quick))):
        figures, reason = execute(one, build)
        reason = reason or difference(entries[one.name]["figures"], figures)
        print(f"{one.name}: {reason or 'as it is kept'}", flush=True)
        wrong += bool(reason)
    print(f"the same again: python3 docs/figures --again {count} --day {day}; `make figures` measures all")
    return wrong
