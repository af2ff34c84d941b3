#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""machine.py [NAME] [FILE] [key=value ...] --out DIR: everything about a machine that a system on a chip takes.

A machine is a design point (sim/design/design_points.def; `fast` unless another is named), then the settings of FILE, a
key=value in each line, then those given, entries of cpp_model/config.def. Taps are left out: they are for the harness.
A design point as it is needs Python alone; settings need the programs of a build (`--build`), which know what follows.
Writes pipegs_pkg.sv; pipegs.f, pipegs.core (FuseSoC) and Bender.yml, lists of just the files that this machine uses, by
whole paths; pipegs_registers.csv, .rdl (SystemRDL) and pipegs.xml (IP-XACT); pipegs_axi_instance.svh, signals for every
port with width and meaning and the instance that they go to. The C driver is the same for every machine.
"""
import argparse
import os
import sys

import files
import machines
from files import ROOT, Failed, design_points
from ipxact import component
from ports import template
from registers import rdl


def settings_of(words):
    """The design point that is named, and what is changed in it."""
    name, settings = machines.DEFAULT, []
    for word in words:
        if word in design_points():
            name = word
        elif "=" in word:
            settings.append(word)
        elif os.path.isfile(word):
            with open(word, encoding="utf-8") as file:
                lines = [line.split("#")[0].replace(" ", "").strip() for line in file]
            settings += [line for line in lines if line]
        else:
            raise Failed(f"'{word}' is no file, no key=value and no design point: {', '.join(design_points())}")
    return name, settings


def texts_of(printed, package, root):
    """{file: text} of the machine of a package, whose text lies at `package`; `root` stands before paths of rtl/."""
    text, table = printed["pipegs_pkg.sv"], printed["pipegs_registers.csv"]
    sources = [package, *[root / file for file in files.sources(text)]]
    return printed | {
        "pipegs.f": files.filelist(sources),
        "pipegs.core": files.fusesoc(sources),
        "Bender.yml": files.bender(sources),
        "pipegs_registers.rdl": rdl(table),
        "pipegs.xml": component(text, table, sources),
        "pipegs_axi_instance.svh": template(text),
    }


def main():
    parser = argparse.ArgumentParser(
        description=__doc__.split("\n", maxsplit=1)[0],
        epilog=__doc__.split("\n\n", maxsplit=1)[1],
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("machine", nargs="*", help="a design point, a file of settings, key=value; in any order")
    parser.add_argument("--out", required=True, metavar="DIR")
    parser.add_argument("--build", default=ROOT / "build", metavar="DIR", help="build folder whose programs are asked")
    options = parser.parse_args()
    name, settings = settings_of(options.machine)
    if settings:
        printed = machines.printed(options.build, [*design_points()[name], "taps=0", *settings])
    else:
        printed = machines.named(name)
    folder = os.path.abspath(options.out)
    texts = texts_of(printed, f"{folder}/pipegs_pkg.sv", ROOT)
    os.makedirs(folder, exist_ok=True)
    for file, text in texts.items():
        with open(f"{folder}/{file}", "w", encoding="utf-8") as out:
            out.write(text)


if __name__ == "__main__":
    try:
        main()
    except (Failed, OSError) as failed:
        print(f"machine.py: {failed}", file=sys.stderr)
        sys.exit(2)
