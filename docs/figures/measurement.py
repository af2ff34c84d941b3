# SPDX-License-Identifier: Apache-2.0
"""One measurement: its command, what decides its figures, and how much it costs to measure them again."""
import re
import shlex
from collections.abc import Callable
from dataclasses import dataclass

from sources import PHOTOGRAPHS, ROOT, SCENES, digest, hash_of, named_machine

# a: models, counts, decibels, seconds to minutes: measured by every `make figures`. b: frames in RTL. c: synthesis,
# FPGAs, training, proofs, viewers. b and c are measured when what decides them has changed. A part named here makes a
# measurement at least of that class. d: full runs of what `make test` runs in part: hours, so nobody but who names them
# measures them, or hears from --check that the RTL has changed since.
CLASS_OF = {"rtl": "b", "synth": "c", "fpga": "c", "train": "c", "proofs": "c", "page": "c", "coverage": "c",
            "runs": "d"}  # fmt: skip
CLASSES = {
    "a": "models, counts, decibels: measured every time",
    "b": "frames in RTL",
    "c": "synthesis, FPGAs, training, proofs, viewers",
    "d": "full runs of long tests: measured when they are named",
}


@dataclass(frozen=True)
class Measurement:
    name: str  # FAMILY/ENTRY: the entry of docs/data/FAMILY.json
    command: str  # as a page shows it; {scene}: the scene's file, cameras and view; {levels}: all levels of detail
    by: tuple  # groups of sources.py that decide its figures; of `rtl` the modules of its machines
    scene: str = "own"
    view: int | None = 0  # None: the command names its views
    points: tuple = ()  # design points, when the command does not name them
    chart: str = ""  # the charts of its JSON are docs/images/CHART
    picture: tuple = ()  # (file of docs/images, file of the build folder that the command writes and that it becomes)
    targets: tuple = ()  # of the build, that the command needs beside pipegs
    read: Callable | None = None  # makes figures of a command's text; None: it prints JSON, whose keys are the figures
    exit_codes: tuple = (0,)  # of a run that counts; 1 where what differs is the figure
    alone: bool = False  # nothing else is measured meanwhile: it takes times
    differs: str = ""  # which of the quantities of equal.py is another one here, and why

    def shown(self):
        scene = f"{self.scene}.ply --cameras {self.scene}/cameras.json "
        if self.scene in PHOTOGRAPHS:
            scene = f"photos/{self.scene} "
        scene += f"--view {self.view} " if self.view is not None else ""
        shown = self.command.replace("{scene} ", "" if self.scene == "own" else scene)
        shown = shown.replace("{levels}", f"{self.scene}/ --cameras {self.scene}/cameras.json")
        return shown.replace("{reference}", "reference.png").replace("{truth}", "truth")

    @property
    def kind(self):
        """Its class: a, b, c or d."""
        return max(["a", *(CLASS_OF[part] for part in self.by if part in CLASS_OF)])

    def machines(self):
        """Of sources.py: the design points, each with what the command changes in it."""
        named = re.findall(r"--designs? (\S+)", self.command)
        points = named[0].split(",") if named else self.points
        options = [word for option in re.findall(r"--(?:set|config) (\S+)", self.command) for word in option.split(",")]
        if self.command.startswith("synth/memories.sh"):
            options = self.command.split()[1:]
        options += [f"units={count}" for count in re.findall(r"--units (\d+)", self.command)]
        return [named_machine(" ".join([point, *options])) for point in points]

    def parts(self):
        """The names of what decides its figures."""
        words = shlex.split(self.command)
        room = re.match(r"build/verif/(\w+)/", self.command)
        machines = self.machines()
        rtl = [f"rtl {machine}" for machine in machines]
        if not rtl:
            rtl = [f"rtl of {room[1]}" if room and (ROOT / "rtl" / room[1]).is_dir() else "rtl"]
        command = words[2] if words[1:2] == ["study"] else words[1] if words[0] == "build/pipegs" else ""
        study = "explore" if command in ("accuracy", "tradeoff", "shapes") else command
        return [
            *[part for part in self.by if part not in ("rtl", "train", "runs")],
            *(rtl if "rtl" in self.by else []),
            *[f"point {machine}" for machine in machines],
            *([f"study {study}"] if study and (ROOT / "sim/studies" / study).is_dir() else []),
            *([f"scene {self.scene}"] if self.scene in SCENES or self.scene in PHOTOGRAPHS else []),
        ]

    def hashes(self):
        """What stands under `by` of an entry that is measured now."""
        return {"command": digest([self.shown().encode()])} | {part: hash_of(part) for part in self.parts()}

    def older(self, entry):
        """Why an entry is no longer what today's sources give; a scene that is not here is no reason."""
        now = self.hashes()
        names = [*now, *(name for name in entry["by"] if name not in now)]
        return [name for name in names if entry["by"].get(name) != (now.get(name) or entry["by"].get(name))]
