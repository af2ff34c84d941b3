# SPDX-License-Identifier: Apache-2.0
"""What is measured: for each entry of docs/data the command that gives it, and what decides its figures."""
from itertools import accumulate

from measurement import Measurement
from scenes import SIZES, VIEWS_OF_SIZE
from texts import (
    PRINTING,
    coverage,
    difference,
    golden,
    leave_one_out,
    mutants,
    printed,
    proofs,
    shown,
    stability,
    tests,
)

RTL = ("rtl", "models", "memory")
MODEL = ("models", "timing", "memory", "cost")
PRICED = (*MODEL, "area")  # with areas and energies
POINTS = ("gscore", "baseline", "dpc", "tspp", "dop", "late", "exact", "fast", "wide")


# Tables: as many entries in a line as fit.
# fmt: off
FOUR = ("own", "terrace", "statue", "flowers")
CHARTED = ("own", "terrace")
BUSY = ("own", "flowers")  # the least and the most bytes
STEPPED = ("own", "statue")
BUSES = (0, 256, 128)  # bits of the bus to memory beside the 512 of the default; 0: the core's own port
FRAMES = 30  # of a walk
BUDGETS = {"own": "400k", "terrace": "800k", "showroom": "1500k"}  # cycles of a frame of a walk
LONG_WALKS = ("showroom",)  # half an hour
BUDGETED = 120  # frames of such a walk
PROXIES = (8, 16, 32)  # pixels: pictures of our own scene with proxies that differ by less
PART = "336,208,384,304"  # of that picture
COARSER = {  # of one scene: its own levels of detail, and proxies
    **{f"level_{level}": f"--lod {level}" for level in (0, 1, 2)},
    **{f"proxies_{pixels}": f"--set lod=1 --lod-pixels {pixels}" for pixels in (1, 2, 4, 8)},
}
TOGETHER = 6  # points with less of several things at once
FRONTS = ("own", "terrace", "showroom")  # a small scene, a middle one, a large one
KNOBS = ("coeff_f", "mantissa_w", "exp_linear", "alpha_w", "t_w", "color_w", "rgb_w", "alpha_cut", "t_cut", "depth_w",
         "pos_w", "quat_w", "base_w", "record", "codes", "proxies")
