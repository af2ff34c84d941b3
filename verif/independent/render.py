#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""render.py SCENE.ply CAMERAS.json VIEW OUT.pfm: a renderer of 3D Gaussians in numpy, written from INRIA's semantics.

It shares nothing with the C++ of this project, so that an error in one is not an error in the other. Everything is
computed in double precision; the picture is a float32 PFM (three channels, bottom row first), black behind. Semantics:
those of graphdeco-inria/diff-gaussian-rasterization at 59f5f77, Gaussian by Gaussian instead of tile by tile.
"""
import json
import sys

import numpy as np

C1 = 0.4886025119029199
C2 = (1.0925484305920792, -1.0925484305920792, 0.31539156525252005, -1.0925484305920792, 0.5462742152960396)
C3 = (-0.5900435899266435, 2.890611442640554, -0.4570457994644658, 0.3731763325901154)
C3 += (-0.4570457994644658, 1.445305721320277, -0.5900435899266435)


def read_ply(path):
    head, _, body = open(path, "rb").read().partition(b"end_header\n")
    names = [line.split()[2] for line in head.decode().split("\n") if line.startswith("property float ")]
    table = np.frombuffer(body, "<f4").reshape(-1, len(names)).astype(np.float64)
    return {name: table[:, i] for i, name in enumerate(names)}, len(table)


def colour(sh, d):  # sh: 16 coefficients by 3 channels
    x, y, z = d
    basis = [0.28209479177387814, -C1 * y, C1 * z, -C1 * x]
    basis += [C2[0] * x * y, C2[1] * y * z, C2[2] * (2 * z * z - x * x - y * y), C2[3] * x * z]
    basis += [C2[4] * (x * x - y * y), C3[0] * y * (3 * x * x - y * y), C3[1] * x * y * z]
    basis += [C3[2] * y * (4 * z * z - x * x - y * y), C3[3] * z * (2 * z * z - 3 * x * x - 3 * y * y)]
    basis += [C3[4] * x * (4 * z * z - x * x - y * y), C3[5] * z * (x * x - y * y), C3[6] * x * (x * x - 3 * y * y)]
    return np.maximum(np.array(basis) @ sh + 0.5, 0)


def rotation(q):
    w, x, y, z = q / np.linalg.norm(q)
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ])  # fmt: skip


def render(ply, count, camera):
    width, height, fx, fy = camera["width"], camera["height"], camera["fx"], camera["fy"]
    tan_x, tan_y = width / (2 * fx), height / (2 * fy)
    to_view, centre = np.array(camera["rotation"]).T, np.array(camera["position"])
    field = lambda *names: np.stack([ply[name] for name in names], 1)
    means, sigmas = field("x", "y", "z"), np.exp(field("scale_0", "scale_1", "scale_2"))
    turns, opacities = field("rot_0", "rot_1", "rot_2", "rot_3"), 1 / (1 + np.exp(-ply["opacity"]))
    rest = field(*[f"f_rest_{i}" for i in range(45)]).reshape(count, 3, 15)  # by channel
    sh = np.concatenate([field("f_dc_0", "f_dc_1", "f_dc_2")[:, None], rest.transpose(0, 2, 1)], 1)
    views = (means - centre) @ to_view.T
    row, column = np.mgrid[0:height, 0:width]
    image, through = np.zeros((height, width, 3)), np.ones((height, width))
    stopped = np.zeros((height, width), bool)
    for i in np.argsort(views[:, 2], kind="stable"):  # equal depth: by index
        x, y, z = views[i]
        if z <= 0.2:
            continue
        u = ((x / (tan_x * (z + 1e-7)) + 1) * width - 1) / 2  # the centre of pixel 0 is 0
        v = ((y / (tan_y * (z + 1e-7)) + 1) * height - 1) / 2
        guarded_x = np.clip(x / z, -1.3 * tan_x, 1.3 * tan_x) * z
        guarded_y = np.clip(y / z, -1.3 * tan_y, 1.3 * tan_y) * z
        jacobian = np.array([[fx / z, 0, -fx * guarded_x / z**2], [0, fy / z, -fy * guarded_y / z**2]])
        half = jacobian @ to_view @ rotation(turns[i]) * sigmas[i]
        (a, b), (_, c) = half @ half.T + 0.3 * np.eye(2)
        det = a * c - b * b
        middle = (a + c) / 2
        radius = np.ceil(3 * np.sqrt(middle + np.sqrt(max(0.1, middle * middle - det))))
        # Tiles of 16x16 that the square of three sigma touches; int() cuts towards zero as in C.
        left, right = max(0, int((u - radius) / 16)) * 16, max(0, int((u + radius + 15) / 16)) * 16
        top, bottom = max(0, int((v - radius) / 16)) * 16, max(0, int((v + radius + 15) / 16)) * 16
        power = -(c * (u - column) ** 2 + a * (v - row) ** 2) / (2 * det) + b * (u - column) * (v - row) / det
        alpha = np.minimum(0.99, opacities[i] * np.exp(np.minimum(power, 0)))
        seen = (column >= left) & (column < right) & (row >= top) & (row < bottom)
        seen &= (power <= 0) & (alpha >= 1 / 255) & ~stopped
        stops = seen & (through * (1 - alpha) < 1e-4)
        stopped |= stops
        seen &= ~stops
        direction = (means[i] - centre) / np.linalg.norm(means[i] - centre)
        image += np.where(seen, through * alpha, 0)[:, :, None] * colour(sh[i], direction)
        through = np.where(seen, through * (1 - alpha), through)
    return image


if __name__ == "__main__":
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    picture = render(*read_ply(sys.argv[1]), json.load(open(sys.argv[2], encoding="utf-8"))[int(sys.argv[3])])
    with open(sys.argv[4], "wb") as out:
        out.write(b"PF\n%d %d\n-1.0\n" % (picture.shape[1], picture.shape[0]))
        out.write(picture[::-1].astype("<f4").tobytes())
