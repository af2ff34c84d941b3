#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""to_ply.py IN OUT.ply [LOD]: PlayCanvas' SOG as a plain .ply in INRIA's layout.

IN      a .sog (zip), its meta.json in a folder, or the lod-meta.json of a streamed scene: then the Gaussians of level
        LOD (0 is the finest) of all its files.
SOG     version 2: images hold bytes of each Gaussian, row by row. Means: 16 bits in two images, sign(t) (e^|t| - 1).
        Quaternions: the three smallest in the order w x y z, the alpha channel says which is left out. Scales and
        colours: places in a table of 256. SH: a palette, 64 entries in a row of an image.
Needs   Debian's python3-numpy and python3-pil.
"""
import io
import json
import os
import posixpath
import sys
import zipfile

import numpy as np
from PIL import Image


def decode(open_file):
    """The table of one SOG: columns x y z, f_dc, f_rest by channel, opacity, scale, rot."""
    meta = json.loads(open_file("meta.json"))
    if meta.get("version") != 2:
        sys.exit("to_ply.py: meta.json: only version 2 of SOG is read")
    count = meta["count"]

    def image(part, number):
        return np.asarray(Image.open(io.BytesIO(open_file(meta[part]["files"][number]))).convert("RGBA"))

    def texels(part, number=0):
        return image(part, number).reshape(-1, 4)[:count]

    def table(part, places):
        return np.array(meta[part]["codebook"])[places]

    low, high = (texels("means", number)[:, :3].astype(np.float64) for number in (0, 1))
    first, last = np.array(meta["means"]["mins"]), np.array(meta["means"]["maxs"])
    logs = first + (last - first) * ((low + 256 * high) / 65535)
    means = np.sign(logs) * np.expm1(np.abs(logs))

    quats = texels("quats")
    if quats[:, 3].min() < 252:
        sys.exit("to_ply.py: quats: the alpha channel names no component")
    three = (quats[:, :3] / 255 - 0.5) * np.sqrt(2)
    largest = np.sqrt(np.maximum(0, 1 - (three**2).sum(1)))
    rot = np.empty((count, 4))
    for component in range(4):
        rows = quats[:, 3] == 252 + component
        rot[rows] = np.insert(three[rows], component, largest[rows], axis=1)

    sh0 = texels("sh0")
    alpha = np.clip(sh0[:, 3] / 255.0, 1e-5, 1 - 1e-5)
    rest = np.empty((count, 0))
    if "shN" in meta:
        centroids, labels = image("shN", 0), texels("shN", 1).astype(int)
        coefficients = centroids.shape[1] // 64
        palette = centroids[..., :3].reshape(-1, coefficients, 3)
        rest = table("shN", palette[labels[:, 0] + 256 * labels[:, 1]]).transpose(0, 2, 1).reshape(count, -1)
    opacity = np.log(alpha / (1 - alpha))[:, None]
    return np.hstack([means, table("sh0", sh0[:, :3]), rest, opacity, table("scales", texels("scales")[:, :3]), rot])


def read_folder(folder):
    def open_file(name):
        with open(os.path.join(folder, name), "rb") as file:
            return file.read()

    return decode(open_file)


def read_levels(path, level):
    """The rows of one level: every node of the tree names a range of a file for it."""
    with open(path, encoding="utf-8") as file:
        meta = json.load(file)
    ranges, nodes = {}, [meta["tree"]]
    while nodes:
        node = nodes.pop()
        part = node.get("lods", {}).get(str(level))
        if part:
            ranges.setdefault(part["file"], []).append((part["offset"], part["count"]))
        nodes += node.get("children", [])
    if not ranges:
        sys.exit(f"to_ply.py: {path}: no level {level}")
    tables = []
    for number in sorted(ranges):
        name = posixpath.dirname(meta["filenames"][number])
        rows = read_folder(os.path.join(os.path.dirname(path), name))
        tables.append(np.concatenate([rows[begin : begin + count] for begin, count in sorted(ranges[number])]))
    return np.concatenate(tables)


def write_ply(table, path):
    rest = table.shape[1] - 14
    names = ["x", "y", "z", "nx", "ny", "nz", "f_dc_0", "f_dc_1", "f_dc_2"] + [f"f_rest_{i}" for i in range(rest)]
    names += ["opacity", "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"]
    whole = np.insert(table, [3, 3, 3], 0, axis=1).astype("<f4")  # no normals
    with open(path + ".new", "wb") as file:
        header = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(whole)}\n"
        file.write((header + "".join(f"property float {name}\n" for name in names) + "end_header\n").encode())
        file.write(whole.tobytes())
    os.replace(path + ".new", path)


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    source = sys.argv[1]
    if os.path.basename(source) == "lod-meta.json":
        table = read_levels(source, int(sys.argv[3]) if len(sys.argv) == 4 else 0)
    elif os.path.basename(source) == "meta.json":
        table = read_folder(os.path.dirname(source))
    else:
        table = decode(zipfile.ZipFile(source).read)
    write_ply(table, sys.argv[2])
    print(f"{sys.argv[2]}: {len(table)} Gaussians, {(table.shape[1] - 14) // 3} SH coefficients beyond the first")


if __name__ == "__main__":
    main()
