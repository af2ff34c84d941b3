# SPDX-License-Identifier: Apache-2.0
"""What is kept of a command's JSON, or of its text where it prints none: one function for each kind of measurement."""
import re

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


def pick(*keys):
    """Those keys of an object; a.b of an object in it becomes b."""

    def keep(found):
        result = {}
        for key in keys:
            value = found
            for part in key.split("."):
                value = value[part]
            result[key.split(".")[-1]] = value
        return result

    return keep


def total_bytes(row):
    return sum(stream["read"] + stream["written"] for stream in row.values())


def alpha_bytes(streams):
    """Alphas that go to memory and come back; what the stream raster writes are pixels."""
    return total_bytes({"alphas": streams["alpha_overflow_write"]}) + streams["raster"]["read"]


def ladder(found):
    """By design point: figures of the frame, bytes by stream, and what it is built of."""
    if any("failure" in row for row in found["rungs"]):
        raise ValueError("a design point did not run")
    figures = pick(
        "cycles",
        "fps",
        "speedup",
        "raster_over_sort",
        "bubbles",
        "exposed_share",
        "largest_bound",
        "cycles_over_largest_bound",
        "psnr_order_db",
        "mismatches",
        "same_pixels_as",
        "peak_alpha_lines",
    )
    rows = {}
    for row in found["rungs"]:
        built = pick("row_lanes", "blend_lanes", "multipliers", "buffer_bytes")(row["static"])
        rows[row["name"]] = figures(row) | {
            "bytes": total_bytes(row["bytes_by_stream"]),
            "alpha_bytes": alpha_bytes(row["bytes_by_stream"]),
            "built_of": built | {"adders": row["static"]["adders"]["all"]},
        }
    return rows


def terms(found):
    """Closed form, lead, waterfall, our terms and the paper's, and what the search found; no list of its matches."""
    search = {key: value for key, value in found["search"].items() if key != "best"}
    keep = pick("closed", "lead", "waterfall", "ours", "paper", "assumptions")
    return keep(found) | {"search": search}


def frame(found):
    """Of one run of `pipegs sim`: counts of the work, bounds, bytes by stream, errors, states of the units."""
    streams = found["memory"]["by_stream"]
    state = ("busy", "starved", "blocked", "memory")
    return pick(
        "cycles",
        "mismatches",
        "beats_compared",
        "psnr_numeric_db",
        "psnr_order_db",
        "psnr_total_db",
        "max_abs_error",
        "wall_seconds",
        "rtl_khz",
        "bounds",
        "work",
    )(found) | {
        "alpha_bytes": alpha_bytes(streams),
        "pixel_bytes": streams["raster"]["written"],
        "bytes_by_stream": {name: total_bytes({name: one}) for name, one in streams.items()},
        "units": {
            unit: [{name: one[name] for name in state} for one in found["units"][unit]]
            for unit in ("dopu", "pu", "su", "ru")
        },
    }


def sweep(found):
    """By design point: cycles at each bandwidth, and the one from which on more saves less than 5 %."""
    at = [f"at_{bandwidth:g}".replace(".", "_") for bandwidth in found["bytes_per_cycle"]]
    return {
        row["name"]: dict(zip(at, row["cycles"])) | {"enough": row["memory_bound_below_bytes_per_cycle"]}
        for row in found["rungs"]
    }


def models(found):
    """By design point: cycles of the timing model; where the RTL ran beside it, its cycles and what differs."""
    rows = {}
    for row in found["rungs"]:
        rows[row["name"]] = {"cycles": row["cycles"], "seconds": row["seconds"]["model"]}
        if "rtl" in row:
            rows[row["name"]] |= {
                "rtl_cycles": row["rtl"]["cycles"],
                "rtl_khz": row["rtl"]["khz"],
                "differences": len(row["differences"]),
                "speed_ratio": row["speed_ratio"],
            }
    return rows


def tables(*names):
    """Of a text: its Markdown tables, as rows of cells, in this order."""

    def keep(text):
        blocks = [block.strip().split("\n") for block in re.split(r"\n\s*\n", text) if block.lstrip().startswith("|")]
        rows = [[[cell.strip() for cell in line.strip("|").split("|")] for line in block] for block in blocks]
        return {name: {"header": block[0], "rows": block[2:]} for name, block in zip(names, rows, strict=True)}

    return keep


def difference(text):
    """Of `pipegs render --compare`: how many pixels of two pictures differ, and by how much."""
    differ, pixels, codes = map(int, re.search(r"(\d+) of (\d+) pixels differ, by (\d+) codes", text).groups())
    return {"differ": differ, "pixels": pixels, "codes": codes}


def proofs(text):
    """Of synth/prove.sh: by proof its sets of parameters, its mutants, and the seconds of both."""
    found, name = {}, None
    for start, verdict, seconds, what in re.findall(r"^(\S*) +(proved|refuted) +([\d.]+) s  (.*)$", text, re.MULTILINE):
        name = start or name
        row = found.setdefault(name, {"sets": 0, "seconds": 0, "mutants": 0, "seconds_of_mutants": 0})
        if verdict == "proved":
            row |= {"sets": int(what.split()[0]), "seconds": float(seconds)}
        else:
            row["mutants"] += 1
            row["seconds_of_mutants"] = round(row["seconds_of_mutants"] + float(seconds), 1)
    return found


