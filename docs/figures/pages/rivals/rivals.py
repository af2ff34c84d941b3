# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/rivals/rivals.md."""
from data import data
from formats import fixed, group, percent, table, times

MEASURED = ["rivals/*", "pipelines/*"]
SCENES = ("terrace", "statue", "flowers", "plushdog", "own")
TITLES = {"own": "our own"}
RIVALS = data.rivals.terrace.rivals
OURS = ("dop", "fast")
MARKS = {"fps_per_mm2": 3.34, "frames_per_joule": 2.77}  # the paper's, Figs. 10 and 11
NAMES = {"fps_per_mm2": "frames/s/mm2, 3.34x", "frames_per_joule": "frames/J of the chip, 2.77x"}


def three(value):
    """Three digits."""
    if value == 0:
        return "0"
    digits = 2
    while digits > 0 and abs(value) >= 10 ** (3 - digits):
        digits -= 1
    return f"{value:.{digits}f}" if abs(value) >= 1 else f"{value:.3g}"


def spread(range_):
    if range_.low == range_.high:
        return three(range_.mid)
    return f"{three(range_.mid)} ({three(range_.low)} to {three(range_.high)})"


def frame_of(one, ms):
    """Of a machine on a view: what rivals and ours have alike."""
    return [
        group(round(one.cycles)),
        fixed(ms, 2),
        three(one.fps.mid),
        three(one.bytes / 1e6),
        three(one.mm2.mid),
        spread(one.fps_per_mm2),
        spread(one.frames_per_joule),
        spread(one.frames_per_joule_with_dram),
    ]


def machines(scene):
    """All machines on one view."""
    found, rows = data.rivals[scene], []
    for one in found.rivals.values():
        rows.append([one.name, *frame_of(one, one.seconds * 1e3), f"{one.bound_by}, {percent(one.bound_share)}"])
    printed = found.printed
    rows.append(["PipeGS, printed", "", "", "", "", fixed(printed.mm2, 3), "", "", "", ""])
    for name, one in found.ours.items():
        rows.append([f"`{name}`", *frame_of(one, 1e3 / one.fps.mid), ""])
    header = ["machine", "cycles", "ms", "frames/s", "MB", "mm2", "frames/s/mm2", "frames/J, chip", "with DRAM"]
    return table([*header, "bound by"], rows)


def against(scene, figure):
    """What the papers' ratios come to when they are multiplied, and this view's."""
    rows = []
    for key, one in data.rivals[scene].against.over.items():
        chained = one.chained.get(figure)
        cells = [spread(one[own][figure]) for own in OURS]
        rows.append([RIVALS[key].name, times(chained) if chained else "", *cells])
    return table(["over", "chained", *[f"`{own}`" for own in OURS]], rows)


def scenes(own, figure):
    """One of our machines over each rival, mid, on every scene."""
    rows = []
    for key, rival in RIVALS.items():
        rows.append([rival.name, *[three(data.rivals[scene].against.over[key][own][figure].mid) for scene in SCENES]])
    return table([f"`{own}` over", *[TITLES.get(scene, scene) for scene in SCENES]], rows)


def marks(own="fast"):
    """The most that the paper prints: over which rivals and on how many scenes one of ours reaches it; what lacks."""
    rows = []
    for key, rival in RIVALS.items():
        row = [rival.name]
        for figure, mark in MARKS.items():
            over = [data.rivals[scene].against.over[key][own][figure] for scene in SCENES]
            least = min(one.mid for one in over)
            row += [
                f"{sum(one.mid >= mark for one in over)} of {len(over)}",
                f"{sum(one.high >= mark for one in over)} of {len(over)}",
                times(mark / least) if least < mark else "",
            ]
        rows.append(row)
    head = [part for name in NAMES.values() for part in (f"{name}: scenes at mid", "scenes at best", "lacks")]
    return table([f"`{own}` over", *head], rows)


def checks(name="terrace"):
    """Each model against published figures."""
    rows = []
    for one in data.rivals[name].checks:
        bound = "at most " if one.at_most else ""
        unit = one.unit if one.unit == "x" else " " + one.unit
        rows.append(
            [
                one.rival,
                one.figure,
                f"{bound}{three(one.published)}{unit}",
                f"{three(one.ours)}{unit}",
                fixed(one.ratio, 2),
                "set" if one.chosen else "yes" if one.passes else "no",
                one.why,
            ]
        )
    return table(["model", "figure", "published", "ours", "ratio", "within 15 %", "why"], rows)


def passed(name="terrace"):
    """How many of the figures pass, of how many."""
    found = [one for one in data.rivals[name].checks if not one.chosen]
    return f"{sum(one.passes for one in found)} of {len(found)}"


def parameters():
    """What has a range, and what each end is worth."""
    rows = []
    for one in RIVALS.values():
        for name, it in one.parameters.items():
            if it.low == it.high:
                continue
            value = [f"{it[end]:g}" for end in ("low", "value", "high")]
            ends = [three(it.fps_at_low), three(it.fps_at_high)]
            rows.append(
                [one.name, f"`{name}`, {it.unit}" if it.unit else f"`{name}`", *value, it.mark, *ends, it.source]
            )
    header = ["model", "parameter", "low", "mid", "high", "mark", "frames/s at low", "at high", "what, and where from"]
    return table(header, rows)


def read():
    """What is read in the papers."""
    rows = []
    for one in RIVALS.values():
        for name, it in one.parameters.items():
            if it.low == it.high:
                unit = f" {it.unit}" if it.unit else ""
                rows.append([one.name, f"`{name}`", f"{it.value:g}{unit}", it.mark, it.source])
    return table(["model", "parameter", "value", "mark", "what, and where from"], rows)


def areas():
    """mm2 in 28 nm by NAND2, and by the square of the node."""
    rows = [
        [one.name, one.venue, one.node, fixed(one.mm2_published, 3), spread(one.mm2), three(one.mm2_plain)]
        for one in RIVALS.values()
    ]
    return table(["model", "venue", "node", "mm2, published", "in 28 nm", "plain square"], rows)


def kinds(scene):
    """MB by kind of flow."""
    found = data.rivals[scene].rivals
    names = sorted({kind for one in found.values() for kind in one.bytes_by_kind})
    rows = []
    for one in found.values():
        rows.append([one.name, *[three(one.bytes_by_kind.get(kind, 0) / 1e6) for kind in names]])
    return table(["MB", *names], rows)


def pipelines(scene):
    """Of the paper's Fig. 1: the time of a frame, and how much of it each kind of unit works."""
    rows = [
        [machine, group(one.us), ", ".join(f"{unit} {percent(share)}" for unit, share in one.busy.items())]
        for machine, one in data.pipelines[scene].items()
    ]
    return table(["machine", "us", "share of the frame in which units work"], rows)
