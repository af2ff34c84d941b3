#!/usr/bin/env bash
# lint.sh: each RTL module alone through `verilator --lint-only -Wall` and all of them through Yosys: lint.sh [MODULE ...]
#
# The waivers are those of verif/support/waivers.vlt, each with its reason. Yosys 0.23 reads some constructs without a word
# and gets them wrong (docs/decisions/systemverilog.md): those are searched for here, and its warning "implicitly declared",
# which goes with one of them, is an error. Ends in a count.
set -uo pipefail
cd "$(dirname "$0")/.."
paths=(-y rtl -y rtl/dopu -y rtl/pu -y rtl/su -y rtl/ru -y rtl/buf -y rtl/lib)
files=(); for file in rtl/*.sv rtl/*/*.sv; do [ "$file" = rtl/pipegs_pkg.sv ] || files+=("$file"); done
modules=("$@")
if [ ${#modules[@]} -eq 0 ]; then for file in "${files[@]}"; do modules+=("$(basename "$file" .sv)"); done; fi
failed=0
for module in "${modules[@]}"; do
  if ! log=$(verilator --lint-only -Wall --unroll-count 256 --top-module "$module" verif/support/waivers.vlt rtl/pipegs_pkg.sv \
      "${paths[@]}" "$module" 2>&1); then
    echo "FAIL verilator $module"; head -n 8 <<< "$log"; failed=$((failed + 1))
  fi
done
if ! log=$(yosys -q -e 'implicitly declared' -p "read_verilog -sv -DSYNTHESIS rtl/pipegs_pkg.sv ${files[*]}; hierarchy -check; proc" 2>&1); then
  echo "FAIL yosys"; head -n 8 <<< "$log"; failed=$((failed + 1))
fi
struct_array='pipegs_pkg::[a-z_]+_t +(\[|[a-z_]+ *\[)|function automatic +pipegs_pkg::[a-z_]+_t'
if grep -nE "$struct_array" "${files[@]}"; then
  echo "FAIL arrays of structs, or functions that return structs"; failed=$((failed + 1))
fi
# A minus before a sized cast binds to the size: Yosys drops it from constants without a word. Write W'(0) - W'(x).
if grep -nE "[^] A-Za-z0-9_)'] *-(\([^()]*\)|[A-Za-z0-9_:]+)'\(" "${files[@]}"; then
  echo "FAIL a minus before a sized cast"; failed=$((failed + 1))
fi
echo "${#modules[@]} modules read, $failed failed"
[ "$failed" -eq 0 ]
