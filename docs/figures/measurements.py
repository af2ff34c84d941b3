# SPDX-License-Identifier: Apache-2.0
"""What is measured: for each file under docs/data the command that writes it, and what measures it."""
from collections.abc import Callable
from dataclasses import dataclass
from itertools import accumulate

from keep.frames import (
    effects,
    effects_gain,
    fetched,
    frame,
    host,
    host_model,
    ladder,
    lanes,
    large_model,
    models,
    one_model,
    one_store,
    profile,
    shapes,
    speed,
    sweep,
    tradeoff,
    views,
    walk,
    walk_frames,
)
from keep.numerics import accuracy, accuracy_rtl, budget, errors, fine_tuned, golden, stability, trained
from keep.parts import pick
from keep.rivals import rivals, rivals_and_parameters
from keep.silicon import compared, cost, energy, equal_area, fpga, leave_one_out, netlist, silicon
from keep.texts import difference, printed, proofs, shown, tables
from scenes import SIZES, VIEWS_OF_SIZE
from sources import PHOTOGRAPHS

RTL = ("rtl", "models", "memory")
MODEL = ("models", "timing", "memory")
POINTS = ("gscore", "baseline", "dpc", "tspp", "dop", "late", "exact", "fast")


def points_of(*figures):
    """The design points that each of these was measured on."""
    return [point for point in POINTS if all(point in one for one in figures)]


@dataclass(frozen=True)
class Measurement:
    name: str  # FAMILY/ENTRY: the entry of docs/data/FAMILY.json
    command: str  # as a page shows it; {scene}: the scene's file, cameras and view
    keep: Callable | None  # of what the command prints (JSON, or else text): the figures; None: all of its JSON
    by: tuple  # groups of sources.py that measure it
    scene: str = "own"
    view: int | None = 0  # None: the command names its views
    points: tuple = ()  # design points
    chart: str = ""  # docs/images/CHART is drawn, too
    exit_codes: tuple = (0,)  # of a run that counts; 1 where what differs is the figure

    def shown(self):
        scene = f"{self.scene}.ply --cameras {self.scene}/cameras.json "
        if self.scene in PHOTOGRAPHS:
            scene = f"photos/{self.scene} "
        scene += f"--view {self.view} " if self.view is not None else ""
        shown = self.command.replace("{scene} ", "" if self.scene == "own" else scene)
        return shown.replace("{reference}", "reference.png")


