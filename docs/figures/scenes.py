# SPDX-License-Identifier: Apache-2.0
"""The scenes that pages measure, as .ply files in the build folder; None where the folder of scenes is not here."""
import lzma
import shutil
import subprocess

from sources import PHOTOGRAPHS, SHARED, hash_of, place_of

LEVEL = {"showroom": "1"}  # of detail, of a scene that comes in several
SPLIT = {f"own_{millions}m": 1000000 * millions for millions in (1, 2, 4, 8, 16)}  # our own, each Gaussian in parts
SIZES = ("1296x840", "648x420", "2592x1680", "3840x2160")  # of their pictures: three views at each size, in this order
VIEWS_OF_SIZE = 3


def split(scene, build):
    """Our own scene, split into as many Gaussians as its name says."""
    folder = build / "figures" / scene
    if not (folder / "cameras.json").exists():  # it is written last
        subprocess.run(["cmake", "--build", build, "--target", "split_scene"], check=True, stdout=subprocess.DEVNULL)
        subprocess.run([build / "verif/scenes/split_scene", str(SPLIT[scene]), folder, *SIZES], check=True)
    return [str(folder / "scene.ply"), "--cameras", str(folder / "cameras.json")]


def prepared(scene, build):
    """The arguments that name the scene, [] for our own."""
    if scene == "own":
        return []
    if scene in SPLIT:
        return split(scene, build)
    source = place_of(scene)
    if not source.exists():
        return None
    if scene in PHOTOGRAPHS:
        return [str(source)]
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


def levels(scene):
    """The arguments that name a streamed scene as it came, with all its levels of detail."""
    place = place_of(scene)
    return [str(place), "--cameras", str(place.parent / "cameras.json")]


def truth(scene, build):
    """A folder with the first view of the whole scene in float64, named as that of a sequence is."""
    folder = build / "figures" / f"{scene}_truth_{hash_of('models')}"
    if not (folder / "frame_0000.png").exists():
        words = ["--view", "0", "--model", "truth", "--semantics", "inria", "--out", folder]
        subprocess.run(
            [build / "pipegs", "render", *prepared(scene, build), *words], check=True, stdout=subprocess.DEVNULL
        )
        (folder / "frame.png").rename(folder / "frame_0000.png")
    return folder
