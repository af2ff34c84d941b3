# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/rivals/rivals.md."""
import math

from data import data
from formats import fixed, mean, percent, table

MEASURED = ["rivals/pixels/*"]
SCENES = ("own", "terrace", "statue", "flowers", "plushdog")
PHOTOGRAPHS = 26.42  # dB against photographs in the paper's Table 1, 3DGS as it is


def db(value):
    return "equal" if value is None else fixed(value, 1)


def streams(scene):
    return data.rivals.pixels[scene].streaminggs


def stream(scene, group, voxel=0, part=0):
    """The row of an edge in units, or of one that is a part of the extent."""
    (row,) = [r for r in streams(scene) if r.group == group and r.part == part and (part or r.voxel == voxel)]
    return row


def megabytes(row):
    return fixed(row.bytes / 1e6, 0 if row.bytes >= 1e8 else 1)


def voxels():
    """An edge of 2 units, as the paper's, by the side of a group."""
    rows = []
    for scene in SCENES:
        for group in (16, 64, 128):
            row = stream(scene, group, voxel=2)
            rows.append(
                [
                    scene,
                    group,
                    db(row.order_db),
                    db(row.lost_db),
                    db(row.psnr_db),
                    fixed(row.largest, 2),
                    percent(row.visible, 1),
                    percent(row.lost_voxel, 1),
                    percent(row.late, 1),
                    megabytes(row),
                ]
            )
    head = ["scene", "group", "order alone", "lost alone", "both", "largest error", "pixels off by more than 1/255"]
    return table([*head, "pairs lost", "blends that come late", "MB"], rows)


def edges(group):
    """By edge: order alone / both, and MB."""

    def cells(edge):
        rows = [stream(scene, group, **edge) for scene in SCENES]
        return [f"{db(row.order_db)} / {db(row.psnr_db)}, {megabytes(row)}" for row in rows]

    rows = [[fixed(edge, 1), *cells({"voxel": edge})] for edge in (0.5, 1, 2, 4)]
    rows += [[f"extent / {part}", *cells({"part": part})] for part in (64, 32, 16)]
    extents = [fixed(data.rivals.pixels[scene].parameters.extent, 1) for scene in SCENES]
    return table(["edge", *(f"{scene}, extent {extent}" for scene, extent in zip(SCENES, extents))], rows)


def paths():
    rows = []
    for scene in SCENES:
        path = data.rivals.pixels[scene].path
        figures = [fixed(path.degrees, 0), fixed(path.turn, 2), fixed(path.move, 4), fixed(path.parallax, 2)]
        rows.append([scene, path.legs, *figures])
    return table(["scene", "legs", "degrees", "turn of a step", "units", "parallax"], rows)


def frame(scene, machine, speed):
    (row,) = [r for r in data.rivals.pixels[scene].frames if r.machine == machine and r.speed == speed]
    return row


def frames():
    """PSNR over the frames, and of the worst one."""
    machines = ("gsacc_all", "gsacc_seen", "neo", "neo_even")
    rows = []
    for scene in SCENES:
        for speed in (1, 2, 4, 8):
            found = [frame(scene, machine, speed) for machine in machines]
            cells = [f"{db(row.psnr_db)} ({db(row.worst_db)})" for row in found]
            seen = [percent(found[0].visible, 1), percent(found[2].visible, 1), percent(found[0].newcomers, 2)]
            rows.append([scene, f"{speed}x", *cells, *seen])
    head = ["scene", "speed", "GSAcc, all depths", "GSAcc, newcomers last", "Neo", "Neo, newcomers by last depths"]
    return table([*head, "pixels off, GSAcc", "pixels off, Neo", "newcomers"], rows)


def loss(psnr_db):
    """What an error of this PSNR takes of pictures with PHOTOGRAPHS dB, were the two errors independent."""
    return 0 if psnr_db is None else 10 * math.log10(1 + 10 ** ((PHOTOGRAPHS - psnr_db) / 10))


def losses():
    """Mean and worst scene, in dB and as a share of the decibels."""
    rows = []
    for speed in (1, 2, 4, 8):
        cells = []
        for machine in ("gsacc_all", "gsacc_seen", "neo"):
            lost = [loss(frame(scene, machine, speed).psnr_db) for scene in SCENES]
            cells += [f"{fixed(mean(lost), 3)} ({fixed(max(lost), 3)})", percent(max(lost) / PHOTOGRAPHS, 2)]
        rows.append([f"{speed}x", *cells])
    head = [name for one in ("GSAcc, all depths", "GSAcc, newcomers last", "Neo") for name in (one, "share, worst")]
    return table(["speed", *head], rows)


def layers(scene):
    """PSNR of the paper's layers in exact arithmetic, view 0."""
    return fixed(data.results[f"{scene}_0"].psnr_order_db, 1)
