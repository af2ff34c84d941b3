#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""pictures.py FOLDER: writes what the test reads: scenes, cameras, and render.py's pictures of each.

Four scenes, scene_DEGREE.ply with SH of that degree, every second one antialiased: the Gaussians of scene.py and two
hundred random ones, from a hundredth of a pixel to the whole picture. Two views, cameras.json: several windows with
parts of windows at both borders, fx not fy, the principal point far off the centre. Pictures: DEGREE_VIEW.pfm and
DEGREE_VIEW_planes.pfm by INRIA's rules, whole_... by those of machines (render.py).
"""
import json
import random
import sys

from render import Scene, render, write_pfm
from scene import CAMERA, SCENE, gaussian, turned, write_ply


def random_scene():
    draw = random.Random(2)
    for _ in range(200):
        depth = 0.25 * 60 ** draw.random()
        place = (depth * draw.uniform(-0.9, 0.9), depth * draw.uniform(-0.9, 0.9), depth)
        sigma = tuple(depth * 0.0005 * 200 ** draw.random() for _ in range(3))
        turn, opacity = [draw.gauss(0, 1) for _ in range(4)], 0.003 * 300 ** draw.random()
        yield gaussian(place, sigma, turn, opacity, [draw.uniform(-0.1, 1.1) for _ in range(3)])


def camera(number, size, focal, centre, position, rotation):
    return {
        "id": number, "img_name": f"view_{number}", "width": size[0], "height": size[1], "position": position,
        "rotation": rotation, "fy": focal[1], "fx": focal[0], "cx": centre[0], "cy": centre[1],
    }  # fmt: skip


if __name__ == "__main__":
    folder = sys.argv[1]
    level = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    cameras = [
        camera(0, (168, 104), (131.0, 97.5), (61.25, 66.5), list(CAMERA), level),
        camera(1, (136, 72), (88.0, 120.25), (90.5, 20.75), [3.5, -3.0, 3.25], turned(-0.6, -0.2)),
    ]
    with open(f"{folder}/cameras.json", "w", encoding="utf-8") as file:
        json.dump(cameras, file)
    for degree in range(4):
        path = f"{folder}/scene_{degree}.ply"
        write_ply(path, SCENE + list(random_scene()), degree, degree % 2 == 0)
        scene = Scene(path)
        for view, seen in enumerate(cameras):
            for rules, name in ((False, f"{degree}_{view}"), (True, f"whole_{degree}_{view}")):
                picture, planes = render(scene, seen, rules)
                write_pfm(f"{folder}/{name}.pfm", picture)
                write_pfm(f"{folder}/{name}_planes.pfm", planes)
