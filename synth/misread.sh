#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# misread.sh FILE ...: constructs that are read wrong without a word (docs/decisions.md), all but the last by Yosys 0.23
#
# Arrays of structs, of enums and of other named types lose a dimension, functions that return structs return 0,
# functions that build a table in a constant get it wrong, a parameter of '1 is 1, a sum in a comparison keeps what a
# sized cast in it cuts off, a shifted cast in a replication is not as wide as the cast, a minus before a sized cast
# binds to the size: write W'(0) - W'(x), and an element of an array in a concatenation on an output port is read as a
# memory that nobody writes (over several lines only `check -assert` behind `proc` sees it). A decimal number without a
# width has 32 signed bits: from 2^31 on it is negative, wherever it is widened. A packed member `logic [7:2][W-1:0] x`
# is indexed as if it began at 0, so x[7] lies in the next member.
# Prints each place with what is wrong with it; fails when there is one.
set -uo pipefail
found=0
look() { if grep -nHE "$2" "${@:3}" | sed "s/$/  <- $1/"; then found=1; fi; }
look "an array of a named type" '\b[a-z_0-9]+_[te] +(\[|[a-z_0-9]+ *\[)' "$@"
look "elements that are not counted from 0" 'logic( signed)? \[([^]:]|::)*:[^]0:][^]]*\] *\[' "$@"
look "a function that returns a struct" 'function automatic +(pipegs_pkg::)?[a-z_0-9]+_t' "$@"
look "a constant table built by a function" 'localparam[^=]*\[[^=]*= *[a-z_]+\(' "$@"
look "a minus before a sized cast" "[^] A-Za-z0-9_)'] *-(\([^()]*\)|[A-Za-z0-9_:]+)'\(" "$@"
look "a shift of a sized cast in a replication" "\{[A-Za-z0-9_:]+'\([^{}]*\) *<<[^{}]*\}\}" "$@"
look "a parameter of all ones" "(local)?param(eter)?[^=]*= *'1 *[;,)]" "$@"
look "a comparison with a sum that holds a sized cast" \
  "[=!]= *[]A-Za-z0-9_.:[]+ *[+-] *[A-Za-z0-9_:]+'\(|[+-] *[A-Za-z0-9_:]+'\([^()]*\) *[=!]=" "$@"
look "a number of ten digits without a width" "(^|[^'0-9A-Za-z_.])[0-9_]{10,}" "$@"
for file in "$@"; do
  arrays=$(grep -oE ' [a-z_0-9]+ +\[[^]]*\] *[;,]' "$file" | grep -oE '^ [a-z_0-9]+' | paste -sd '|' | tr -d ' ')
  [ -z "$arrays" ] || look "an element of an array in a concatenation on an output port" \
    "_n?o\(\{([^{}]*[ ,{])?($arrays)\[" "$file"
done
[ "$found" -eq 0 ]
