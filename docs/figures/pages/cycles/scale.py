# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/cycles/cycles.md."""
from data import data
from formats import fixed, group, millions, table

MEASURED = ["scale/*", "prints/timing/load"]
GAUSSIANS = [f"gaussians_{count}m" for count in (1, 2, 4, 8, 16)]
PIXELS = ["pixels_648x420", "gaussians_1m", "pixels_2592x1680", "pixels_3840x2160"]
FILE = 104  # bytes of a Gaussian in a .ply of SH degree 1
LEAST, MOST = data.scale.sim[GAUSSIANS[0]], data.scale.sim[GAUSSIANS[-1]]


def host(names):
    """Seconds of processors and memory of `pipegs sim --no-rtl`, as far as it was run."""
    rows = []
    for name in (one for one in names if one in data.scale.sim):
        run = data.scale.sim[name]
        stages = [fixed(run.seconds[stage], 1) for stage in ("rest", "pack", "golden", "truth", "all")]
        rows.append([millions(run.gaussians, 0), millions(run.pixels), millions(run.visible), *stages, memory(run)])
    header = ["Gaussians", "pixels", "visible pairs", "reading, writing", "packing", "golden model", "three truths"]
    return table([*header, "all, CPU s", "memory, GB"], rows)


def model(names):
    """Cycles, bytes, seconds and memory of `pipegs model`, as far as it was run."""
    rows = []
    for name in (one for one in names if one in data.scale.model and one in data.scale.sim):
        run, known = data.scale.model[name], data.scale.sim[name]
        rows.append(
            [
                millions(known.gaussians, 0),
                millions(known.pixels),
                millions(run.visible),
                group(run.cycles),
                fixed(run.bytes / 1e6, 1),
                fixed(run.sort / 1e6, 1),
                fixed(run.seconds, 1),
                memory(run),
            ]
        )
    header = ["Gaussians", "pixels", "visible pairs", "cycles", "MB", "of these sorting", "CPU s", "memory, GB"]
    return table(header, rows)


def memory(run):
    return fixed(run.memory / 1e9, 2)


def each(run_of):
    """By Gaussian, from the smallest scene to the largest: what pixels take is in both and falls out."""
    return (run_of(MOST) - run_of(LEAST)) / (MOST.gaussians - LEAST.gaussians)


def bytes_beyond_file():
    """Memory of a Gaussian beyond its bytes in the file."""
    return fixed(each(lambda run: run.memory) - FILE, 0)


def microseconds(stage):
    """Processor time of a Gaussian."""
    return fixed(1e6 * each(lambda run: run.seconds[stage]), 1)


SPREADS = {
    "random": "even",
    "equal": "all equal",
    "clusters": "two clusters",
    "outlier": "a narrow cluster, few outliers",
    "logarithmic": "even in the logarithm",
}


def load():
    """Cycles and bytes of sorting of a splat in one window, by how many there are and how their depths are spread."""
    lines = data.prints.timing.load.lines
    header = ["depths", *(f"{group(line.splats)} splats" for line in lines)]
    return table(
        header,
        [
            [title, *(f"{fixed(line[f'cycles_{name}'], 2)}, {fixed(line[f'bytes_{name}'], 0)} B" for line in lines)]
            for name, title in SPREADS.items()
        ],
    )


def most_of_load(what):
    """The largest of all loads."""
    most = max(line[f"{what}_{name}"] for line in data.prints.timing.load.lines for name in SPREADS)
    return fixed(most, 1)
