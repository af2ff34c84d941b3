# SPDX-License-Identifier: Apache-2.0
"""Figures of docs/trust/trust.md: the window of gates, lines never executed, and the last full runs."""

from data import data
from formats import group, table
from markers import shown

MEASURED = ["netlist/*", "coverage/*", "runs/*", "proofs/all"]
WINDOW = data.netlist.fast_3_3


def covered():
    """What no frame has executed, by module."""
    rows = [[f"`{name}`", one.never, one.of, one.lines] for name, one in data.coverage.fast.never.items()]
    return table(["module", "never", "of", "lines"], rows)


def names(of):
    return f" ({', '.join(f'`{name}`' for name in of)})" if len(of) else ""


def mutants():
    run = data.runs.mutants
    return f"{group(run.caught)} of {group(run.run)} caught{names(run.left)}"


def proofs():
    rows = data.proofs.all.values()
    return f"{len(rows)} proofs, {sum(row.mutants for row in rows)} mutants refuted"


def tests(name):
    run = data.runs[name]
    return f"{run.passed} passed, {len(run.skipped)} skipped, {len(run.failed)} failed{names(run.failed)}"


def said(name, what, *of):
    """What is kept of a run, when one is."""
    return what(*of) if name in shown else "no run is kept"


def when(name):
    if name not in shown:
        return "-"
    entry = shown[name]
    hours = f"{entry['seconds'] / 3600:.1f} h"
    return f"{entry['date']}, {entry['commit']}, RTL {entry['by']['rtl']}, {hours}"
