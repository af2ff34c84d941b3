# SPDX-License-Identifier: Apache-2.0
"""Of frames: `pipegs sim`, `ladder`, `profile` and tests that run machines."""
from keep.parts import alpha_bytes, pick, total_bytes


def ladder(found):
    """By design point: figures of the frame, bytes by stream, and what it is built of."""
    if any("failure" in row for row in found["designs"]):
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
    for row in found["designs"]:
        built = pick("row_lanes", "blend_lanes", "multipliers", "buffer_bytes")(row["static"])
        rows[row["name"]] = figures(row) | {
            "bytes": total_bytes(row["bytes_by_stream"]),
            "alpha_bytes": alpha_bytes(row["bytes_by_stream"]),
            "built_of": built | {"adders": row["static"]["adders"]["all"]},
        }
    return rows


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
        for row in found["designs"]
    }


def models(found):
    """By design point: cycles of the timing model; where the RTL ran beside it, its cycles and what differs."""
    rows = {}
    for row in found["designs"]:
        rows[row["name"]] = {"cycles": row["cycles"], "seconds": row["seconds"]["model"]}
        if "rtl" in row:
            rows[row["name"]] |= {
                "rtl_cycles": row["rtl"]["cycles"],
                "rtl_khz": row["rtl"]["khz"],
                "differences": len(row["differences"]),
                "speed_ratio": row["speed_ratio"],
            }
    return rows


def speed(found):
    """Of machine_speed: kHz of each variant, nothing looked at and every beat compared."""
    return {one["variant"]: pick("cycles", "khz", "compared_khz")(one) for one in found}


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
    (row,) = found["designs"]
    return {"cycles": row["cycles"], "bytes": total_bytes(row["bytes"])}


def one_store(found):
    """Of one configuration: cycles, bytes of all streams, lines of alphas that found no place in a store."""
    (row,) = found["designs"]
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


def walk(found):
    """A path of frames: percentiles of what a frame takes, each with the frame that has it."""
    return {
        "frames": len(found["views"]),
        "mean_cycles": round(found["cycles_alone"] / len(found["views"])),
        "least_cycles": min(row["cycles_alone"] for row in found["views"]),
        "percentiles": found["percentiles"],
        "energy_extrapolated": found["energy_extrapolated"],
    }


def walk_frames(found):
    """A path of few frames: cycles and bytes of each."""
    if any(row.get("mismatches", 0) for row in found["views"]):
        raise ValueError("a frame differs")
    return {
        "cycles": [row["cycles_alone"] for row in found["views"]],
        "bytes": [row["bytes_read"] + row["bytes_written"] for row in found["views"]],
    }


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
    (row,) = found["designs"]
    return large_model(found) | {
        "visible": row["visible"],
        "seconds": found["host"]["cpu_seconds"],
        "memory": found["host"]["peak_memory_bytes"],
    }


def large_model(found):
    """The same, and the bytes of records and keys that found no room in the SUs."""
    (row,) = found["designs"]
    return one_model(found) | {"sort": total_bytes({"sort": row["bytes"]["sort_overflow"]})}


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


def tradeoff(found):
    """What was measured with less of something, and what a decibel costs along the front."""
    keep = pick("knob", "label", "width", "height", "gaussians", "cycles", "us", "bytes", "psnr_db", "ssim", "front")
    return {"points": [keep(row) for row in found["points"]], "price": found["price"]}
