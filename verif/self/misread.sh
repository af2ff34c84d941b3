#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# misread.sh: synth/misread.sh finds each construct that Yosys reads wrong without a word in a planted file, and passes
# the same file without it; each find is one line that names file, line and construct. What it does not find, because it
# stands over two lines, `check -assert` of synth/lint.sh does. BUILD: the build folder.
set -uo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
search=$(dirname "$0")/../../synth/misread.sh failed=0
plant() {  # construct, line
  printf 'module planted;\n%s\nendmodule\n' "$2" > "$scratch/planted.sv"
  local found
  if found=$("$search" "$scratch/planted.sv"); then echo "not found: $1"; failed=1; fi
  if [ "$(wc -l <<< "$found")" -ne 1 ] || [[ $found != *planted.sv:2:*"$1"* ]]; then
    echo "unclear: $found"; failed=1
  fi
}
plant "an array of a named type" "  splat_t [3:0] splats;"
plant "elements that are not counted from 0" "  logic [5:0][3:0] low; logic [7:2][W-1:0] x;"
plant "a function that returns a struct" "  function automatic splat_t make(input logic a);"
plant "a constant table built by a function" "  localparam logic [31:0] Table [4] = table_of(3);"
plant "a minus before a sized cast" "  assign y = x + (a ? -W'(5) : 0);"
plant "a shift of a sized cast in a replication" "  assign y = {4'(0), {3{W'(1) << (W - 1)}}, a};"
plant "a parameter of all ones" "  localparam logic [2:0] Last = '1;"
plant "a comparison with a sum that holds a sized cast" "  assign y = a_q == b_q + 3'(c);"
plant "a comparison with a sum that holds a sized cast" "  assign y = b_q + W'(c) != a_q;"
plant "an element of an array in a concatenation on an output port" \
  "  logic [3:0] words [4]; sub u_sub (.out_o({bits[2], words[2]}));"
plant "a number of ten digits without a width" "  localparam logic [KF-1:0] KFull = KF'(3098164009);"
printf '%b' 'module planted;\n  logic [3:0] words [4];\n' \
  '  sub u_sub (.a_i({words[2]}), .b_o({bits[2], one}));\nendmodule\n' > "$scratch/planted.sv"
"$search" "$scratch/planted.sv" || { echo "found where nothing is"; failed=1; }
mkdir "$scratch/tree"
"$(dirname "$0")/misread_tree.sh" "$scratch/tree" || exit 3
if found=$(BUILD=$(realpath "${BUILD:-build}") "$scratch/tree/synth/lint.sh" dopu_nearest); then failed=1; fi
if [[ $found != "FAIL yosys dopu_nearest "*memrd*held_bucket*" 1 failed" ]]; then
  echo "over two lines, linted: $found"; failed=1
fi
exit "$failed"
