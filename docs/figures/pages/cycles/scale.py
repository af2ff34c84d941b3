# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/cycles/scale.md."""
from data import data
from formats import fixed, group, listing, millions, percent, table, times
from measurements import EIGHT, GAINED, LEFT_OUT, SIX, TRADED
from pages.frames import PINS, SCENE_NAMES, total_bytes

MEASURED = [
    "rtl/*_fast",
    "rtl/terrace_wide",
    "gains/*",
    "prices/*",
    "wide/*",
    "scale/*",
    "silicon/terrace_*",
    "prints/all",
]
KINDS = {"nodes": "nodes", "geometry": "geometry", "color": "colours", "sort_overflow": "sorting", "raster": "pixels"}


def frame(scene):
    return data.rtl[f"{scene}_fast"]


def floor(scene):
    """Cycles of 64 lanes that blend the pairs that must be blended, and nothing else."""
    return frame(scene).work.blended / 64


def scenes():
    """`fast`, a whole frame of each scene in RTL: cycles, multiple of the floor, share of the lanes, bytes by kind."""

    def megabytes(scene, kind):
        return total_bytes({kind: frame(scene).memory.by_stream[kind]}) / 1e6

    return listing(
        "scene",
        [(SCENE_NAMES[scene], scene) for scene in SIX],
        ("Gaussians", lambda scene: frame(scene).scene.gaussians, group),
        ("cycles", lambda scene: frame(scene).cycles, group),
        ("x floor", lambda scene: frame(scene).cycles / floor(scene), fixed, 2),
        ("lanes that blend", lambda scene: percent(floor(scene) / frame(scene).cycles)),
        *[(f"{what}, MB", lambda scene, kind=kind: megabytes(scene, kind), fixed, 1) for kind, what in KINDS.items()],
    )


def loads():
    """What each unit does in a cycle of those frames, the mean of its four, and how full the pins are."""

    def share(scene, unit, state):
        units = frame(scene).units[unit]
        return percent(sum(one[state] for one in units) / (len(units) * frame(scene).cycles))

    def pins(scene):
        return percent(total_bytes(frame(scene).memory.by_stream) / (PINS * frame(scene).cycles))

    return listing(
        "busy",
        [(SCENE_NAMES[scene], scene) for scene in SIX],
        *[(unit.upper(), lambda scene, unit=unit: share(scene, unit, "busy")) for unit in ("dopu", "pu", "su", "ru")],
        ("bytes over the pins", pins),
    )


def most_sorting():
    """The largest share of all bytes that sorting takes, and where."""
    shares = {}
    for scene in SIX:
        streams = frame(scene).memory.by_stream
        shares[scene] = total_bytes({"sort": streams.sort_overflow}) / total_bytes(streams)
    worst = max(shares, key=shares.get)
    return f"at most {percent(shares[worst], 1)}, in {worst}" if shares[worst] else "none"


def gains():
    """Cycles and megabytes of `fast` without one of its steps."""
    what = {
        "whole": "windows always walked whole (`--walk-most 0`)",
        "occlusion": "nothing left out behind what is opaque (`occlusion=0`)",
        "pace": "a Gaussian every eight cycles (`pace=8`)",
        "fronts": "one PU that fetches and culls (`fronts=1`)",
        "buckets": "buckets of depth twice as wide (`bucket_bits=6`)",
    }

    def cell(scene, name):
        row = data.gains[f"{scene}_{name}"].designs[0]
        return f"{group(row.cycles)}, {fixed(total_bytes(row.bytes) / 1e6, 1)} MB"

    rows = [
        [
            "`fast`",
            *[
                f"{group(frame(scene).cycles)}, {fixed(total_bytes(frame(scene).memory.by_stream) / 1e6, 1)} MB"
                for scene in GAINED
            ],
        ]
    ]
    rows += [[what[name], *[cell(scene, name) for scene in GAINED]] for name in LEFT_OUT]
    return table(["", *GAINED], rows)


