# SPDX-License-Identifier: Apache-2.0
"""The scenes that pages measure, as .ply files in the build folder; None where the folder of scenes is not here."""
import lzma
import shutil
import subprocess

from sources import SCENES, SHARED

LEVEL = {"showroom": "1"}  # of detail, of a scene that comes in several


def prepared(scene, build):
    """The arguments that name the scene, [] for our own."""
    if scene == "own":
        return []
    source = SHARED / "scenes" / SCENES[scene]
    if not source.exists():
        return None
    ply, cameras = build / "figures" / (scene + ".ply"), source.parent / "cameras.json"
    if not ply.exists():
        ply.parent.mkdir(parents=True, exist_ok=True)
        fresh = ply.with_suffix(".new")
        if source.suffix == ".xz":
            with lzma.open(source) as packed, open(fresh, "wb") as out:
                shutil.copyfileobj(packed, out)
        elif source.suffix == ".ply":
            shutil.copyfile(source, fresh)
        else:  # to_ply.py wants Debian's python3-numpy and python3-pil
            subprocess.run(
                [
                    "/usr/bin/python3",
                    SHARED / "scenes/to_ply.py",
                    source / "lod-meta.json",
                    fresh,
                    LEVEL.get(scene, "0"),
                ],
                check=True,
            )
        fresh.rename(ply)
    return [str(ply), "--cameras", str(cameras)]


def reference(scene, view):
    """A view's picture by an independent renderer, beside the scene."""
    return SHARED / "scenes" / scene / f"reference{'_' + str(view) if view else ''}.png"
