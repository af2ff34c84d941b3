#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# package.sh [--write] PACKAGE_SV REGISTERS_PRINT: the committed files that programs print are what they print now.
#
# Compares each; with --write, writes it.
set -euo pipefail
cd "$(dirname "$0")/../.."
write=""
if [ "$1" = --write ]; then write=1; shift; fi
package_sv=$1 registers=$2 registers_header=cpp_model/driver/pipegs_registers.h status=0
printed() {  # FILE COMMAND ...
  local text; text=$(mktemp)
  "${@:2}" > "$text"
  if [ -n "$write" ]; then cp "$text" "$1"
  elif ! diff -u "$1" "$text"; then echo "$1 is stale: run make package"; status=1; fi
  rm -f "$text"
}
printed rtl/pipegs_pkg.sv "$package_sv"
printed $registers_header "$registers" header
printed package/pipegs_registers.csv "$registers" csv
printed package/pipegs_registers.rdl "$registers" rdl
for file in pipegs.core Bender.yml; do printed $file python3 -B package/files.py $file; done
for file in pipegs.f vivado.tcl; do printed package/$file python3 -B package/files.py $file; done
# machine.py makes the committed machine of its design point, with all files; it refuses what no machine is made of.
machine=$(mktemp -d); trap 'rm -rf "$machine"' EXIT
of_point() { python3 -B package/machine.py --package-sv "$package_sv" "$@"; }
of_point --design dop "$machine" taps=1 && diff rtl/pipegs_pkg.sv "$machine/pipegs_pkg.sv" &&
  diff <(grep '^rtl/' package/pipegs.f | sed "s|^|$PWD/|; s|^$PWD/rtl/pipegs_pkg.sv|$machine/pipegs_pkg.sv|") \
       "$machine/pipegs.f" || { echo "package/machine.py makes another machine than the committed one"; status=1; }
of_point "$machine" && [ "$(grep -cE ' (Taps += 0|Window += 128|BusW += 512);' "$machine/pipegs_pkg.sv")" = 3 ] ||
  { echo "package/machine.py does not make fast without taps"; status=1; }
if of_point "$machine" bus_w=64 2>/dev/null; then echo "package/machine.py takes a bus of 64 bits"; status=1; fi
# One driver for every machine: no configuration changes its header.
diff "$registers_header" <("$registers" header units=1 antialias=1 world_w=32 late=1 order=2) ||
  { echo "$registers_header depends on the configuration"; status=1; }
exit $status
