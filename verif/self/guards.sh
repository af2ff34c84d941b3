#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# guards.sh: parameters that a module cannot have are refused in words when it is elaborated, by Yosys and by Verilator
#
# Each line: a module, a parameter with a value just beyond what is allowed, one just within, and what must be said of
# the first alone. The module is read without those below it: what it says comes before anybody misses them.
set -uo pipefail
cd "$(dirname "$0")/../.." || exit
failed=0
said_by() {  # TOOL MODULE NAME=VALUE
  local file; file=$(find rtl -name "$2.sv")
  if [ "$1" = yosys ]; then
    yosys -q -p "read_verilog -sv -defer -DSYNTHESIS rtl/pipegs_pkg.sv $file
      hierarchy -check -top $2 -chparam ${3/=/ }" 2>&1
  else
    verilator --lint-only "-G$3" --top-module "$2" rtl/pipegs_pkg.sv "$file" 2>&1
  fi
}
guard() {  # MODULE NAME=BEYOND NAME=WITHIN SENTENCE
  local tool said
  for tool in yosys verilator; do
    if said=$(said_by "$tool" "$1" "$2") || ! grep -qF "$1: $4" <<< "$said"; then
      echo "$tool does not refuse $1 with $2: ${said%%$'\n'*}"; failed=1
    fi
    if grep -qF "$1: " <<< "$(said_by "$tool" "$1" "$3" | grep -E 'USERERROR|ERROR: pipegs')"; then
      echo "$tool refuses $1 with $3"; failed=1
    fi
  done
}
guard pipegs_axi AddrW=39 AddrW=40 "AddrW is below 40"
guard pipegs_axi Base=4032 Base=4096 "Base is not a multiple of 4096"
guard pipegs_line_reader Lines=24 Lines=32 "Lines is not a power of two"
guard pipegs_line_reader Lines=4 Lines=8 "Lines is not a power of two"
guard pipegs_line_reader ItemsPerLine=3 ItemsPerLine=2 "ItemsPerLine is none of 1, 2, 4"
guard pipegs_control_restart Cycles=3 Cycles=4 "Cycles is below 4"
exit "$failed"