def printed(pattern, *names):
    """Of what a test prints: for each line that fits, its numbers by name."""

    def keep(text):
        rows = [dict(zip(names, map(float, found.groups()))) for found in re.finditer(pattern, text)]
        if not rows:
            raise ValueError(f"no line fits {pattern}")
        return {"lines": rows}

    return keep


def shown(text):
    """What a command prints, line by line; a path begins at the build folder, wherever that lies."""
    return {"lines": [line.rstrip() for line in re.sub(r"/\S*/(?=build/)", "", text).rstrip("\n").split("\n")]}


def speed(found):
    """Of machine_speed: kHz of each variant, nothing looked at and every beat compared."""
    return {one["variant"]: pick("cycles", "khz", "compared_khz")(one) for one in found}


def golden(text):
    """PSNR by the bits of alpha, from the test's XML."""
    return {bits: float(value) for bits, value in re.findall(r'psnr_alpha_(\d+)"?(?: value)?="([\d.]+)"', text)}


def profile(found):
    """Of `pipegs profile`: where the RTL's time goes, and how often Gaussians and coefficients could be used again."""
    if found["mismatches"] != 0:
        raise ValueError("the RTL differs")
    costs, counts = found["coefficient_cost"], found["gaussians"]
    return {
        "stages": {stage: one["share"] for stage, one in found["stages"].items()},
        "in_two": counts["share_in_two_or_more"],
        "mean_tiles": counts["mean_tiles"],
        "coefficients": costs["once_per_gaussian"],
        "coefficients_window": costs["once_per_gaussian_and_window"],
        "arithmetic": found["arithmetic_per_pixel"]["dpc"],
        "direct": found["arithmetic_per_pixel"]["direct"],
    }


def fetched(found):
    """Of `pipegs profile --no-rtl`: Gaussians that the DOPU sends to the PUs."""
    return {"fetched": round(found["stages"]["preprocess"]["cycles"])}


def lanes(found):
    """Of `pipegs sim --no-rtl` with quads: what the RUs have to do."""
    work = found["work"]
    return {key: work[key] for key in ("open_regions", "quads", "blended")}


def one_model(found):
    """Of one configuration: cycles, and bytes of all streams."""
    (row,) = found["rungs"]
    return {"cycles": row["cycles"], "bytes": total_bytes(row["bytes"])}


def one_store(found):
    """Of one configuration: cycles, bytes of all streams, lines of alphas that found no place in a store."""
    (row,) = found["rungs"]
    return one_model(found) | {"overflow_lines": row["overflow_lines"]}


def views(found):
    """Frames in one machine: cycles of a frame on average, and the largest gap between two, queued and alone."""
    rows = found["views"]
    if any(row["mismatches"] for row in rows):
        raise ValueError("a frame differs")
    runs = ("queued", "alone")
    figures = {f"cycles_{run}": round(found[f"cycles_{run}"] / len(rows)) for run in runs}
    figures |= {f"gap_{run}": max(row[f"gap_{run}"] for row in rows[1:]) for run in runs}
    return {"frames": len(rows)} | figures


def host(found):
    """Of `pipegs sim --no-rtl`: what the scene is, what it asks for, and what it takes of the computer."""
    seconds = found["host"]["cpu_seconds"]
    return {
        "gaussians": found["scene"]["gaussians"],
        "pixels": found["camera"]["width"] * found["camera"]["height"],
        "visible": found["work"]["visible"],
        "seconds": seconds | {"rest": seconds["all"] - seconds["pack"] - seconds["golden"] - seconds["truth"]},
        "memory": found["host"]["peak_memory_bytes"],
    }


def host_model(found):
    """Of `pipegs model`: cycles, bytes, and what it takes of the computer."""
    (row,) = found["rungs"]
    return large_model(found) | {
        "visible": row["visible"],
        "seconds": found["host"]["cpu_seconds"],
        "memory": found["host"]["peak_memory_bytes"],
    }


def large_model(found):
    """The same, and the bytes of records and keys that found no room in the SUs."""
    (row,) = found["rungs"]
    return one_model(found) | {"sort": total_bytes({"sort": row["bytes"]["sort_overflow"]})}


def silicon_rows(row):
    """By unit: count, gates, SRAM, area and longest path of one design point."""
    return {
        one["name"]: {key: one[key] or None for key in ("count", "kilo_nand2", "kb")}
        | {"area_mm2": one["area_mm2"], "path_ps": one["path_ps"] if one["path_ps"]["mid"] else None}
        for one in row["rows"]
    }


def silicon(found):
    """Of `pipegs silicon --no-energy` for one design point."""
    (row,) = found["rungs"]
    return silicon_rows(row)


def fpga(found):
    """Of `synth/fpga/fpga.py` for one machine and family: by unit, and the total."""
    (entry,) = found
    return entry["rows"]


