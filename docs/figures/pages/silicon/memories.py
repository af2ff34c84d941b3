# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/silicon/silicon.md: every SRAM that Yosys finds, told by its place in the machine."""
import re

from data import data
from formats import fixed, group, table

PAPER_KB = 428
WHERE = [  # unit, place without generate blocks and the SU's wiring, what it holds, purpose
    ("alpha store", "u_store.u_lines", "lines of 64 alphas", "alphas"),
    ("alpha store", "u_store.u_slots", "slot of the line of each address", "alphas"),
    ("alpha store", "u_store.u_pool.u_back", "free slots", "alphas"),
    ("RU", "u_pixels.u_half_[01]", "T, RGB, done of a window's regions, twice", "pixels"),
    ("RU", "u_blend.*u_pixels", "T, RGB, done of a window's regions, once (`quads=1`)", "pixels"),
    ("SU", "u_su.u_records", "splats without their keys, a pool of slots", "records, keys"),
    ("SU", "u_su.u_keys", "{depth, index} of each slot", "records, keys"),
    ("SU", "u_buckets.u_table", "head, tail, count of each bucket of depth, two sets", "sorter"),
    ("SU", "u_buckets.u_words", "which buckets are filled", "sorter"),
    ("SU", "u_su.u_links", "chains of slots", "sorter"),
    ("SU", "u_slots.u_back", "free slots", "sorter"),
    ("SU", "u_split.u_stack", "groups that wait", "sorter"),
    ("SU", "u_su.u_marks", "ends that wait", "sorter"),
    ("SU", "u_su.u_chains", "released chains", "sorter"),
    ("SU", "u_emit.u_waiting", "sorted keys whose records are fetched", "sorter"),
    ("SU", "u_port.u_answers", "lines read back, only sets that spilled", "overflow"),
    ("SU", "u_port.u_owners", "whose these are", "overflow"),
    ("SU", "u_ways.u_asks", "each run's next line and keys left in it", "overflow"),
    ("SU", "u_tree.u_left", "keys of each run that the tree has not taken", "overflow"),
    ("SU", "u_tree.u_nodes", "the keys that wait in the tree", "overflow"),
    ("PU", "u_fetch.u_reader.u_lines", "geometry, two Gaussians a line", "parameters"),
    ("PU", "u_reach.u_words", "Gaussians before the cull by the ellipse (`tight_cull=1`)", "parameters"),
    ("PU", "u_parts.u_payload", "payloads of the parts of a window (`window=128`)", "parameters"),
    ("PU", "u_pu.u_visible", "Gaussians dealt to this PU", "parameters"),
    ("PU", "u_shape.u_centers", "means and opacities beside the projection", "parameters"),
    ("PU", "u_list.u_payload", "payloads until their colour is asked for (`order=1`)", "parameters"),
    ("PU", "u_regions.u_waiting", "what Gaussians have beside the mathematics", "parameters"),
    ("PU", "u_regions.u_payload", "the same of those that walk through their regions", "parameters"),
    ("PU", "u_pu.*u_walks", "Gaussians before `pu_intersect`", "parameters"),
    ("PU", "u_jobs", "Gaussians for the Row Units", "parameters"),
    ("PU", "u_color.*u_lines", "SH coefficients", "parameters"),
    ("PU", "u_color.*u_tasks", "Gaussians that wait for them", "parameters"),
    ("PU", "u_color.*u_directions", "their view directions", "parameters"),
    ("PU", "u_coeffs", "coefficients beside the colour (`late=1`)", "parameters"),
    ("PU", "u_expand.u_queue", "Gaussians whose windows are walked (`order=1`)", "parameters"),
    ("RU", "u_fetch.u_external", "overflowed lines of alphas", "overflow"),
    ("RU", "u_fetch.u_records", "regions whose line is on its way", "RU queues"),
    ("RU", "u_ru.u_queue", "sorted splats", "RU queues"),
    ("RU", "u_quads.u_queue", "halves of regions before a group of lanes (`quads=1`)", "RU queues"),
    ("DOPU", "u_dopu.*u_reader.u_lines", "groups and chunks", "scene"),
    ("DOPU", "u_cells.u_table", "the table of cells", "scene"),
    ("DOPU", "u_bucket.u_(nodes|heads|back|words)", "nodes that wait, by depth (`order=2`)", "scene"),
    ("DOPU", "u_load.*u_sums", "what a window on trial holds, by depth", "scene"),
    ("lists", "u_counts", "entries of each window's list (`order=1`)", "lists"),
    ("lists", r"u_read\..*u_lines", "lines of lists (`order=1`)", "lists"),
]
PURPOSES = {  # purpose: what it is, what the paper says of it
    "alphas": ("cached alphas", '"precompute and cache the alphas", no size'),
    "pixels": ("T and RGB of a window, twice", "T buffer, RGB buffer, no size"),
    "records, keys": ("records and keys", "sorted in the SU, no size"),
    "sorter": ("the sorter's buckets, chains, free slots, stack and queues", "not mentioned"),
    "parameters": (
        "Gaussian parameters: geometry, SH, queues between stages",
        '"double buffers for Gaussian parameters", no size',
    ),
    "scene": ("cells, groups and chunks of the scene", "not mentioned"),
    "lists": ("lists of the windows", "not mentioned"),
    "RU queues": ("queues before and in the RUs", "not mentioned"),
    "overflow": (
        "what lets alphas, records and keys overflow to external memory",
        "not mentioned: its buffers hold everything, by assumption",
    ),
}


