# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/headset.md."""
from data import data
from formats import change, fixed, group, listing, percent, table
from measurements import APART, ASIDE, GAZES, HEADSET, PAIRED

MEASURED = ["pairs/*", "gaze/*", "prices/headset"]


def frame(name):
    """The one frame of an entry."""
    return data.pairs[name].views[0]


def megabytes(one):
    return (one.bytes_read + one.bytes_written) / 1e6


def microjoules(one):
    return one.chip_uj + one.dram_uj


def pairs():
    """Two frames and a pair, of each scene."""

    def saved(scene, of):
        return change(of(frame(f"{scene}_pair")) / (2 * of(frame(f"{scene}_one"))) - 1, 0)

    def quantity(title, of, form, *rest):
        return [
            (f"{title}: two frames", lambda scene: 2 * of(frame(f"{scene}_one")), form, *rest),
            ("a pair", lambda scene: of(frame(f"{scene}_pair")), form, *rest),
            ("", lambda scene: saved(scene, of)),
        ]

    return listing(
        "scene",
        [(f"{scene} 0", scene) for scene in PAIRED],
        *quantity("cycles", lambda one: one.cycles_alone, group),
        *quantity("MB", megabytes, fixed, 1),
        *quantity("uJ", microjoules, group),
    )


def distances():
    """Cycles of pairs over two frames, by how far the eyes are apart."""

    def over(scene, name):
        two = 2 * frame(f"{scene}_one").cycles_alone
        return change(frame(f"{scene}_{name}").cycles_alone / two - 1)

    rows = [[f"{scene} 0", *[over(scene, name) for name in ("near", "pair", "wide")]] for scene in PAIRED]
    return table(["cycles over those of two frames", *[f"{way:g} units" for way in (0, APART, ASIDE)]], rows)


def gazes():
    """A picture in parts beside one frame."""

    def whole(scene):
        return frame(f"{scene}_one")

    def part(scene):
        return data.gaze[scene].gaze[0]

    return listing(
        "picture",
        [(f"{scene} 0, `--gaze {GAZES[scene]}`", scene) for scene in GAZES],
        ("parts", lambda scene: part(scene).parts),
        ("samples", lambda scene: group(part(scene).samples)),
        ("of the pixels", lambda scene: percent(part(scene).samples / (whole(scene).width * whole(scene).height))),
        ("cycles", lambda scene: group(part(scene).cycles_alone)),
        ("of one frame's", lambda scene: percent(part(scene).cycles_alone / whole(scene).cycles_alone)),
        ("MB of one frame's", lambda scene: percent(megabytes(part(scene)) / megabytes(whole(scene)))),
        ("uJ of one frame's", lambda scene: percent(microjoules(part(scene)) / microjoules(whole(scene)))),
    )


def rings():
    """What each ring costs in the picture."""
    return listing(
        "ring",
        [
            (f"{scene} 0, {ring.sample}x{ring.sample} from {fixed(ring.from_degrees, 0)} degrees", ring)
            for scene in GAZES
            for ring in data.gaze[scene].gaze[0].rings
        ],
        ("pixels", "pixels", group),
        ("dB, repeated", "repeated_db", fixed, 1),
        ("dB, blended", "smooth_db", fixed, 1),
        ("dB to the means", "mean_db", fixed, 1),
    )


def costs():
    """Area, clock and energy of what a machine may have for it."""
    machines = data.prices.headset.machines
    names = ["`fast`", *[f"`{name}`" for name in HEADSET], "all of these"]
    return listing(
        "machine",
        list(zip(names, machines)),
        ("mm2", lambda one: fixed(one.silicon.mm2.mid, 2)),
        ("", lambda one: change(one.silicon.mm2.mid / machines[0].silicon.mm2.mid - 1)),
        ("MHz", lambda one: fixed(1e3 * one.ghz, 0)),
        ("mJ of a frame of one eye without AOVs", lambda one: fixed(one.mj, 2)),
    )
