#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""elaborate.py BUILD [key=value ...]: the machine of these settings as Yosys elaborates it; prints the folder it is in.

Idea    Elaborating a machine takes a quarter of a minute, and several tests read the same ones. So it is done once for
        each text of the RTL, kept in BUILD/elaborated under the hash of all that it was made from.
Output  In the folder: proc.json, as it stands behind `proc`; merged.json, with constants folded and equal cells merged.
Errors  The last lines of Yosys, exit code 1.
"""
import fcntl
import subprocess
import sys
import zlib
from pathlib import Path

from jobs import Failed, Jobs

ROOT = Path(__file__).resolve().parents[1]


def elaborated(build, settings, top="pipegs_top", root=ROOT, store=None):
    """The folder of this machine, of the RTL of `root`; sys.exit with Yosys' last lines where it fails."""
    build = Path(build).resolve()
    command = [build / "cpp_model/package_sv", *settings]
    package = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout
    files = [path for path in sorted(Path(root).glob("rtl/**/*.sv")) if path.stem != "pipegs_pkg"]
    jobs = Jobs(store or build / "elaborated", 1)

    def make(folder):
        Path(folder, "pipegs_pkg.sv").write_text(package, encoding="utf-8")
        script = f"""read_verilog -sv -defer -DSYNTHESIS {folder}/pipegs_pkg.sv {" ".join(map(str, files))}
            hierarchy -check -top {top}; proc; check -assert; opt_clean; write_json {folder}/proc.json
            opt_expr; opt_merge; opt_clean; write_json {folder}/merged.json"""
        jobs.run(["yosys", "-q", "-e", "implicitly declared", "-p", script], f"{folder}/log")

    made_from = [Path(__file__).read_text(encoding="utf-8"), top, package]
    made_from += [path.read_text(encoding="utf-8") for path in files]
    # Two tests may want the same one at once.
    with open(Path(jobs.cache, f"{top}.{zlib.crc32(package.encode())}.lock"), "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        try:
            return Path(jobs.result(top, made_from, make))
        except Failed:
            log = next(Path(jobs.cache).glob(f"{top}.*.failed/log")).read_text(encoding="utf-8")
            sys.exit(f"yosys {top} {' '.join(settings)}\n" + "\n".join(log.splitlines()[-8:]))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit("elaborate.py BUILD [key=value ...]")
    print(elaborated(sys.argv[1], sys.argv[2:]))
