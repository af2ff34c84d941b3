# SPDX-License-Identifier: Apache-2.0
"""Figures of commands that print text: tests, proofs, and what a page shows as it stands."""
import re

# fmt: off
PRINTS = {  # what is measured, most by the test of that name: the line that it prints, names of the line's numbers
    "recip": (r"recip, (\d+) bits: worst error ([\d.]+)", "bits", "units"),
    "exp2": (r"exp2: error ([-\d.]+) \.\. ([-\d.]+) .*chord ([\d.]+), step ([\d.]+)",
             "low", "high", "chord", "step"),
    "exp2_step": (r"exp2: error ([-\d.]+) \.\. ([-\d.]+) ", "low", "high"),
    "log2": (r"log2: worst error (\S+)", "worst"),
    "rsqrt": (r"worst relative error 2\^(\S+)", "worst"),
    "dopu_planes": (r"largest error of an edge ([\d.]+) px", "px"),
    "dopu_depth": (r"least distance from a bound ([\d.]+) units of ([\d.]+)", "left", "given"),
    "dopu_origin": (r"largest error ([\d.]+) units", "units"),
    "pu_project": (r"w=28: 1/z 2\^(\S+) relative; tan 2\^([^;]+); mean 2\^(\S+) px .*, 2\^(\S+) relative "
                   r".* 2\^(\S+) rad",
                   "inverse", "tangent", "mean", "far", "direction"),
    "pu_orient": (r"pu_orient, view_w=28: worst entry differs by (\S+) from", "worst"),
    "pu_covariance": (r"w=28: relative error of a 2\^([-\d.]+), c 2\^([-\d.]+), det 2\^([-\d.]+), .* 2\^([-\d.]+)",
                      "a", "c", "det", "b"),
    "pu_axes": (r"test=2: error of tilt (\S+); relative, of stretch (\S+), of shrink (\S+), of the eigenvalue (\S+)",
                "tilt", "stretch", "shrink", "larger"),
    "pu_box": (r"pu_box, tile_test=2: .* 3/256 px and (\S+), extents by 3/32 px and (\S+) of", "side", "extent"),
    "pu_compensate": (r"pu_compensate, antialias=1: error (\S+) of", "worst"),
    "pu_conic": (r"narrow (\S+), of wide (\S+), error of slope ([^;\s]+); .* 1/4 px and ([\d.]+) %",
                 "narrow", "wide", "slope", "percent"),
    "pu_color_rotate": (r"pu_color_rotate: worst error ([\d.]+) units", "units"),
    "pu_color_normalise": (r"of a component 2\^([-\d.]+)", "worst"),
    "pu_color_basis": (r"pu_color_basis: worst error 2\^([-\d.]+)", "worst"),
    "pu_color_sum": (r"pu_color_sum, color_w=12: worst error ([\d.]+) units", "units"),
    "pu_color": (r"pu_color: worst error 2\^([-\d.]+)", "worst"),
    "ru_blend": (r"T at most ([^,]+), colour at most ([^,]+), rms (\S+)", "t", "color", "rms"),
    "pu_coeff": (r"up to +(\d+) px: error of the power (\S+) \(.*\), rms (\S+); from .* (\S+)\n",
                 "sigma", "worst", "rms", "quantised"),
    "pu_intersect": (r"up to +(\d+) px: +([\d.]+) regions .* counts, ([-+\d.]+) % .* boxes ([\d.]+)",
                     "sigma", "regions", "percent", "boxes"),
    "pu_rows": (r"(\d+) visible pixels, alpha error at most ([\d.]+) .*bound ([\d.]+)\), power error ([\d.]+).*, (\d+) "
                r"decisions", "pixels", "alpha", "bound", "power", "flipped"),
    "su": (r"(\d+) keys per layer: ([\d.]+) cycles per key, .* depths ([\d.]+), clustered ([\d.]+)",
           "keys", "random", "narrow", "clustered"),
    "load": (r"(\d+) splats.*clusters ([\d.]+), ([\d.]+); equal ([\d.]+), ([\d.]+); logarithmic ([\d.]+), "
             r"([\d.]+); outlier ([\d.]+), ([\d.]+); random ([\d.]+), ([\d.]+)", "splats",
             *(f"{what}_{spread}" for spread in ("clusters", "equal", "logarithmic", "outlier", "random")
               for what in ("cycles", "bytes"))),
}
# fmt: on
MODELS = {  # tests of several models
    "dopu_models": ("dopu_origin",),
    "projection_models": ("pu_project", "pu_orient", "pu_covariance", "pu_compensate"),
    "box_models": ("pu_axes", "pu_box"),
    "color_models": ("pu_color_rotate", "pu_color_normalise", "pu_color_basis", "pu_color_sum"),
}
PRINTED_BY = {name: test for test, names in MODELS.items() for name in names}
PRINTING = sorted({PRINTED_BY.get(name, name) for name in PRINTS})


