#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""machine.py [--design NAME] FOLDER [key=value ...]: another machine for a system: its package and its list of files.

Writes FOLDER/pipegs_pkg.sv and FOLDER/pipegs.f, the list of files with that package and with whole paths. Settings are
those of the design point, then taps=0 (taps are for the harness alone), then those given, entries of
cpp_model/config.def. The driver and its header are the same for every machine.
"""
import argparse
import os
import sys

from files import ROOT, sources

sys.path.insert(0, str(ROOT / "synth"))
import synth  # noqa: E402
from jobs import Failed  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--design", default="fast", help="a design point (sim/design/design_points.def)")
    parser.add_argument("--package-sv", default=str(ROOT / "build/cpp_model/package_sv"), help="what prints packages")
    parser.add_argument("folder")
    parser.add_argument("settings", nargs="*", metavar="key=value")
    options = parser.parse_args()
    settings = [*synth.design_point_settings(options.design), "taps=0", *options.settings]
    try:
        package = synth.package_of(options.package_sv, settings)
    except FileNotFoundError:
        raise Failed(f"{options.package_sv} is missing: cmake --build build --target package_sv")
    folder = os.path.abspath(options.folder)
    os.makedirs(folder, exist_ok=True)
    synth.write(f"{folder}/pipegs_pkg.sv", package)
    rest = [f"{ROOT}/{file}" for file in sources()[1:]]
    synth.write(f"{folder}/pipegs.f", "\n".join([f"{folder}/pipegs_pkg.sv", *rest]) + "\n")


if __name__ == "__main__":
    try:
        main()
    except Failed as failed:
        print(f"machine.py: {failed}", file=sys.stderr)
        sys.exit(2)