def energy(found):
    """By design point: clock, area, frames for area and energy, and what each unit takes."""
    result = {}
    for row in found["rungs"]:
        total = silicon_rows(row)["Total"]
        figures = pick("cycles", "ghz", "us", "fps", "fps_per_mm2", "frames_per_joule", "frames_per_joule_with_dram")
        result[row["name"]] = figures(row) | {
            "mm2": total["area_mm2"]["mid"],
            "path_ps": total["path_ps"]["mid"],
            "rows": {one["name"]: energy_row(one) for one in row["energy"]},
            "modules": [clocks_row(one) for one in row["clocks"][:12]],
        }
    return result


def equal_area(found):
    """By design point: the area at which all are compared, and its time there."""
    return {row["name"]: row["equal_area"] for row in found["rungs"]}


def energy_row(one):
    """What a unit takes; uJ of a frame are without leakage."""
    by = lambda factor, of: {key: factor * value for key, value in of.items()}
    row = {
        "awake": one["awake"] or None,
        "uj": by(1e6, one["frame_j"]),
        "halves": one["halves_differ"] or None,
        "clocks": one["clocks_j"] / one["frame_j"]["mid"] if one["clocks_j"] else None,
        "leakage_mw": by(1e3, one["leakage_w"]),
        "mw_60": by(1e3, one["watts_60"]),
        "w_full": one["watts_full"],
    }
    if one["flipflops"]:
        row |= {key: one[key] for key in ("flipflops", "gated", "unseen")}
        row["clock_uj"] = {name: 1e6 * one[f"{name}_j"] for name in ("clocks", "ungated", "gates", "open")}
    return row


def clocks_row(one):
    """What the clocks of a module's instances take, uJ of a frame."""
    row = {key: one[key] for key in ("row", "module", "flipflops", "gated")}
    return row | {f"{name}_uj": 1e6 * one[f"{name}_j"] for name in ("ungated", "gated")}


def cost(found):
    """Of one machine: area, longest path, and what a frame takes of chip and DRAM."""
    (row,) = found["rungs"]
    total = silicon_rows(row)["Total"]
    uj = {one["name"]: 1e6 * one["frame_j"]["mid"] for one in row["energy"]}
    figures = pick("cycles", "frames_per_joule", "frames_per_joule_with_dram")(row)
    mid = {"mm2": total["area_mm2"]["mid"], "path_ps": total["path_ps"]["mid"]}
    return figures | mid | {"chip_uj": uj["Total"], "dram_uj": uj["DRAM"]}


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


def compared(found):
    """Of one run of `pipegs sim`: cycles, what was compared, errors."""
    return pick("cycles", "mismatches", "beats_compared", "psnr_numeric_db", "psnr_order_db")(found)


def netlist(found):
    """Of one window: cycles, what was compared, seconds of the simulation."""
    return pick("cycles", "beats_compared", "mismatches")(found) | {"rtl_s": found["wall_seconds"]["rtl"]}


def effects(found):
    return {row["name"]: pick("called_for", "evidence")(row) for row in found["effects"]}


def effects_gain(found):
    """Seconds of a core with all effects and with those called for."""
    return {
        key: {
            "golden_s": sum(found[key][part]["computed"] for part in ("golden", "detect")),
            "rtl_s": found[key]["rtl"]["computed"],
            "total_s": found[key]["total"]["computed"],
            "cycles": found[key]["cycles"],
            "mismatches": found[key]["mismatches"],
        }
        for key in ("all", "auto")
    }


def shapes(found):
    """The wanted area, and what each shape takes; the best within that area and the front by name."""
    keep = pick("shape", "step", "cycles", "ghz", "us", "extrapolated_area", "fps_per_mm2", "within", "front")
    rows = [
        keep(row)
        | {"mb": row["bytes"] / 1e6, "mm2": row["mm2"]["mid"], "frames_per_joule": row["frames_per_joule_with_dram"]}
        for row in found["shapes"]
    ]
    return pick("mm2", "clock_known", "best")(found) | {"shapes": rows}


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


def tradeoff(found):
    """What was measured with less of something, and what a decibel costs along the front."""
    keep = pick("knob", "label", "width", "height", "gaussians", "cycles", "us", "bytes", "psnr_db", "ssim", "front")
    return {"points": [keep(row) for row in found["points"]], "price": found["price"]}


def fidelity(found):
    return {
        "rows": [pick("name", "seconds", "ratio", "pixels", "cycles", "bytes", "stalls")(row) for row in found["rows"]]
    }


def rivals(found, parameters=False):
    """Machines, what is over what, and checks; timelines stay out, and but for one scene the parameters."""
    out = ("spans", "memory_cycles", "chip_joules", "dram_joules") + (() if parameters else ("parameters",))

    def lean(one):
        return {key: value for key, value in one.items() if key not in out}

    kept = {key: found[key] for key in ("width", "height", "memory", "printed", "ours", "against", "checks", "lego")}
    kept["rivals"] = {key: lean(one) for key, one in found["rivals"].items()}
    kept["variants"] = [lean(one) for one in found["variants"]]
    return kept


def rivals_and_parameters(found):
    return rivals(found, parameters=True)
