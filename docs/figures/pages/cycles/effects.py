# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/cycles/timing_model.md."""
import re

from data import data
from formats import fixed, group, percent, span, table, times

MEASURED = ["effects/*", "effects_gain/*"]
SCENES = {
    "own": "our own",
    "terrace": "terrace",
    "plushdog": "plushdog",
    "flowers": "flowers",
    "statue": "statue",
    "showroom": "showroom",
}
TOLD = ("straddling", "waves", "taps", "asserts")  # the page says of them that no scene decides
GAINED = [(scene, point) for scene in ("own", "statue", "plushdog", "terrace") for point in ("dop", "exact")]


def short(evidence):
    """The figures of a sentence of evidence."""
    found = re.findall(r"degree \d|(?<![\w.])\d+(?:\.\d+)?(?: %| lines| M)?", evidence)
    return ", ".join(group(int(one)) if one.isdigit() else one for one in found)


def evidence():
    """Which effects each view calls for, and why."""
    rows = []
    for name in data.effects.own:
        if name not in TOLD:
            found = [data.effects[scene][name] for scene in SCENES]
            rows.append(
                [
                    f"`{name}`",
                    *[f"{'**yes**' if one.called_for else 'no'} {short(one.evidence)}".strip() for one in found],
                ]
            )
    return table(["effect", *SCENES.values()], rows)


def gains():
    """Seconds and cycles with all effects, and with those that the scene calls for."""
    rows = []
    for scene, point in GAINED:
        whole, lean = data.effects_gain[f"{scene}_{point}"]["all"], data.effects_gain[f"{scene}_{point}"].auto
        both = lambda key: f"{fixed(whole[key], 1)} / {fixed(lean[key], 1)}"
        rows.append(
            [
                f"{SCENES[scene]}, `{point}`",
                both("golden_s"),
                both("rtl_s"),
                both("total_s"),
                f"**{times(gain(scene, point))}**",
                f"{group(whole.cycles)} / {group(lean.cycles)}",
                f"{whole.mismatches} / {lean.mismatches}",
            ]
        )
    return table(
        [
            "scene, design point",
            "pack, golden model, detectors, s",
            "RTL and comparison, s",
            "in all, s",
            "gain",
            "cycles",
            "mismatches",
        ],
        rows,
    )


def gain(scene, point):
    found = data.effects_gain[f"{scene}_{point}"]
    return found["all"].total_s / found.auto.total_s


def gain_span():
    return span(times, [gain(*one) for one in GAINED])


def moved(scene):
    """By how much cycles move when parts are left out, at most."""
    shares = [data.effects_gain[f"{scene}_{point}"] for point in ("dop", "exact")]
    return percent(max(abs(one.auto.cycles / one["all"].cycles - 1) for one in shares), 1)