STORES = {  # of the design point dop: its alpha stores
    "lines4096": "--set alpha_lines=4096",
    "paper": "--set alpha_lines=840 --set records=512",  # all memories together as large as the paper's 428 KB
}
ADDED = {  # from exact towards fast: what each step adds to the one before
    "fine_quads": ("the numbers of `sim/fine.cfg`, living quads", "--config sim/fine.cfg --set quads=1"),
    "window128": ("windows of four parts", "--set window=128"),
    "buckets": ("buckets of 1/128 octave", "--set bucket_bits=7"),
    "tests2": ("two tests of regions in a cycle", "--set tests=2"),
    "tight": ("a cull by the ellipse itself", "--set tight_cull=1"),
    "fronts": ("two of the four PUs fetch and cull", "--set fronts=2"),
    "boxes": ("boxes around ellipsoids in the DOPU, groups of 16 chunks", "--set tight_boxes=1 --set group=16"),
    "pace": ("a Gaussian every four cycles", "--set pace=4"),
    "occlusion": ("nothing behind what is opaque", "--set occlusion=1"),
}
SUMS = accumulate((change for _, change in ADDED.values()), "{} {}".format)
STEPS = {name: (what, change) for (name, (what, _)), change in zip(ADDED.items(), SUMS)}
SIX = (*FOUR, "showroom", "campsite")
LEFT_OUT = {  # of fast: what each of its steps towards large scenes gives, by taking it away
    "whole": "--walk-most 0",
    "occlusion": "--set occlusion=0",
    "pace": "--set pace=8",
    "fronts": "--set fronts=1",
    "buckets": "--set bucket_bits=6",
}
GAINED = ("own", "statue", "showroom", "campsite")
# What area and energy these steps cost, and what was tried beside them.
TRADED = ("occlusion=0", "pace=8", "fronts=1", "bucket_bits=6", "nearest_nodes=512", "records=2048", "fronts=4")
TRADED_SETS = " ".join(f"--set {one}" for one in TRADED)
EIGHT = ("own", "terrace", "showroom", "campsite")  # of wide, on eight channels
SCALED = {  # our own scene in parts, and the view: millions of Gaussians, then pixels
    **{f"{millions}m": (f"own_{millions}m", 0) for millions in (1, 4, 16)},
    "4k": ("own_1m", VIEWS_OF_SIZE * SIZES.index("3840x2160")),
}
MEMORIES = {  # settings of the design point
    "dop": "",
    "fast": "fronts=2 window=128 group=16 late=1 order=2 quads=1 pos_w=18 base_w=14 mantissa_w=22 coeff_f=24 "
            "tight_cull=1 tight_boxes=1 occlusion=1 tests=2 pace=4 alpha_w=10 pixel_w=32 records=1408 bucket_bits=7 "
            "nearest_nodes=1024 mark_chunks=7",
}
PAIRED = ("own", "terrace", "flowers", "showroom")  # for two eyes
APART, ASIDE = 0.065, 4  # the way between them; an absurd one
WAYS = {"near": 0, "pair": APART, "wide": ASIDE}
GAZES = {"own": "512,384,128,256", "terrace": "648,420,128,256", "showroom": "666,438,128,256"}  # the middle
HEADSET = ("eyes=2", "aov_coverage=1", "aov_depth=1", "aov_median=1", "aov_index=1")
HEADSET_SETS = " ".join(f"--set {one}" for one in (*HEADSET, ",".join(HEADSET)))
ALONE = "--views 0-0 --design fast"  # one frame as a sequence, which has its joules
BY_BANDWIDTH = ("baseline", "dop", "exact", "fast")
CHANNELS = (1, 2, 8)  # of LPDDR5-6400, 12.8 GB/s each; the default has 4
STABILITY = ("input", "shape", "view", "alpha", "order", "beyond", "wrap", "sanitize", "budget", "stress")
RUNS = {"netlists": "-L netlist", "long": "-L long -LE netlist -E '^(mutation_|prove_all)'"}
TRAINED = {"original": "--order exact --cldr none", "layers": ""}  # the rows of the paper's Table 1
TABLE = [
    # The timing model and the golden model: cycles, bytes, counts, decibels.
    *[Measurement(f"model/{scene}", f"build/pipegs model {{scene}} --designs {','.join(POINTS)} --json", MODEL, scene,
                  points=POINTS) for scene in FOUR],
    *[Measurement(f"work/{scene}_{point}", f"build/pipegs sim {{scene}} --design {point} --no-rtl --json",
                  ("models", "bounds"), scene, points=(point,)) for scene in FOUR for point in ("fast", "dop")],
    *[Measurement(f"bandwidth/{scene}_x{channels}", f"build/pipegs model {{scene}} --designs {','.join(BY_BANDWIDTH)} "
                  f"--memory lpddr5-6400x{channels} --json", MODEL, scene, points=BY_BANDWIDTH)
      for channels in CHANNELS for scene in CHARTED],
    *[Measurement(f"steps/{scene}_{name}", f"build/pipegs model {{scene}} --design exact {change} --json", MODEL, scene,
                  points=("exact",)) for name, (_, change) in STEPS.items() for scene in STEPPED],
    *[Measurement(f"stores/{scene}_{name}", f"build/pipegs model {{scene}} --design dop {change} --json", MODEL, scene,
                  points=("dop",)) for name, change in STORES.items() for scene in CHARTED],
    *[Measurement(f"bus/{scene}_{bits}", f"build/pipegs model {{scene}} --design fast --set bus_w={bits} --json", MODEL,
                  scene, points=("fast",)) for bits in BUSES for scene in BUSY],
    *[Measurement(f"gains/{scene}_{name}", f"build/pipegs model {{scene}} --design fast {change} --json", MODEL, scene,
                  points=("fast",)) for name, change in LEFT_OUT.items() for scene in GAINED],
    *[Measurement(f"wide/{scene}", "build/pipegs model {scene} --design wide --memory lpddr5-6400x8 --json", MODEL,
                  scene, points=("wide",)) for scene in EIGHT],
    *[Measurement(f"walks/{scene}", f"build/pipegs sim {{scene}} --design fast --path {FRAMES} --no-rtl --frames none "
                  f"--out paths/{scene} --json", (*PRICED, "path"), scene, None, ("fast",)) for scene in CHARTED],
    *[Measurement(f"budgets/{scene}_{name}", f"build/pipegs sim {{scene}} --design fast --set lod=1 --path {BUDGETED} "
                  f"{option}--no-rtl --frames none --out paths/{name}_{scene} --json",
                  (*PRICED, "path", *(["runs"] if scene in LONG_WALKS else [])), scene, None, ("fast",))
      for scene, budget in BUDGETS.items() for name, option in (("free", ""), ("held", f"--budget {budget} "))],
    *[Measurement(f"proxies/own_{pixels}", f"build/pipegs sim {{scene}} --set lod=1 --lod-pixels {pixels} "
                  f"--crop {PART} --no-rtl --out build/proxies_{pixels} --json", ("models",), points=("fast",),
                  picture=(f"proxies_{pixels}.png", f"proxies_{pixels}/frame.png")) for pixels in PROXIES],
    *[Measurement(f"levels/flowers_{name}", f"build/pipegs sim {{levels}} {option} --views 0-0 --design fast --no-rtl "
                  "--against {truth} --frames none --out build/levels --json", MODEL, "flowers", None, ("fast",))
      for name, option in COARSER.items()],
    *[Measurement(f"scale/sim_{name}", "build/pipegs sim {scene} --design fast --no-rtl --json", ("models",), scene,
                  view, ("fast",), alone=True) for name, (scene, view) in SCALED.items()],
    *[Measurement(f"scale/model_{name}", "build/pipegs model {scene} --design fast --json", MODEL, scene, view,
                  ("fast",), alone=True) for name, (scene, view) in SCALED.items()],
    *[Measurement(f"profile/{scene}", "build/pipegs study profile {scene} --json", ("models", "cost"), scene,
                  points=("baseline",), chart="profile.svg" if scene == "own" else "") for scene in FOUR],
    *[Measurement(f"effects/{scene}", "build/pipegs effects {scene} --json", (*MODEL, "effects"), scene,
                  points=("fast",)) for scene in ("own", "statue")],
    *[Measurement(f"truth/{scene}", "build/pipegs render {scene} --model truth --semantics inria "
                  f"--compare {{reference}} --out build/figures/truth", ("models",), scene, read=difference,
                  exit_codes=(0, 1)) for scene in ("terrace", "statue", "plushdog")],
    Measurement("what_if/own", "build/pipegs what-if --set units=2 --set bus_w=128 --set alpha_w=8,window=64", PRICED,
                points=("fast",), read=shown),
    *[Measurement(f"prices/{scene}", f"build/pipegs what-if {{scene}} {TRADED_SETS} --json", PRICED,
                  scene, points=("fast",)) for scene in ("own", "showroom")],
    Measurement("prices/headset", f"build/pipegs what-if {HEADSET_SETS} --json", PRICED, points=("fast",)),
    *[Measurement(f"pairs/{scene}_{name}", f"build/pipegs sim {{scene}} {ALONE} --set eyes=2 --stereo {way} --no-rtl "
                  f"--frames none --out build/pairs --json", PRICED, scene, None, ("fast",))
      for scene in PAIRED for name, way in WAYS.items()],
    *[Measurement(f"pairs/{scene}_one", f"build/pipegs sim {{scene}} {ALONE} --no-rtl --frames none --out build/pairs "
                  "--json", PRICED, scene, None, ("fast",)) for scene in PAIRED],
    *[Measurement(f"gaze/{scene}", f"build/pipegs sim {{scene}} --design fast --gaze {gaze} --truth --no-rtl "
                  "--frames none --out build/gaze --json", PRICED, scene, points=("fast",))
      for scene, gaze in GAZES.items()],
    Measurement("shapes/own", "build/pipegs study shapes --design fast --runs 24 --json", PRICED, points=("fast",),
                chart="shapes_own.svg"),
    Measurement("accuracy/own", f"build/pipegs accuracy --design exact --knobs {','.join(KNOBS)} --points 0 "
                "--json", PRICED, points=("exact",)),
    Measurement("accuracy/leave_one_out", "build/verif/silicon/silicon_test '--gtest_filter=*LeaveOneOut*'",
                ("area",), targets=("silicon_test",), read=leave_one_out),
    *[Measurement(f"tradeoff/{scene}", f"build/pipegs study tradeoff {{scene}} --together {TOGETHER} --json", PRICED,
                  scene, points=("fast",)) for scene in FRONTS],
    *[Measurement(f"rivals/{scene}", "build/pipegs study rivals {scene} --json", PRICED, scene,
                  points=("dop", "fast"), chart="rivals/terrace.svg" if scene == "terrace" else "")
      for scene in CHARTED],
    Measurement("budget/random", "build/pipegs study budget --design dop --count 1000000 --json", ("models", "bounds"),
                chart="error_budget.svg"),
    Measurement("viewer/own", "verif/page/viewer.sh build/pipegs {scene} --scale 0.25 --no-rtl --no-truth",
                ("models", "page"), points=("fast",), differs="bytes: of the page"),
    # Tests that print what they measure.
    Measurement("prints/all", f"ctest --test-dir build/. -R '^({'|'.join(PRINTING)})$' -V",
                ("rtl", "models", "units"), targets=tuple(f"{name}_test" for name in PRINTING), read=printed),
    Measurement("prints/golden", "build/verif/frame/golden_test --gtest_output=xml:/dev/stdout", ("models", "frames"),
                targets=("golden_test",), read=golden),
    Measurement("prints/stability", "ctest --test-dir build/. -R ^stability_ -LE long -V", (*RTL, "frames"),
                targets=tuple(f"stability_{name}_test" for name in STABILITY), read=stability),
    # Frames of the RTL, every beat and pixel compared.
    Measurement("rtl/own", "build/pipegs ladder {scene} --json", RTL, points=POINTS, chart="ladder_own.svg"),
    *[Measurement(f"rtl/terrace_{point}", f"build/pipegs sim {{scene}} --design {point} --json", RTL, "terrace",
                  points=(point,)) for point in ("fast", "dop")],
    *[Measurement(f"rtl/{scene}_fast", "build/pipegs sim {scene} --design fast --no-truth --json", RTL, scene,
                  points=("fast",)) for scene in SIX if scene != "terrace"],
    *[Measurement(f"eyes/{scene}", f"build/pipegs sim {{scene}} --design fast --set eyes=2 --stereo {APART} --no-truth "
                  "--out build/eyes --json", RTL, scene, points=("fast",),
                  picture=("own_eyes.png", "eyes/frame.png") if scene == "own" else ()) for scene in PAIRED],
    Measurement("rtl/terrace_wide", "build/pipegs sim {scene} --design wide --memory lpddr5-6400x8 --no-truth --json",
                RTL, "terrace", points=("wide",)),
    Measurement("rtl/own_raster", "build/pipegs sim --design fast --no-truth --picture raster --json", RTL,
                points=("fast",)),
    Measurement("rtl/views", "build/pipegs sim --views 0-2 --json", RTL, view=None, points=("fast",)),
    Measurement("rtl/printed", "build/pipegs sim --out build/out", RTL, points=("fast",), read=shown,
                picture=("own_scene.png", "out/frame.png")),
    # Gates, proofs, training. Minutes on two cores: 5 to 8 for a frame with waves, after `make synth` of its design
    # point (20 to 40 from nothing, less where modules are shared); 1 for memories; 20 to 30 for an FPGA; 20 for the
    # netlist, most of it building; 5 for proofs; 6 for loops; 4, 11 and 10 for training.
    *[Measurement(f"silicon/{scene}_{point}", f"build/pipegs silicon {{scene}} --design {point} --json",
                  (*RTL, "silicon", "synth"), scene, points=(point,)) for point in ("fast", "dop", "exact", "baseline")
      for scene in CHARTED],
    Measurement("silicon/terrace_wide", "build/pipegs silicon {scene} --design wide --memory lpddr5-6400x8 --json",
                (*RTL, "silicon", "synth"), "terrace", points=("wide",)),
    Measurement("silicon/dop_sky130", "build/pipegs silicon --design dop --library sky130hd_tt --no-energy --json",
                ("rtl", "synth"), points=("dop",)),
    *[Measurement(f"memories/{name}", f"synth/memories.sh {settings}".rstrip(), ("rtl", "models"),
                  points=("dop",), targets=("package_sv",))
      for name, settings in MEMORIES.items()],
    *[Measurement(f"fpga/fast_xcup_{units}", "synth/fpga/fpga.py --build build/. --design fast "
                  f"--units {units} --families xcup --json", ("rtl", "fpga"), points=("fast",)) for units in (1, 4)],
    Measurement("netlist/fast_3_3", "build/pipegs sim --design fast --window 3,3 --netlist --no-truth --json",
                (*RTL, "synth", "gates"), points=("fast",)),
    Measurement("proofs/all", "synth/prove.sh", ("rtl", "proofs"), read=proofs),
    Measurement("coverage/fast", "build/verif/top/coverage_test", (*RTL, "coverage"), points=("fast",),
                targets=("coverage_test",), read=coverage),
    # Full runs of what `make test` runs in part: an hour or two each.
    Measurement("runs/mutants", "verif/mutation/mutate.sh", ("rtl", "runs"), read=mutants, exit_codes=(0, 1)),
    *[Measurement(f"runs/{name}", f"ctest --test-dir build/. {which}", ("rtl", "runs"), targets=("all",), read=tests,
                  exit_codes=(0, 8)) for name, which in RUNS.items()],
    Measurement("loops/all", "verif/self/loop.sh", RTL, alone=True),
    *[Measurement(f"trained/plush_{name}", f"build/pipegs train {{scene}} --steps 3000 --layers 8 {options} "
                  f"--out trained/{name} --json", (*MODEL, "layers", "train"), "plush", None, ("dop", "fast"))
      for name, options in TRAINED.items()],
    Measurement("trained/terrace", "build/pipegs train {scene} --around 9 --steps 1500 --layers 4 --downscale 3 "
                "--out trained/terrace --json", (*MODEL, "layers", "train"), "terrace", None, ("dop", "fast")),
]
