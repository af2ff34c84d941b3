# SPDX-License-Identifier: Apache-2.0
"""Of gates: `pipegs silicon`, FPGAs, netlists, the check of the area model."""
import re

from keep.parts import pick


def silicon_rows(row):
    """By unit: count, gates, SRAM, area and longest path of one design point."""
    return {
        one["name"]: {key: one[key] or None for key in ("count", "kilo_nand2", "kb")}
        | {"area_mm2": one["area_mm2"], "path_ps": one["path_ps"] if one["path_ps"]["mid"] else None}
        for one in row["rows"]
    }


def silicon(found):
    """Of `pipegs silicon --no-energy` for one design point."""
    (row,) = found["designs"]
    return silicon_rows(row)


def fpga(found):
    """Of `synth/fpga/fpga.py` for one machine and family: by unit, and the total."""
    (entry,) = found
    return entry["rows"]


WHOLE = {"dop", "fast"}  # the design points whose units a page shows with every column


def energy(found):
    """By design point: clock, area, frames for area and energy, and what each unit takes. Modules of `fast` alone."""
    result = {}
    for row in found["designs"]:
        total = silicon_rows(row)["Total"]
        figures = pick("cycles", "ghz", "us", "fps", "fps_per_mm2", "frames_per_joule", "frames_per_joule_with_dram")
        result[row["name"]] = figures(row) | {
            "mm2": total["area_mm2"]["mid"],
            "path_ps": total["path_ps"]["mid"],
            "rows": {one["name"]: energy_row(one, row["name"] in WHOLE) for one in row["energy"]},
        }
        if row["name"] == "fast":
            result["fast"]["modules"] = [clocks_row(one) for one in row["clocks"][:12]]
    return result


def equal_area(found):
    """By design point: the area at which all are compared, and its time there."""
    return {row["name"]: row["equal_area"] for row in found["designs"]}


def energy_row(one, whole):
    """What a unit takes; uJ of a frame are without leakage. Flip-flops and their clocks of the total alone."""
    by = lambda factor, of: {key: factor * value for key, value in of.items()}
    row = {
        "awake": one["awake"] or None,
        "uj": by(1e6, one["frame_j"]) if whole else {"mid": 1e6 * one["frame_j"]["mid"]},
    }
    if whole:
        row |= {
            "halves": one["halves_differ"] or None,
            "clocks": one["clocks_j"] / one["frame_j"]["mid"] if one["clocks_j"] else None,
            "leakage_mw": by(1e3, one["leakage_w"]),
            "mw_60": by(1e3, one["watts_60"]),
            "w_full": one["watts_full"],
        }
    if one["name"] == "Total":
        row |= {key: one[key] for key in ("flipflops", "gated", "unseen")}
        row["clock_uj"] = {name: 1e6 * one[f"{name}_j"] for name in ("clocks", "ungated", "gates", "open")}
    return row


def clocks_row(one):
    """What the clocks of a module's instances take, uJ of a frame."""
    row = {key: one[key] for key in ("row", "module", "flipflops", "gated")}
    return row | {f"{name}_uj": 1e6 * one[f"{name}_j"] for name in ("ungated", "gated")}


def cost(found):
    """Of one machine: area, longest path, and what a frame takes of chip and DRAM."""
    (row,) = found["designs"]
    total = silicon_rows(row)["Total"]
    uj = {one["name"]: 1e6 * one["frame_j"]["mid"] for one in row["energy"]}
    figures = pick("cycles", "frames_per_joule", "frames_per_joule_with_dram")(row)
    mid = {"mm2": total["area_mm2"]["mid"], "path_ps": total["path_ps"]["mid"]}
    return figures | mid | {"chip_uj": uj["Total"], "dram_uj": uj["DRAM"]}


def compared(found):
    """Of one run of `pipegs sim`: cycles, what was compared, errors."""
    return pick("cycles", "mismatches", "beats_compared", "psnr_numeric_db", "psnr_order_db")(found)


def netlist(found):
    """Of one window: cycles, what was compared, seconds of the simulation."""
    return pick("cycles", "beats_compared", "mismatches")(found) | {"rtl_s": found["wall_seconds"]["rtl"]}


def leave_one_out(text):
    """What the area and energy models say of a point that they were not fitted to."""
    point = re.compile(r"([+-][\d.]+) % fitted, +([+-][\d.]+) % leave-one-out( \(extrapolated\))?: (\S+)")
    frame = re.compile(r"([+-][\d.]+) % of the chip's (\d+) uJ leave-one-out( \([^)]*\))?: (\w+) (\S+)")
    path = re.compile(r"([\d.]+) FO4, fitted +([+-][\d.]+) %, leave-one-out +([+-][\d.]+) %( \(extrapolated\))?: (\S+)")
    return {
        "paths": [
            {
                "configuration": name,
                "fo4": float(fo4),
                "fitted": float(fitted) / 100,
                "leave_one_out": float(told) / 100,
                "extrapolated": bool(beyond),
            }
            for fo4, fitted, told, beyond, name in path.findall(text)
        ],
        "points": [
            {
                "configuration": name,
                "fitted": float(fitted) / 100,
                "leave_one_out": float(told) / 100,
                "extrapolated": bool(beyond),
            }
            for fitted, told, beyond, name in point.findall(text)
        ],
        "frames": [
            {
                "scene": scene,
                "configuration": name,
                "uj": int(uj),
                "leave_one_out": float(told) / 100,
                "alone": bool(alone),
            }
            for told, uj, alone, scene, name in frame.findall(text)
        ],
    }
