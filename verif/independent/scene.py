# SPDX-License-Identifier: Apache-2.0
"""scene.py: Gaussians for the independent check, and how they are written as a .ply.

Twenty-four Gaussians, placed for what renderers get wrong: needles and discs at an angle, a quaternion that is not of
length one, opaque ones in a row that end a pixel, two at one depth, faint ones on both sides of 1/255, the near plane,
means outside the image within and beyond the guard band, one smaller than a pixel, one of 1000 units. A camera at
CAMERA that is not turned sees depths that are equal to the last bit.
"""
import math
import random
import struct

CAMERA = (1.0, -2.0, 3.0)
LEVEL = (1.0, 0.0, 0.0, 0.0)


def gaussian(place, sigma, turn, opacity, colour):
    """Place before CAMERA (right, down, forward), sigma along three axes, quaternion (w x y z), opacity, RGB."""
    return place, sigma if isinstance(sigma, tuple) else (sigma,) * 3, turn, opacity, colour


SCENE = [
    gaussian((0.5, 0.3, 8.0), 2.0, LEVEL, 0.12, (0.2, 0.3, 0.6)),
    gaussian((-0.8, 0.4, 4.0), (0.6, 0.05, 0.04), (0.924, 0.0, 0.0, 0.383), 0.88, (0.9, 0.5, 0.1)),
    gaussian((0.9, -0.7, 3.5), (0.4, 0.3, 0.001), (0.85, 0.4, 0.3, -0.1), 0.8, (0.1, 0.8, 0.4)),
    # Four in a row, each cut to 0.99: after two of them the pixel stops, the fourth must not be seen.
    gaussian((0.30, 0.20, 2.00), 0.20, LEVEL, 0.9999, (0.8, 0.1, 0.1)),
    gaussian((0.33, 0.22, 2.25), 0.22, LEVEL, 0.9999, (0.1, 0.1, 0.8)),
    gaussian((0.37, 0.25, 2.50), 0.25, LEVEL, 0.9999, (0.1, 0.8, 0.1)),
    gaussian((0.45, 0.30, 3.00), 0.15, LEVEL, 0.9999, (3.0, 3.0, 3.0)),
    # Two at one depth: the index decides.
    gaussian((-0.75, -1.0, 5.0), 0.35, LEVEL, 0.7, (1.0, 0.0, 0.0)),
    gaussian((-0.50, -1.0, 5.0), 0.35, LEVEL, 0.7, (0.0, 0.0, 1.0)),
    # In front of the near plane at 0.2, behind it, and behind the camera.
    gaussian((0.00, 0.00, 0.19), 0.05, LEVEL, 0.9, (3.0, 0.0, 3.0)),
    gaussian((-0.06, 0.05, 0.21), 0.01, LEVEL, 0.6, (0.9, 0.9, 0.2)),
    gaussian((0.1, 0.1, -2.0), 0.5, LEVEL, 0.9, (3.0, 3.0, 0.0)),
    # Outside the image, within the guard band and beyond it.
    gaussian((1.35, 0.2, 2.0), (0.30, 0.10, 0.2), (0.9, 0.1, 0.2, 0.3), 0.8, (0.3, 0.9, 0.9)),
    gaussian((2.25, 0.9, 2.5), (0.80, 0.30, 0.4), (0.8, -0.2, 0.4, 0.1), 0.7, (0.9, 0.3, 0.9)),
    gaussian((-0.3, -1.25, 2.0), 0.45, LEVEL, 0.6, (0.9, 0.9, 0.9)),
    gaussian((-2.1, 1.4, 1.5), 0.70, LEVEL, 0.9, (0.4, 0.2, 0.1)),
    # Faint: 1.5 / 255, and below 1 / 255.
    gaussian((-1.2, 0.9, 4.0), 0.8, LEVEL, 1.5 / 255, (3.0, 3.0, 3.0)),
    gaussian((1.0, 0.8, 4.0), 0.8, LEVEL, 0.9 / 255, (3.0, 3.0, 3.0)),
    # Smaller than a pixel; a quaternion that is not of length one; a needle across the image; two large ones.
    gaussian((1.2, 1.1, 6.0), 0.001, LEVEL, 0.95, (1.0, 1.0, 1.0)),
    gaussian((-1.4, -0.2, 4.5), (0.5, 0.2, 0.05), (2.0, -1.0, 3.0, 0.5), 0.5, (0.6, 0.2, 0.7)),
    gaussian((0.0, 1.2, 6.5), (4.0, 0.02, 0.02), (0.97, 0.05, 0.1, 0.2), 0.75, (0.1, 0.6, 0.9)),
    gaussian((0.0, 0.0, 12.0), (3.0, 1.0, 0.5), (0.7, 0.3, -0.5, 0.4), 0.5, (0.5, 0.4, 0.1)),
    gaussian((100.0, 50.0, 1000.0), 300.0, LEVEL, 0.95, (0.15, 0.2, 0.3)),
    # Colours below zero, which are cut off.
    gaussian((0.2, -0.9, 4.0), 0.3, LEVEL, 0.85, (-0.6, 0.7, -0.2)),
]


def write_ply(path, scene, degree=3, antialiased=False):
    noise = random.Random(1)
    rest = 3 * ((degree + 1) ** 2 - 1)
    names = ["x", "y", "z", "nx", "ny", "nz", "f_dc_0", "f_dc_1", "f_dc_2"] + [f"f_rest_{i}" for i in range(rest)]
    names += ["opacity", "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"]
    with open(path, "wb") as file:
        header = "ply\nformat binary_little_endian 1.0\n" + ("comment antialiased 1\n" if antialiased else "")
        header += f"element vertex {len(scene)}\n"
        file.write((header + "".join(f"property float {name}\n" for name in names) + "end_header\n").encode())
        for place, sigma, turn, opacity, colour in scene:
            row = [a + b for a, b in zip(place, CAMERA)] + [0.0] * 3
            row += [(value - 0.5) / 0.28209479177387814 for value in colour]
            row += [noise.uniform(-0.2, 0.2) for _ in range(rest)]
            row += [math.log(opacity / (1 - opacity))] + [math.log(s) for s in sigma] + list(turn)
            file.write(struct.pack(f"<{len(row)}f", *row))


def turned(about_y, about_x):
    """Camera to world: a turn about the y axis, then the camera's own about its x axis."""
    c, s, k, l = math.cos(about_y), math.sin(about_y), math.cos(about_x), math.sin(about_x)
    return [[c, s * l, s * k], [0.0, k, -l], [-s, c * l, c * k]]
