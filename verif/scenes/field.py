#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""field.py PIPEGS: situations that people reported in public, each as a small file, give what a user would wish.

Needs   field/ of the folder that PIPEGS_SHARED names, or of ../shared; skipped (77) without it.
Idea    A case is a command and what must be true of it: exit code, words in its output, the picture within so many
        codes of the expected one. Cases of `train` need pipegs-studies beside PIPEGS.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

TRUTH = "--model truth --semantics inria --out {out}"
TRAIN = "--steps 200 --max-gaussians 400 --sh-degree 0 --out {out}"

# Case, command, exit code, words on stdout or stderr, codes that the picture may be off (None: no picture).
CASES = [
    ("01-nerfstudio-rgb", f"render splat.ply --cameras cam.json {TRUTH}", 0, ["red, green, blue"], 2),
    ("02-point-cloud", "info points.ply", 2, ["a point cloud, not Gaussian splats", "train from photographs"], None),
    ("04-linear-scales", "info linear.ply", 0, ["no Gaussian is smaller than 1 unit", "scales look linear"], None),
    ("04-linear-scales", "info linear.ply --strict", 2, ["scales look linear"], None),
    ("06-mip-filter3d", f"render mip.ply --cameras cam.json {TRUTH}", 0, ["filter_3D of Mip-Splatting is applied"], 1),
    ("08-sh-degree-4", f"render degree4.ply --cameras cam.json {TRUTH}", 0, ["degree 4"], 255),
    ("09-scaffold-gs", "info anchors.ply", 2, ["anchors of Scaffold-GS", "its own tools first"], None),
    ("11-small-unit-training", f"train unit_0.01 {TRAIN}", 0, ["near plane of 0.2", "--near"], None),
    ("12-utm-double", f"render utm.ply --cameras cam.json {TRUTH}", 0, ["is subtracted from them and from"], 1),
    ("12-utm-double", "info utm.ply", 0, ["64 bits, 32 about an origin"], None),
    ("13-gltf-log-scale", f"render log.gltf --cameras cam.json {TRUTH}", 0, ["taken as logarithms"], 2),
    ("13-gltf-log-scale", "convert log.gltf --out {out}", 0, ["200 Gaussians"], None),
    ("14-spz-not-gzipped", "info unzipped.spz", 0, ["the gzip around the .spz is missing"], None),
    ("15-ssog-zip", "info scene.ssog", 0, ["streamed SOG"], None),
    ("17-splat-nan-row", "info nan.splat", 0, ["non-finite values, culled: 1"], None),
    (
        "18-images-txt-one-line",
        f"render scene.ply --cameras garden {TRUTH} --view 9",
        0,
        ["no line of 2D points"],
        None,
    ),
    ("18-images-txt-one-line", f"train garden {TRAIN}", 0, ["2 of 10 views were held out"], None),
    ("20-exif-turned", f"train garden {TRAIN}", 0, ["turned as their EXIF orientation says"], None),
    ("24-colmap-4-models", f"render scene.ply --cameras EUCM {TRUTH}", 2, ["colmap image_undistorter"], None),
    ("24-colmap-4-models", f"render scene.ply --cameras SIMPLE_DIVISION {TRUTH}", 2, ["image_undistorter"], None),
    ("24-colmap-4-models", f"render scene.ply --cameras SIMPLE_FISHEYE {TRUTH}", 2, ["image_undistorter"], None),
    ("25-nerfstudio-frame", f"render splat.ply --cameras transforms.json {TRUTH}", 0, ["nerfstudio's export"], 1),
    (
        "25-nerfstudio-frame",
        f"render splat.ply --cameras dataparser_transforms.json {TRUTH}",
        2,
        ["name transforms.json"],
        None,
    ),
    ("26-nerfstudio-exported-cameras", f"render splat.ply --cameras camera_path.json {TRUTH}", 0, ["picture"], None),
    (
        "26-nerfstudio-exported-cameras",
        f"render splat.ply --cameras transforms_train.json {TRUTH}",
        2,
        ["nerfstudio's ns-export cameras", "transforms.json"],
        None,
    ),
    ("30-git-lfs-pointer", "info point_cloud.ply", 2, ["a Git LFS pointer", "git lfs pull"], None),
    ("30-git-lfs-pointer", f"render scene.ply --cameras cameras.json {TRUTH}", 2, ["a Git LFS pointer"], None),
]


def run(pipegs, folder, command, out):
    words = command.format(out=out).split()
    done = subprocess.run([pipegs, *words], cwd=folder, capture_output=True, check=False)
    try:
        return done.returncode, done.stdout.decode("utf-8"), done.stderr.decode("utf-8")
    except UnicodeDecodeError:
        return done.returncode, "", "no UTF-8"


def wrong(pipegs, folder, command, code, words, codes, out):
    """What is wrong, or nothing."""
    compared = codes is not None and (folder / "expected.png").exists()
    found, said, errors = run(pipegs, folder, command + (" --compare expected.png" if compared else ""), out)
    text = said + errors
    off = re.search(r"pixels differ, by (\d+) codes at most", text)
    if compared and (off is None or int(off[1]) > codes):
        return f"the picture: {text}"
    if found != code and not (compared and found == 1 and code == 0):
        return f"exit code {found}, expected {code}: {text}"
    missing = [word for word in words if word not in text]
    if missing:
        return f"no {missing} in: {text}"
    if code == 2 and errors.count("\n") != 1:
        return f"more than a line: {text}"
    return ""


def held_out_psnr(pipegs, folder, unit, out):
    _, said, _ = run(pipegs, folder, f"train {unit} {TRAIN}", out)
    found = re.search(r"exact order\s+([\d.]+) dB", said)
    return float(found[1]) if found else 0.0


def main():
    pipegs = pathlib.Path(sys.argv[1]).resolve()
    root = pathlib.Path(__file__).resolve().parents[2]
    field = pathlib.Path(os.environ.get("PIPEGS_SHARED", root.parent / "shared")) / "field"
    if not field.is_dir():
        print("skipped: no shared folder with field/")
        return 77
    trains = (pipegs.parent / "pipegs-studies").exists()
    failed = done = 0
    for case, command, code, words, codes in CASES:
        if command.startswith("train") and not trains:
            print(f"skipped: {case}: {command} (no pipegs-studies)")
            continue
        with tempfile.TemporaryDirectory() as out:
            what = wrong(pipegs, field / case, command, code, words, codes, out)
        done += 1
        if what:
            failed += 1
            print(f"{case}: {command}\n  {what}")
    if trains:
        with tempfile.TemporaryDirectory() as out:
            units = [held_out_psnr(pipegs, field / "11-small-unit-training", f"unit_{u}", out) for u in ("1", "0.01")]
        shutil.rmtree(out, ignore_errors=True)
        if abs(units[0] - units[1]) > 0.5:
            failed += 1
            print(f"11-small-unit-training: PSNR {units[0]} and {units[1]} in two units")
    print(f"{done - failed} of {done} commands give what is wanted")
    return 1 if failed else 0


sys.exit(main())