# Tables: as many entries in a line as fit.
# fmt: off
CHARTED = ("own", "terrace")
FOUR = ("own", "terrace", "statue", "flowers")
BUSES = (0, 512, 256, 128)  # bits of the bus to memory; 0: the core's own port
WHAT_IF = {  # of the design point exact: one thing changed
    "chunk32": "--set chunk=32 --set group=16",
    "records1024": "--set records=1024",
    "records4096": "--set records=4096",
    "bandwidth102": "--memory lpddr5-6400x8",
    "quads": "--set quads=1",
    "quads_bandwidth102": "--set quads=1 --memory lpddr5-6400x8",
}
STORES = {  # of the design point dop: lines of an alpha store, and layers that live in it
    "lines1024_layers2": "--set alpha_layers=2",
    "lines1024_layers4": "--set alpha_layers=4",
    "lines1024": "",
    "paper": "--set alpha_lines=840 --set records=512",  # all memories together as large as the paper's 428 KB
    "lines2048": "--set alpha_lines=2048",
    "lines4096": "--set alpha_lines=4096",
    "lines8192_layers2": "--set alpha_lines=8192 --set alpha_layers=2",
    "lines8192_layers4": "--set alpha_lines=8192 --set alpha_layers=4",
    "lines8192": "--set alpha_lines=8192",
}
STORES = {name: f"--design dop {change}".rstrip() for name, change in STORES.items()}
STORES["baseline"] = "--design baseline"
POSITIONS = {"plain": "", "finer": " --set pos_w=18 --set base_w=14"}  # of dop: a record has as many bytes
ADDED = {  # from exact towards fast: what each step adds to the one before
    "fine_quads": ("the numbers of `sim/fine.cfg`, living quads", "--config sim/fine.cfg --set quads=1"),
    "window128": ("windows of four parts", "--set window=128"),
    "buckets": ("buckets of 1/64 octave", "--set bucket_bits=6"),
    "tests2": ("two tests of regions in a cycle", "--set tests=2"),
    "tight": ("a cull by the ellipse itself", "--set tight_cull=1"),
    "fronts": ("two of the four PUs fetch and cull", "--set fronts=2"),
    "boxes": ("boxes around ellipsoids in the DOPU, groups of 16 chunks", "--set tight_boxes=1 --set group=16"),
}
SUMS = accumulate((change for _, change in ADDED.values()), "{} {}".format)
STEPS = {name: (what, change) for (name, (what, _)), change in zip(ADDED.items(), SUMS)}
STEPS = {name: (what, f"--design exact {change}") for name, (what, change) in STEPS.items()}
STEPS["fast"] = ("pixels of 32 bits, 1408 records, 1024 nodes, a watermark every 7 chunks: `fast`", "--design fast")
COSTED = {"exact": ("`exact`", "--design exact")} | STEPS  # with their area and energy
EQUAL_AREA = "--equal-area 3.283 "  # mm2 of the paper's chip; `make synth` of half of each machine comes first
LARGE = {  # showroom, 3.0 M Gaussians
    "exact": ("`exact`", "--design exact"),
    "fast": ("`fast`", "--design fast"),
    "fast_records4096": ("`fast` and `--set records=4096`", "--design fast --set records=4096"),
}
SCALED = {  # scale: our own scene in parts, and the view; millions of Gaussians, then pixels
    **{f"gaussians_{millions}m": (f"own_{millions}m", 0) for millions in (1, 2, 4, 8, 16)},
    **{f"pixels_{size}": ("own_1m", VIEWS_OF_SIZE * place) for place, size in enumerate(SIZES) if place},
}
SYNTHESISED = {  # silicon/NAME: options; `make synth` of the same configuration comes first
    "dop": "--design dop ", "exact": "--design exact ", "exact_fine": "--design exact --config sim/fine.cfg ",
    "exact_quads": "--design exact --config sim/fine.cfg --set quads=1 ",
    "fast": "--design fast ",
    "exact_records1024": "--design exact --set records=1024 ", "dop_sky130": "--design dop --library sky130hd_tt ",
}
MEMORIES = {  # memories/NAME: settings of the design point
    "dop": "", "gscore": "window=16 late=1 order=1 quadratic=1 tile_test=2 records=2048",
    "baseline": "late=1 order=1 quadratic=1 records=2048", "dpc": "late=1 order=1 records=2048",
    "tspp": "order=1", "late": "late=1 records=2048", "exact": "late=1 order=2 records=2048 bucket_bits=5",
    "fast": "fronts=2 window=128 group=16 late=1 order=2 quads=1 pos_w=18 base_w=14 mantissa_w=22 coeff_f=24 "
            "tight_cull=1 tight_boxes=1 tests=2 alpha_w=10 pixel_w=32 records=1408 bucket_bits=6 "
            "nearest_nodes=1024 mark_chunks=7",
}
TRAINED = {  # trained/plush/NAME: how a scene of photographs is trained for layers
    "none": "--order exact --cldr none", "printed": "--order exact --cldr printed",
    "relative": "--order exact --cldr relative", "order": "--cldr none", "order_relative": "--cldr relative",
    "order_logarithm": "",
}
FINE_TUNED = "--around 9 --steps 1500 --layers 4 --downscale 3"  # of a trained scene, on its own renders
VIEWED = {  # viewer/SCENE: in a viewer of the web; options
    "own": "--scale 0.25 ", "plushdog": "", "terrace": "", "flowers": "",
}
PRINTS = {  # a test that prints what it measures: its room, the line, names of the line's numbers
    "recip": ("lib/math", r"recip, (\d+) bits: worst error ([\d.]+)", "bits", "units"),
    "exp2": ("lib/math", r"exp2: error ([-\d.]+) \.\. ([-\d.]+) .*chord ([\d.]+), step ([\d.]+)",
             "low", "high", "chord", "step"),
    "exp2_step": ("lib/math", r"exp2: error ([-\d.]+) \.\. ([-\d.]+) ", "low", "high"),
    "log2": ("lib/math", r"log2: worst error (\S+)", "worst"),
    "rsqrt": ("lib/math", r"worst relative error 2\^(\S+)", "worst"),
    "dopu_planes": ("dopu", r"largest error of an edge ([\d.]+) px", "px"),
    "dopu_depth": ("dopu/nearest", r"least distance from a bound ([\d.]+) units of ([\d.]+)", "left", "given"),
    "dopu_origin": ("dopu", r"largest error ([\d.]+) units", "units"),
    "pu_project": ("pu/project",
                   r"1/z 2\^(\S+) relative; tan 2\^([^;]+); mean 2\^(\S+) px .*, 2\^(\S+) relative .* 2\^(\S+) rad",
                   "inverse", "tangent", "mean", "far", "direction"),
    "pu_orient": ("pu/project", r"worst entry differs by (\S+) from", "worst"),
    "pu_covariance": ("pu/project", r"error of a 2\^([-\d.]+), c 2\^([-\d.]+), det 2\^([-\d.]+), .* 2\^([-\d.]+)",
                      "a", "c", "det", "b"),
    "pu_axes": ("pu/box", r"error of tilt (\S+); relative, of stretch (\S+), of shrink (\S+), of the eigenvalue (\S+)",
                "tilt", "stretch", "shrink", "larger"),
    "pu_box": ("pu/box", r"3/256 px and (\S+), extents by 3/32 px and (\S+) of", "side", "extent"),
    "pu_compensate": ("pu/project", r"pu_compensate: error (\S+) of", "worst"),
    "pu_conic": ("pu/conic", r"narrow (\S+), of wide (\S+), error of slope ([^;\s]+); .* 1/4 px and ([\d.]+) %",
                 "narrow", "wide", "slope", "percent"),
    "pu_color_rotate": ("pu/color", r"worst error ([\d.]+) units", "units"),
    "pu_color_normalise": ("pu/color", r"of a component 2\^([-\d.]+)", "worst"),
    "pu_color_basis": ("pu/color", r"worst error 2\^([-\d.]+)", "worst"),
    "pu_color_sum": ("pu/color", r"worst error ([\d.]+) units", "units"),
    "pu_color": ("pu/color", r"worst error 2\^([-\d.]+)", "worst"),
    "ru_blend": ("ru", r"T at most ([^,]+), colour at most ([^,]+), rms (\S+)", "t", "color", "rms"),
    "pu_coeff": ("pu/conic", r"up to +(\d+) px: error of the power (\S+) \(.*\), rms (\S+); from .* (\S+)\n",
                 "sigma", "worst", "rms", "quantised"),
    "pu_intersect": ("pu/conic", r"up to +(\d+) px: +([\d.]+) regions .* counts, ([-+\d.]+) % .* boxes ([\d.]+)",
                     "sigma", "regions", "percent", "boxes"),
    "pu_rows": ("pu/rows",
                r"(\d+) visible pixels, alpha error at most ([\d.]+) .*bound ([\d.]+)\), power error ([\d.]+).*, (\d+) "
                r"decisions", "pixels", "alpha", "bound", "power", "flipped"),
    "su": ("su", r"(\d+) keys per layer: ([\d.]+) cycles per key, .* depths ([\d.]+), clustered ([\d.]+)",
           "keys", "random", "narrow", "clustered"),
    "load": ("timing", r"(\d+) splats.*clusters ([\d.]+), ([\d.]+); equal ([\d.]+), ([\d.]+); logarithmic ([\d.]+), "
             r"([\d.]+); outlier ([\d.]+), ([\d.]+); random ([\d.]+), ([\d.]+)", "splats",
             *(f"{what}_{spread}" for spread in ("clusters", "equal", "logarithmic", "outlier", "random")
               for what in ("cycles", "bytes"))),
}
TABLE = [
    *[Measurement(f"ladder/{scene}", "build/pipegs ladder {scene} --json", ladder, RTL, scene, points=POINTS,
                  chart=f"ladder_{scene}.svg" if scene in CHARTED else "") for scene in FOUR],
    *[Measurement(f"sweep/{scene}", "build/pipegs sweep {scene} --designs baseline,dop,exact,fast --json", sweep, MODEL,
                  scene, points=("baseline", "dop", "exact", "fast"),
                  chart=f"sweep_{scene}.svg" if scene in CHARTED else "") for scene in FOUR],
    *[Measurement(f"what_if/{scene}/{name}", f"build/pipegs model {{scene}} --design exact {change} --json", one_model,
                  MODEL, scene, points=("exact",)) for name, change in WHAT_IF.items() for scene in FOUR],
    *[Measurement(f"bus/{scene}/bits{bits}", f"build/pipegs model {{scene}} --design fast --set bus_w={bits} --json",
                  one_model, MODEL, scene, points=("fast",)) for bits in BUSES for scene in FOUR],
    *[Measurement(f"views/{scene}",
                  "build/pipegs sim {scene} --design fast --views 0-2 --json", views, RTL, scene, None,
                  ("fast",)) for scene in CHARTED],
    *[Measurement(f"walks/{scene}", f"build/pipegs sim {{scene}} --design fast --path 120 --no-rtl --frames none "
                  f"--out paths/{scene} --json", walk, (*MODEL, "path", "synth"), scene, None, ("fast",))
      for scene in CHARTED],
    *[Measurement(f"walks/{name}", f"build/pipegs sim --design fast --path 5 --scale 0.25 {option}--frames none "
                  f"--out paths/{name} --json", walk_frames, (*RTL, "timing", "path"), "own", None, ("fast",))
      for name, option in (("rtl", ""), ("model", "--no-rtl "))],
    *[Measurement(f"steps/{scene}/{name}", f"build/pipegs model {{scene}} {change} --json", one_model, MODEL, scene,
                  points=(change.split()[1],)) for name, (_, change) in STEPS.items() for scene in FOUR],
    *[Measurement(f"costs/{name}", f"build/pipegs silicon {change} --json", cost, (*RTL, "synth"),
                  points=(change.split()[1],)) for name, (_, change) in COSTED.items()],
    *[Measurement(f"large/showroom/{name}", f"build/pipegs model {{scene}} {options} --json", large_model, MODEL,
                  "showroom", points=(options.split()[1],)) for name, (_, options) in LARGE.items()],
    *[Measurement(f"scale/sim/{name}",
                  "build/pipegs sim {scene} --design dop --no-rtl --json", host, ("models",), scene,
                  view, ("dop",)) for name, (scene, view) in SCALED.items()],
    *[Measurement(f"scale/model/{name}", "build/pipegs model {scene} --design fast --set records=4096 --json",
                  host_model, MODEL, scene, view, ("fast",))
      for name, (scene, view) in SCALED.items()],
    *[Measurement(f"lanes/{scene}", "build/pipegs sim {scene} --design exact --set quads=1 --no-rtl --no-truth --json",
                  lanes, ("models",), scene, points=("exact",)) for scene in FOUR],
    *[Measurement(f"results/{scene}_{view}", "build/pipegs sim {scene} --design dop --json", frame, RTL, scene, view,
                  ("dop",))
      for scene in ("terrace", "statue", "plushdog") for view in (0, 1, 2)],
    *[Measurement(f"truth/{scene}_{view}", "build/pipegs render {scene} --model truth --semantics inria "
                  f"--compare {{reference}} --out build/figures/truth", difference, ("models",), scene, view,
                  exit_codes=(0, 1))
      for scene in ("terrace", "statue", "plushdog") for view in (0, 1, 2)],
    *[Measurement(f"model/{scene}", f"build/pipegs model {{scene}} --designs {','.join(POINTS)} --json", models, MODEL,
                  scene, points=POINTS) for scene in FOUR],
    Measurement("model/check", f"build/pipegs model --designs {','.join(POINTS)} --check --json", models,
                ("rtl", *MODEL), points=POINTS),
    *[Measurement(f"profile/{scene}_chunk32", "build/pipegs profile {scene} --design dop --no-rtl --set chunk=32 "
                  "--set group=16 --json", fetched, ("models",), scene, points=("dop",))
      for scene in ("terrace", "statue")],
    Measurement("pipelines/terrace", "build/pipegs rivals {scene} --pipelines --json", dict, RTL, "terrace",
                points=("dop", "fast"), chart="rivals/pipelines_terrace.svg"),
    *[Measurement(f"printed/{scene}", "build/pipegs profile {scene} --json", profile, RTL, scene, points=("baseline",))
      for scene in FOUR],
    *[Measurement(f"prints/{room.split('/')[0]}/{test}", f"build/verif/{room}/{test}_test", printed(*what),
                  ("rtl", "models"))
      for test, (room, *what) in PRINTS.items()],
    Measurement("shown/sim", "build/pipegs sim --out build/out", shown, RTL, points=("fast",)),
    Measurement("shown/profile", "build/pipegs profile --no-rtl", shown, ("models", "cost"),
                points=("baseline",), chart="profile.svg"),
    Measurement("loops/all", "verif/self/loop.sh", dict, RTL),
    Measurement("speed/fast", "verif/speed/speed.sh fast", speed, (*RTL, "simulator"), points=("fast",)),
    Measurement("proofs/all", "synth/prove.sh", proofs, ("rtl", "proofs")),
    Measurement("dram/check", "build/pipegs dram", tables("runs"), ("memory",)),
    Measurement("dram/worth", "build/pipegs dram --mappings", tables("mappings", "steps"), ("memory",)),
    *[Measurement(f"stores/{scene}/{name}", f"build/pipegs model {{scene}} {change} --json", one_store, MODEL, scene,
                  points=(change.split()[1],)) for name, change in STORES.items() for scene in FOUR],
    *[Measurement(f"positions/{scene}/{name}",
                  f"build/pipegs sim {{scene}} --design dop{change} --no-rtl --json", errors,
                  ("models",), scene, points=("dop",)) for name, change in POSITIONS.items() for scene in FOUR],
    *[Measurement(f"silicon/{name}", f"build/pipegs silicon {options}--no-energy --json", silicon, ("rtl", "synth"),
                  points=(options.split()[1],)) for name, options in SYNTHESISED.items()],
    *[Measurement(f"fpga/{point}_{family}_{units}", f"synth/fpga/fpga.py --build build/. --design {point} "
                  f"--units {units} --families {family} --json", fpga, ("rtl", "fpga"), points=(point,))
      for point in ("dop", "fast") for family in ("xcup", "ecp5") for units in (1, 2, 4)],
    Measurement("shapes/own", "build/pipegs shapes --design exact --json", shapes, MODEL, points=("exact",),
                chart="shapes_own.svg"),
    Measurement("shapes/fast", "build/pipegs shapes --design fast --json", shapes, MODEL, points=("fast",)),
    *[Measurement(f"energy/{scene}", f"build/pipegs silicon {{scene}} --designs {','.join(POINTS)} --json", energy,
                  (*RTL, "synth"), scene, points=POINTS, chart="silicon.svg" if scene == "own" else "")
      for scene in FOUR],
    *[Measurement(f"equal_area/{scene}", f"build/pipegs silicon {{scene}} --designs {','.join(POINTS)} {EQUAL_AREA}"
                  "--no-energy --json", equal_area, ("rtl", *MODEL, "synth"), scene, points=POINTS) for scene in FOUR],
    *[Measurement(f"energy/{scene}_sky130", "build/pipegs silicon {scene} --design dop --library sky130hd_tt --json",
                  energy, (*RTL, "synth"), scene, points=("dop",)) for scene in CHARTED],
    *[Measurement(f"accuracy/{scene}",
                  f"build/pipegs accuracy {{scene}} --design exact --resume --out accuracy/{scene} "
                  "--json", accuracy, MODEL, scene, points=("exact",)) for scene in ("own", "terrace", "statue")],
    *[Measurement(f"accuracy_rtl/{scene}", f"build/pipegs accuracy {{scene}} --design exact --resume --rtl "
                  f"--out accuracy/{scene} --json", accuracy_rtl, (*RTL, "timing"), scene, points=("exact",))
      for scene in ("own", "terrace", "statue")],
    Measurement("accuracy/own_dop", "build/pipegs accuracy --design dop --knobs alpha_w --points 0 "
                "--out accuracy/own_dop --json", accuracy, MODEL, points=("dop",)),
    *[Measurement(f"fine/{scene}/{name}", f"build/pipegs sim {{scene}} --design exact {options}--json", compared, RTL,
                  scene, points=("exact",)) for scene in FOUR
      for name, options in (("plain", ""), ("fine", "--config sim/fine.cfg "))],
    Measurement("accuracy/leave_one_out", "build/verif/silicon/silicon_test '--gtest_filter=*LeaveOneOut*'",
                leave_one_out, ("rtl", "synth")),
    *[Measurement(f"tradeoff/{scene}", "build/pipegs tradeoff {scene} --json", tradeoff, MODEL, scene, points=("fast",),
                  chart=f"tradeoff/{scene}.svg" if scene in CHARTED else "") for scene in FOUR],
    Measurement("tradeoff/statue_records4096", "build/pipegs tradeoff {scene} --set records=4096 --together 0 --json",
                tradeoff, MODEL, "statue", points=("fast",)),
    *[Measurement(f"effects/{scene}", "build/pipegs effects {scene} --design dop --json", effects, MODEL, scene,
                  points=("dop",)) for scene in ("own", "terrace", "plushdog", "flowers", "statue", "showroom")],
    *[Measurement(f"effects_gain/{scene}_{point}", f"build/pipegs effects {{scene}} --design {point} --measure "
                  "--rounds 2 --json", effects_gain, RTL, scene, points=(point,))
      for scene in ("own", "statue", "plushdog", "terrace") for point in ("dop", "exact")],
    *[Measurement(f"netlist/{scene}_{window.replace(',', '_')}/{kind}", f"build/pipegs sim {{scene}} --design dop "
                  f"--window {window} {option}--no-truth --json", netlist, (*RTL, "synth"), scene, points=("dop",))
      for scene, window in (("own", "8,6"), ("own", "15,11"), ("terrace", "9,6"))
      for kind, option in (("gates", "--netlist "), ("rtl", ""))],
    *[Measurement(f"memories/{name}", f"synth/memories.sh {settings}".rstrip(), list, ("rtl", "models"))
      for name, settings in MEMORIES.items()],
    Measurement("numbers/golden", "build/verif/frame/golden_test --gtest_output=xml:/dev/stdout", golden, ("models",)),
    Measurement("stability/cases", "ctest --test-dir build/. -R ^stability_ -LE long -V", stability, RTL),
    *[Measurement(f"rivals/{scene}", "build/pipegs rivals {scene} --json",
                  rivals_and_parameters if scene == "terrace" else rivals, (*MODEL, "rivals"), scene,
                  points=("dop", "fast"), chart="rivals/terrace.svg" if scene == "terrace" else "")
      for scene in ("own", "terrace", "statue", "flowers", "plushdog")],
    Measurement("rivals/terrace_qhd", "build/pipegs rivals {scene} --scale 2.0712 --json", rivals,
                (*MODEL, "rivals"), "terrace", points=("dop", "fast")),
    *[Measurement(f"trained/plush/{name}", f"build/pipegs train {{scene}} --steps 3000 --layers 8 {options} "
                  f"--out trained/{name} --json", trained, (*MODEL, "train"), "plush", None, ("dop", "fast"))
      for name, options in TRAINED.items()],
    *[Measurement(f"trained/scenes/{scene}",
                  f"build/pipegs train {{scene}} {FINE_TUNED} --out trained/{scene} --json", fine_tuned,
                  (*MODEL, "train"), scene, None, ("dop", "fast"))
      for scene in FOUR],
    *[Measurement(f"viewer/{scene}", f"verif/page/viewer.sh build/pipegs {{scene}} {options}--no-rtl --no-truth",
                  pick("bytes", "ready_ms", "psnr_db"), ("models", "page"), scene, points=("fast",))
      for scene, options in VIEWED.items()],
    Measurement("budget/random", "build/pipegs budget --design dop --count 1000000 --json", budget, ("models",),
                chart="error_budget.svg"),
]
