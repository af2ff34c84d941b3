# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/cycles/cycles.md."""
from data import data
from formats import fixed, group, millions, percent, table, thousands

MEASURED = ["results/*", "truth/*", "ladder/own", "ladder/terrace", "stores/terrace/*"]
VIEWS = [(scene, view) for scene in ("terrace", "statue", "plushdog") for view in (0, 1, 2)]
PIXELS = {"terrace": "1236x822", "statue": "960x1280", "plushdog": "1500x1000"}


def of(scene, view):
    return data.results[f"{scene}_{view}"]


def views():
    """Errors and cycles."""
    rows = []
    for scene, view in VIEWS:
        row = of(scene, view)
        rows.append(
            [
                f"{scene} {view}",
                PIXELS[scene],
                row.mismatches,
                millions(row.beats_compared, 1),
                fixed(row.psnr_numeric_db, 1),
                fixed(row.psnr_order_db, 1),
                fixed(row.psnr_total_db, 1),
                fixed(row.max_abs_error, 4),
                millions(row.cycles),
                row.bounds.largest,
                fixed(row.bounds.cycles_over_largest, 2),
                fixed(row.wall_seconds.golden, 1),
                group(row.wall_seconds.rtl),
                group(row.rtl_khz),
            ]
        )
    return table(
        [
            "scene, view",
            "pixels",
            "mismatches",
            "beats",
            "numeric dB",
            "order dB",
            "total dB",
            "largest error",
            "cycles",
            "largest bound",
            "roofline ratio",
            "golden s",
            "RTL s",
            "kHz",
        ],
        rows,
    )


def work():
    """Counts of the work, bounds and traffic."""
    rows = []
    for scene, view in VIEWS:
        row = of(scene, view)
        streams = row.bytes_by_stream
        counts = [row.work[name] for name in ("fetched", "visible", "records", "regions", "open_regions")]
        bounds = [row.bounds[name] for name in ("pu_rows", "ru", "cull", "memory")]
        traffic = [streams.geometry, streams.color, streams.nodes, row.alpha_bytes]
        rows.append(
            [
                f"{scene} {view}",
                *[group(count / 1e3) for count in counts],
                fixed(row.work.blended / 1e6, 1),
                *[fixed(bound / 1e6, 2) for bound in bounds],
                *[group(count / 1e6) for count in traffic],
                fixed(streams.sort_overflow / 1e6, 1),
                fixed(row.pixel_bytes / 1e6, 1),
            ]
        )
    return table(
        [
            "scene, view",
            "fetched",
            "visible",
            "records",
            "regions",
            "open",
            "blended",
            "PU rows",
            "RU",
            "cull",
            "memory",
            "geometry",
            "SH",
            "nodes",
            "alphas",
            "sort",
            "pixels",
        ],
        rows,
    )


def share(unit, state):
    """Of the cycles of the units of this kind, in terrace 0."""
    units = data.results.terrace_0.units[unit]
    return sum(one[state] for one in units) / (len(units) * data.results.terrace_0.cycles)


def units():
    """Where the cycles of terrace 0 go."""
    states, names = ("busy", "starved", "blocked", "memory"), {"dopu": "DOPU", "pu": "PU", "su": "SU", "ru": "RU"}
    rows = [
        [name + ("" if unit == "dopu" else " (mean of 4)"), *[percent(share(unit, state), 1) for state in states]]
        for unit, name in names.items()
    ]
    return table(["unit", *states], rows)


def truth():
    """Our float64 pictures against those of an independent renderer."""
    rows = [
        [f"{scene} {view}", row.pixels, row.differ, row.codes]
        for scene, view in VIEWS
        for row in [data.truth[f"{scene}_{view}"]]
    ]
    return table(["scene, view", "pixels", "pixels that differ", "largest difference, 8-bit codes"], rows)


def bound(point):
    return point.cycles / point.cycles_over_largest_bound


def speed():
    """The least and the largest kHz."""
    speeds = [of(scene, view).rtl_khz for scene, view in VIEWS]
    return f"{group(min(speeds))} to {group(max(speeds))}"