def known(row):
    """The row of WHERE that an SRAM belongs to, and its place there."""
    place = re.sub(r"\b(?:gen_?\w*|genblk\d+|u_stores|u_gather|u_release|u_places)\.", "", row.place)
    found = [one for one in WHERE if re.search(rf"(?:^|\.){one[1]}(?:\.u_words)?$", place)]  # u_words: of a queue
    if "u_dopu." in row.place:
        found = [one for one in found if one[0] == "DOPU"]
    if len(found) != 1:
        raise KeyError(f"{row.place}: {len(found)} rows of WHERE in {__file__} know this SRAM")
    return found[0]


def bits(row):
    return row.width * row.depth * row["count"]


def kb(bits_):
    return fixed(bits_ / 8192, 1)


def total(name):
    return sum(bits(row) for row in data.memories[name])


def srams(name="fast"):
    """Every SRAM of a configuration."""
    rows = {}
    for row in data.memories[name]:
        where = known(row)
        key = (WHERE.index(where), row.width, row.depth, row.ports)
        rows.setdefault(key, [where, 0])[1] += row["count"]
    lines = []
    for (_, width, depth, ports), ((unit, place, holds, _), count) in sorted(rows.items()):
        place = place.replace(".*", "..").replace("[01]", "0, 1").replace("(nodes|heads|back)", "*")
        lines.append(
            [
                unit,
                f"`{place}`",
                holds,
                f"{width} x {depth} x {count}",
                ports,
                group(width * depth * count),
                kb(width * depth * count),
            ]
        )
    lines.append(["**sum**", "", "", "", "", f"**{group(total(name))}**", f"**{kb(total(name))}**"])
    return table(["unit", "instance", "holds", "width x depth x count", "ports", "bits", "KB"], lines)


def by_purpose(name):
    sums = dict.fromkeys(PURPOSES, 0)
    for row in data.memories[name]:
        sums[known(row)[3]] += bits(row)
    return sums


def purposes():
    """The paper's machine, `dop`, by purpose, beside the paper."""
    return table(
        ["purpose", "KB", "in the paper"],
        [
            [PURPOSES[purpose][0], kb(value), PURPOSES[purpose][1]]
            for purpose, value in by_purpose("dop").items()
            if value
        ],
    )


def more():
    """Against the paper's sum."""
    over = total("dop") / 8192 - PAPER_KB
    return f"{over:.1f} KB ({100 * over / PAPER_KB:.0f} %)"


def without_overflow():
    return f"{kb(total('dop') - by_purpose('dop')['overflow'])} KB"
