# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/rivals/rivals.md."""
from data import data
from formats import fixed, group, listing, percent, table, times

MEASURED = ["rivals/*"]
SCENES = ("terrace", "own")
RIVALS = data.rivals.terrace.rivals
OURS = ("fast", "dop")


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
    found = data.rivals[scene]
    rows = [[f"`{name}`", *frame_of(found.ours[name], 1e3 / found.ours[name].fps.mid), ""] for name in OURS]
    for one in found.rivals.values():
        rows.append([one.name, *frame_of(one, one.seconds * 1e3), f"{one.bound_by}, {percent(one.bound_share)}"])
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


def scenes(own):
    """One of our machines over each rival, mid: for an area and for a joule with DRAM."""
    figures = {"fps_per_mm2": "frames/s/mm2", "frames_per_joule_with_dram": "frames/J with DRAM"}
    columns = [
        (f"{what}, {scene}", lambda key, s=scene, f=figure: data.rivals[s].against.over[key][own][f].mid, three)
        for figure, what in figures.items()
        for scene in SCENES
    ]
    return listing(f"`{own}` over", [(rival.name, key) for key, rival in RIVALS.items()], *columns)


def packed():
    """Rivals whose Gaussians had the bytes of ours."""
    rows = []
    for key, rival in RIVALS.items():
        found = [
            [one for one in data.rivals[scene].variants if one.rival == key and one.key == "packed"] for scene in SCENES
        ]
        if not found[0]:
            continue
        cells = [rival.name, found[0][0].what]
        for scene, (one,) in zip(SCENES, found):
            as_published = data.rivals[scene].rivals[key].frames_per_joule_with_dram.mid
            ours = data.rivals[scene].ours.fast.frames_per_joule_with_dram.mid
            packed_so = one.frames_per_joule_with_dram
            cells += [three(one.bytes / 1e6), times(packed_so / as_published), three(ours / packed_so)]
        rows.append(cells)
    columns = ("MB", "frames/J with DRAM over as published", "`fast` over it")
    return table(["", "what if", *[f"{one}, {scene}" for scene in SCENES for one in columns]], rows)


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


def areas():
    """mm2 in 28 nm by NAND2, and by the square of the node."""
    rows = [
        [one.name, one.venue, one.node, fixed(one.mm2_published, 3), spread(one.mm2), three(one.mm2_plain)]
        for one in RIVALS.values()
    ]
    return table(["model", "venue", "node", "mm2, published", "in 28 nm", "plain square"], rows)
