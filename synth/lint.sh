#!/usr/bin/env bash
# lint.sh: each RTL module alone through `verilator --lint-only -Wall` and through Yosys: lint.sh [MODULE ...]
#
# The waivers are those of verif/support/waivers.vlt, each with its reason. Yosys 0.23 is silently wrong on some
# constructs; its warning "implicitly declared" and the constructs that it drops are errors here. Ends in a count.
set -uo pipefail
cd "$(dirname "$0")/.."
folders=(rtl rtl/dopu rtl/pu rtl/su rtl/ru rtl/buf rtl/lib)
paths=(); for folder in "${folders[@]}"; do paths+=(-y "$folder"); done
modules=("$@")
if [ ${#modules[@]} -eq 0 ]; then for file in rtl/*.sv rtl/*/*.sv; do modules+=("$(basename "$file" .sv)"); done; fi
files=$(ls rtl/pipegs_pkg.sv; ls rtl/*.sv rtl/*/*.sv | grep -v pipegs_pkg)
check() {
  local module=$1 log
  [ "$module" = pipegs_pkg ] && return 0
  log=$(verilator --lint-only -Wall --unroll-count 256 --top-module "$module" verif/support/waivers.vlt rtl/pipegs_pkg.sv "${paths[@]}" "$module" 2>&1) ||
    { echo "FAIL verilator $module"; echo "$log" | head -n 8; return 1; }
  log=$(yosys -q -e 'implicitly declared' -p "read_verilog -sv -DSYNTHESIS $files; hierarchy -check -top $module; proc" 2>&1) ||
    { echo "FAIL yosys $module"; echo "$log" | head -n 8; return 1; }
}
failed=0
# Constructs that Yosys 0.23 reads without a word and gets wrong (docs/conventions.md).
if grep -nE '_t *(\[[^]]*\]) *[a-z_]+ *[;,)=]|_t +[a-z_]+ *\[[^]]*\] *;|function automatic +pipegs_pkg::[a-z_]+_t' rtl/*.sv rtl/*/*.sv; then
  echo "FAIL arrays of structs or functions that return structs"; failed=1
fi
export -f check; export files; export paths_text="${paths[*]}"
for module in "${modules[@]}"; do check "$module" || failed=$((failed + 1)); done
echo "${#modules[@]} modules read, $failed failed"
[ "$failed" -eq 0 ]