def prices():
    """`fast` and each change of it: area, clock, and what a frame takes."""
    machines = {scene: data.prices[scene].machines for scene in ("own", "showroom")}

    def area(i):
        """With ~ where no such machine was synthesised, nor one on each side of it."""
        silicon = machines["own"][i].silicon
        return ("~" if silicon.extrapolated_area else "") + fixed(silicon.mm2.mid, 3)

    def frame_of(scene):
        return [
            (f"{scene}: cycles", lambda i: machines[scene][i].cycles, group),
            ("MB", lambda i: machines[scene][i].megabytes, fixed, 1),
            ("mJ", lambda i: machines[scene][i].mj, fixed, 2),
        ]

    return listing(
        "",
        [(f"`{name}`", i) for i, name in enumerate(("fast", *TRADED))],
        ("mm2", area),
        ("GHz", lambda i: machines["own"][i].ghz, fixed, 3),
        *frame_of("own"),
        *frame_of("showroom"),
    )


def wide():
    """`wide` on eight channels of memory beside `fast` on four."""

    def design(scene):
        return data.wide[scene].designs[0]

    return listing(
        "scene",
        [(SCENE_NAMES[scene], scene) for scene in EIGHT],
        ("`fast`, cycles", lambda scene: frame(scene).cycles, group),
        ("`wide`, cycles", lambda scene: design(scene).cycles, group),
        ("times as fast", lambda scene: frame(scene).cycles / design(scene).cycles, times),
        ("x floor of 128 lanes", lambda scene: 2 * design(scene).cycles / floor(scene), fixed, 2),
        ("MB", lambda scene: total_bytes(design(scene).bytes) / 1e6, fixed, 1),
    )


def wide_rtl():
    found = data.rtl.terrace_wide
    return f"{group(found.cycles)} cycles, {group(found.mismatches)} mismatches"


def wide_area():
    """mm2 of `wide`, and over that of `fast`."""
    mm2 = {name: data.silicon[f"terrace_{name}"].designs[0] for name in ("fast", "wide")}
    wide, fast = (next(row for row in mm2[name].rows if row.name == "Total").area_mm2.mid for name in ("wide", "fast"))
    return f"{fixed(wide, 2)} mm2, {times(wide / fast)} `fast`"


def wide_rate():
    """Frames a second and mm2 of `wide` over those of `fast`, terrace."""
    wide, fast = (data.silicon[f"terrace_{name}"].designs[0] for name in ("wide", "fast"))
    return times(wide.fps_per_mm2 / fast.fps_per_mm2)


def scale():
    """Computer and machine by the number of Gaussians and pixels."""
    rows = []
    for name in ("1m", "4m", "16m", "4k"):
        run, model = data.scale[f"sim_{name}"], data.scale[f"model_{name}"]
        seconds, row = run.host.cpu_seconds, model.designs[0]
        rest = seconds["all"] - seconds.pack - seconds.golden - seconds.truth
        rows.append(
            [
                millions(run.scene.gaussians, 0),
                millions(run.camera.width * run.camera.height),
                *[fixed(one, 1) for one in (rest, seconds.pack, seconds.golden, seconds.truth)],
                fixed(run.host.peak_memory_bytes / 1e9, 2),
                group(row.cycles),
                fixed(row.cycles / (run.work.blended / 64), 2),
                fixed(total_bytes(row.bytes) / 1e6, 0),
                fixed(model.host.cpu_seconds, 1),
            ]
        )
    head = ["Gaussians", "pixels", "reading, writing", "packing", "golden model", "three truths", "memory, GB"]
    return table([*head, "cycles", "x floor", "MB", "`pipegs model`, s"], rows)


def each(figure):
    """Of a Gaussian, from the smallest scene to the largest: what pixels take is in both and falls out."""
    few, many = data.scale.sim_1m, data.scale.sim_16m
    return (figure(many) - figure(few)) / (many.scene.gaussians - few.scene.gaussians)


def most_of_load(what):
    """The largest of all spreads of depth in a window that holds too much."""
    return fixed(max(value for line in data.prints.all.load for key, value in line.items() if key.startswith(what)), 1)