def printed(text):
    """Of `ctest -V`: by what is measured, for each line that fits its pattern, the numbers by name."""
    names = dict(re.findall(r"^ +Start +(\d+): (\S+)", text, re.MULTILINE))
    lines = {name: "" for name in names.values()}
    for number, line in re.findall(r"^(\d+): (.*\n)", text, re.MULTILINE):
        lines[names[number]] += line
    found = {}
    for name, (pattern, *keys) in PRINTS.items():
        test = PRINTED_BY.get(name, name)
        rows = [dict(zip(keys, map(float, one.groups()))) for one in re.finditer(pattern, lines[test])]
        if not rows:
            raise ValueError(f"test {test}: no line fits {pattern}")
        found[name] = rows
    return found


def difference(text):
    """Of `pipegs render --compare`: how many pixels of two pictures differ, and by how much."""
    differ, pixels, codes = map(int, re.search(r"(\d+) of (\d+) pixels differ, by (\d+) codes", text).groups())
    return {"differ": differ, "pixels": pixels, "codes": codes}


def golden(text):
    """PSNR by the bits of alpha, from the test's XML."""
    return {bits: float(value) for bits, value in re.findall(r'psnr_alpha_(\d+)"?(?: value)?="([\d.]+)"', text)}


def leave_one_out(text):
    """Of the models of area, clock and energy: the largest errors of points left out, per cent."""

    def largest(pattern):
        return max(abs(float(one)) for one in re.findall(pattern, text))

    inside, beyond = r" % leave-one-out: ", r" % leave-one-out \(extrapolated\): "
    return {
        "area": largest(r"fitted, +([+-][\d.]+)" + inside),
        "area_beyond": largest(r"fitted, +([+-][\d.]+)" + beyond),
        "path": largest(r"leave-one-out +([+-][\d.]+) %(?: \(extrapolated\))?: "),
        "energy": largest(r"([+-][\d.]+) % of the chip's \d+ uJ leave-one-out"),
    }


def stability(text):
    """By test: the largest errors of a pixel and the bounds there; and what single tests print."""
    cases, test = {}, None
    error = re.compile(r"alpha ([\d.]+) of ([\d.]+), T ([\d.]+) of ([\d.]+), colour ([\d.]+) of ([\d.]+)")
    for line in text.splitlines():
        begun, within = re.search(r"\[ RUN +\] (\S+)", line), error.search(line)
        if begun:
            test = begun[1]
        if within:
            values = [float(value) for value in within.groups()]
            worst = cases.setdefault(test, [[-1, 0]] * 3)
            cases[test] = [max(old, values[2 * at : 2 * at + 2]) for at, old in enumerate(worst)]
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


def mutants(text):
    """Of verif/mutation/mutate.sh: how many were run, how many caught, and the modules of the others."""
    run, caught = map(int, re.search(r"^(\d+) mutants, (\d+) caught", text, re.MULTILINE).groups())
    left = re.findall(r"^(\w+) +[\d.]+ s  .*: (?:SURVIVED|BROKEN)", text, re.MULTILINE)
    return {"run": run, "caught": caught, "left": left}


def tests(text):
    """Of ctest: how many tests passed, and the names of those that were skipped, and of those that failed."""
    of = re.findall(r"^ *\d+/\d+ +Test +#\d+: (\S+) [.*]*(?: *\*\*\*)? *(\w+)", text, re.MULTILINE)
    if not of:
        raise ValueError("no line of a test")
    return {
        "passed": sum(verdict == "Passed" for _, verdict in of),
        "skipped": [name for name, verdict in of if verdict == "Skipped"],
        "failed": [name for name, verdict in of if verdict not in ("Passed", "Skipped")],
    }


def coverage(text):
    """Of the test `coverage`: blocks of the RTL, those that frames executed, and by module those never executed."""
    modules = re.findall(r"^(\w+) +(\d+) of (\d+) never, lines ([\d ]+)$", text, re.MULTILINE)
    count, executed, blocks = map(int, re.search(r"(\d+) modules: (\d+) of (\d+) executed", text).groups())
    never = {name: {"never": int(missed), "of": int(of), "lines": lines} for name, missed, of, lines in modules}
    return {"modules": count, "executed": executed, "blocks": blocks, "never": never}


def shown(text):
    """What a command prints, line by line; a path begins at the build folder, wherever that lies."""
    return {"lines": [line.rstrip() for line in re.sub(r"/\S*/(?=build/)", "", text).rstrip("\n").split("\n")]}
