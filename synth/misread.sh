#!/usr/bin/env bash
# misread.sh: constructs that Yosys 0.23 reads wrong without a word (docs/decisions/systemverilog.md): misread.sh FILE ...
#
# Arrays of structs lose a dimension, functions that return structs return 0, and a minus before a sized cast binds to the
# size: write W'(0) - W'(x). Prints each place with what is wrong with it; fails when there is one.
set -uo pipefail
found=0
look() { if grep -nHE "$2" "${@:3}" | sed "s/$/  <- $1/"; then found=1; fi; }
look "an array of structs" 'pipegs_pkg::[a-z_]+_t +(\[|[a-z_]+ *\[)' "$@"
look "a function that returns a struct" 'function automatic +pipegs_pkg::[a-z_]+_t' "$@"
look "a minus before a sized cast" "[^] A-Za-z0-9_)'] *-(\([^()]*\)|[A-Za-z0-9_:]+)'\(" "$@"
[ "$found" -eq 0 ]
