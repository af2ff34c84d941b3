# SPDX-License-Identifier: Apache-2.0
"""Of errors: `pipegs accuracy`, `budget`, `stress`, and the tests of stability."""
import re

from keep.parts import pick


QUOTED = (
    "alpha_w",
    "layers",
    "record",
    "tile_test",
    "alpha_cut",
    "coeff_f",
    "mantissa_w",
    "exp_linear",
    "quat_w",
    "depth_w",
    "base_w",
    "color_w",
    "rgb_w",
    "sh_degree",
)  # knobs whose single points the page quotes


def golden(text):
    """PSNR by the bits of alpha, from the test's XML."""
    return {bits: float(value) for bits, value in re.findall(r'psnr_alpha_(\d+)"?(?: value)?="([\d.]+)"', text)}


def accuracy(found):
    """The base, what the last decibel of each knob costs, and the fronts over cycles and area."""

    def told(value, extrapolated):
        return f"{'~' if extrapolated else ''}{value:.2f}"

    def point(row):
        cost = row["silicon"]
        return {
            "numeric_db": row["numeric"]["psnr_db"],
            "order_db": row["order"]["psnr_db"],
            "total_db": row["total"]["psnr_db"],
            "ssim": row["total"]["ssim"],
            "flips": row["flipped"] / row["decisions"],
            "cycles": row["cycles"],
            "mb": row["bytes"] / 1e6,
            "buffer_kb": row["buffer_bits"] / 8192,
            "mm2": told(cost["mm2"]["mid"], cost["extrapolated_area"]),
            "mj": told(cost["chip_mj"]["mid"] + cost["dram_mj"]["mid"], cost["extrapolated_energy"]),
        }

    own = found["base"]["configuration"].split(",")

    def over_base(configuration):
        return " ".join(one for one in configuration.split(",") if one not in own) or "base"

    rows = [found["base"], *[row for knob in found["knobs"] for row in knob["values"]], *found["together"]]
    known = {row["configuration"]: row for row in rows if "failure" not in row}
    return {
        "base": point(found["base"]),
        "knobs": {
            knob["name"]: {
                "what": knob["what"],
                "says": knob["sentence"].split(": ", 1)[1].rstrip("."),
                "values": {
                    row["label"]: point(row)
                    for row in knob["values"]
                    if "failure" not in row and knob["name"] in QUOTED
                },
            }
            for knob in found["knobs"]
        },
        "front": {
            over: [point(known[one]) | {"configuration": over_base(one)} for one in found["front"][over]]
            for over in ("cycles", "area")
        },
    }


def accuracy_rtl(found):
    """The cheapest points at five levels in RTL."""
    own = found["base"]["configuration"].split(",")
    keep = pick("level_db", "reached", "numeric_db", "model_cycles", "rtl_cycles", "beats", "mismatches")
    return {
        "levels": [
            keep(row) | {"configuration": " ".join(one for one in row["configuration"].split(",") if one not in own)}
            for row in found["rtl"]
        ]
    }


def errors(found):
    """Of one picture: PSNR of the numbers, of the order, of both, dB."""
    return pick("psnr_numeric_db", "psnr_order_db", "psnr_total_db")(found)


def budget(found):
    """Percentiles of errors and bounds of random Gaussians."""
    rows = {name: list(of.values()) for name, of in found.items() if ", " in name}
    return {
        "rows": rows,
        "gaussians": found["samples"],
        "beyond": found["beyond_bound"],
        "no_number": found["no_number"],
    }


def stability(text):
    """By test: the largest errors of a pixel and the bounds there; and what single tests print."""
    cases, test = {}, None
    for line in text.splitlines():
        begun, within = re.search(r"\[ RUN +\] (\S+)", line), re.search(
            r"alpha ([\d.]+) of ([\d.]+), T ([\d.]+) of ([\d.]+), colour ([\d.]+) of ([\d.]+)", line
        )
        if begun:
            test = begun[1]
        if within:
            values = [float(value) for value in within.groups()]
            worst = cases.setdefault(test, {})
            for key, pair in zip(("alpha", "t", "color"), (values[0:2], values[2:4], values[4:6])):
                worst[key] = max(worst.get(key, [-1, 0]), pair)
    half, ours = re.search(r"T09: .* FP16 ([\d.]+) %, ours ([\d.]+) %", text).groups()
    return {
        "cases": cases,
        "fp16_off": float(half) / 100,
        "ours_off": float(ours) / 100,
        "popping": {
            name: [int(value) for value in values]
            for name, *values in re.findall(r"T19 (dop|exact): (\d+); (\d+), (\d+)", text)
        },
        "depth_bits": {
            bits: float(value) for bits, value in re.findall(r"T20 depth_w (\d+): order error ([\d.]+)", text)
        },
    }


def trained(found):
    """Of `pipegs train`: the views held out, before and after, by truth and machines; the first of them alone."""
    kept = pick("gaussians", "minutes", "steps", "measured_layers", "options", "views")(found)
    for key in ("held_out", "held_out_before"):
        if key in found:
            kept[key] = {name: value for name, value in found[key].items() if name != "views"}
            kept[key]["first"] = found[key]["views"][0]
    return kept


def fine_tuned(found):
    """Of `pipegs train` on a scene's own renders: also each of the scene's own views, before and after."""
    kept = trained(found)
    for key in ("held_out", "held_out_before"):
        kept[key]["given"] = [view for view in found[key]["views"] if not view["held_out"]]
    return kept
