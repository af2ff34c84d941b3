#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# memories.sh: every SRAM of the machine in one configuration, as JSON: memories.sh [key=value ...]
#
# Yosys elaborates pipegs_top with rtl/lib/pipegs_sram.sv as a black box and lists each instance with its parameters.
# Instances of the same place in units of one kind are one row: {"place", "width", "depth", "ports", "count"}. $BUILD is
# the build folder.
set -euo pipefail
cd "$(dirname "$0")/.."
build=${BUILD:-build}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$build/cpp_model/package_sv" "$@" > "$work/pipegs_pkg.sv"
files=$(find rtl -name '*.sv' ! -name pipegs_pkg.sv ! -name pipegs_sram.sv | sort | tr '\n' ' ')
yosys -q -p "read_verilog -sv -lib rtl/lib/pipegs_sram.sv
  read_verilog -sv -defer -DSYNTHESIS $work/pipegs_pkg.sv $files
  hierarchy -top pipegs_top; proc; check -assert; flatten
  tee -q -o $work/srams.txt dump t:pipegs_sram" > "$work/log" 2>&1 ||
  { tail -n 5 "$work/log" >&2; exit 3; }
awk '/^ *cell .pipegs_sram/ {place = $3; sub(/^\\/, "", place); gsub(/\[[0-9]+\]/, "", place); ports = 2}
  /parameter.*Depth/ {depth = $NF} /parameter.*DataW/ {width = $NF} /parameter.*Ports/ {ports = $NF}
  /connect .clk_i/ {count[place " " width " " depth " " ports]++}
  END {for (key in count) print key, count[key]}' "$work/srams.txt" | sort | awk 'BEGIN {printf "["}
  {printf "%s\n {\"place\": \"%s\", \"width\": %d, \"depth\": %d, \"ports\": %d, \"count\": %d}",
    (NR > 1 ? "," : ""), $1, $2, $3, $4, $5}
  END {print "\n]"}'
