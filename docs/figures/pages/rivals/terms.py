# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/rivals/terms.md."""
from data import data
from formats import change, fixed, percent, span, table, times
from measurements import FOUR
from pages.rivals import printed

MEASURED = ["terms/*", "ladder/*", *printed.MEASURED]
FIVE = (*FOUR, "plushdog")
RUNGS = (("baseline", "baseline"), ("hgr", "tspp"), ("dop", "dop"))  # of the model; of the RTL
SPEEDS = (("hgr", 2.33), ("dop_over_hgr", 1.22), ("dop", 2.85))
RATIOS = (("ratio_baseline", 7.48), ("ratio_dpc", 5.71), ("ratio_hgr", 1.83))
KEYS = [key for key, _ in (*SPEEDS, *RATIOS)]
HEAD = ["HGR", "DOP / HGR", "DOP", "r/s Baseline", "r/s DPC", "r/s HGR"]
SORTS = {"wide": "16 keys", "splitter": "a key", "network": "8 exchanges", "compare": "a comparison"}
SORTS["exchange"] = "an exchange"


def cells(ladder):
    """Speed-ups and raster / sort of one ladder."""
    return [fixed(ladder[key], 2) for key in KEYS]


def paper_cells():
    return [fixed(value, 2) for _, value in (*SPEEDS, *RATIOS)]


def closed():
    """The paper's figures held against each other."""
    rows = [
        [row.figure, row.equation, fixed(row.value, 3), f"{row.paper:g}", change(row.residue)]
        for row in data.terms.terrace.closed
    ]
    return table(["figure", "equation", "gives", "paper", "residue"], rows)


def closed_of(start, place=0):
    """The value of a row of the closed form, by how its figure begins."""
    return [row for row in data.terms.terrace.closed if row.figure.startswith(start)][place].value


def lead():
    """Cycles of a key: what raster / sort = 7.48 asks for, and what sorters take."""
    rows = [
        [
            scene if row is data.terms[scene].lead[0] else "",
            row.work,
            fixed(row["keys"], 0),
            *[fixed(row.needed[lane], 1) for lane in ("pixel", "area", "serial")],
            *[fixed(row.sorts[sort], 1) for sort in SORTS],
        ]
        for scene in FIVE
        for row in data.terms[scene].lead
    ]
    head = ["scene", "pixels", "keys of a list", "asked: a pixel a cycle", "equal area", "an operation a cycle"]
    return table([*head, *(f"sorter of {name} a cycle" for name in SORTS.values())], rows)


def ours():
    """The model under our own terms beside the RTL."""
    rows = []
    for scene in FOUR:
        for name, point in RUNGS:
            model, rtl = data.terms[scene].ours[name], data.ladder[scene][point]
            rows.append(
                [
                    scene if name == "baseline" else "",
                    f"`{point}`",
                    round(model.cycles),
                    rtl.cycles,
                    change(model.cycles / rtl.cycles - 1),
                    fixed(model.raster / model["sort"], 2),
                    fixed(rtl.raster_over_sort, 2),
                    fixed(model.bytes / 1e6, 1),
                    fixed(rtl.bytes / 1e6, 1),
                ]
            )
    head = ["scene", "design point", "model, cycles", "RTL", "error", "raster / sort, model", "RTL", "MB, model"]
    return table(head + ["RTL"], rows)


def error(name, point):
    """The span of the model's errors over the scenes."""
    found = [data.terms[scene].ours[name].cycles / data.ladder[scene][point].cycles - 1 for scene in FOUR]
    return span(percent, found)


def waterfall(scene):
    """From our terms to the paper's."""
    rows = []
    for row in data.terms[scene].waterfall:
        if not row.assumption:
            rows.append([row.value, "", *cells(row.together)])
            continue
        rows.append([f"{row.assumption}: {row.value}", "alone", *cells(row.alone)])
        rows.append(["", "so far", *cells(row.together)])
        rows.append(["", "without", *cells(row.without)])
    rows.append(["the paper", "", *paper_cells()])
    return table(["switched", "", *HEAD], rows)


def search():
    """How many sets give the paper's figures, and which is nearest."""
    rows = []
    for scene in FIVE:
        found = data.terms[scene].search
        rows.append(
            [
                scene,
                found.sets,
                found.speeds.sets,
                found.all.sets,
                percent(found.nearest.worst_miss, 1),
                percent(found.together_worst_miss, 1),
                *cells(found.together.ladder),
            ]
        )
    rows.append(["the paper", *[""] * 5, *paper_cells()])
    head = ["scene", "sets", "speed-ups within 10 %", "raster / sort too", "nearest: speed-ups", "all six"]
    return table([*head, *HEAD], rows)


def values(which):
    """Which values the sets have that give the figures: share of each, where not all have one."""
    scenes = [scene for scene in FIVE if data.terms[scene].search[which].sets]
    rows = []
    for one in data.terms.terrace.assumptions:
        row = [one.key]
        for scene in scenes:
            tally = data.terms[scene].search[which]
            shares = sorted(((count / tally.sets, name) for name, count in tally["values"][one.key].items()))[::-1]
            row.append(", ".join(f"{name} ({percent(share)})" if share < 1 else name for share, name in shares))
        rows.append(row)
    return table(["assumption", *(f"{scene}, {data.terms[scene].search[which].sets} sets" for scene in scenes)], rows)


def figures():
    """The paper's figures and what its terms give on each view."""
    names = data.terms.terrace.paper.figures
    rows = [
        [one.what, fixed(one.paper, 2), *[fixed(data.terms[scene].paper.figures[key].here, 2) for scene in FIVE]]
        for key, one in names.items()
    ]
    return table(["figure", "paper", *FIVE], rows)


def slower(rung):
    """How many times as long as our baseline a rung takes under the paper's terms."""
    found = [data.terms[scene].paper.rungs[rung].cycles / data.ladder[scene].baseline.cycles for scene in FOUR]
    return span(fixed, found, 0)


def alphas(key):
    found = [data.terms[scene].paper[key] for scene in FIVE]
    return f"{span(fixed, found, 0)} MB"


def bubbles():
    """How many fewer bubbles of the SUs HGR leaves, over the views."""
    found = [1 - data.terms[scene].paper.figures.gap_left.here for scene in FIVE]
    return span(percent, found)


def assumptions():
    """Each assumption, what the paper says of it, ours and the paper's."""
    rows = [[one.key, one.what, one.words, one.ours, one.paper] for one in data.terms.terrace.assumptions]
    return table(["assumption", "what", "the paper", "ours", "`pipegs terms`"], rows)


def row_of(assumption):
    """The waterfall's row of terrace."""
    return [row for row in data.terms.terrace.waterfall if row.assumption == assumption][0]


def speed(ladder, key):
    return times(ladder[key])
