#!/usr/bin/env bash
# lint.sh: each RTL module alone through `verilator --lint-only -Wall` and every machine through Yosys: lint.sh [MODULE ...]
#
# Some modules exist on some rungs of the ladder only: they are read with a package of that rung, printed by
# $BUILD/cpp_model/package_sv, and so is the whole machine of each rung, and one without any effect that can be left out.
# The waivers are those of verif/support/waivers.vlt, each with its reason. Yosys 0.23 reads some constructs without a word
# and gets them wrong (docs/decisions/systemverilog.md): misread.sh searches for those, and its warning "implicitly declared",
# which goes with one of them, is an error. Ends in a count.
set -uo pipefail
cd "$(dirname "$0")/.."
paths=(-y rtl -y rtl/dopu -y rtl/pu -y rtl/su -y rtl/ru -y rtl/list -y rtl/buf -y rtl/lib)
files=(); for file in rtl/*.sv rtl/*/*.sv; do [ "$file" = rtl/pipegs_pkg.sv ] || files+=("$file"); done
modules=("$@")
if [ ${#modules[@]} -eq 0 ]; then for file in "${files[@]}"; do modules+=("$(basename "$file" .sv)"); done; fi
build=${BUILD:-build} failed=0 scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
rungs=("" "antialias=1" "late=1" "order=1" "late=1 order=1" "late=1 order=1 quadratic=1" "late=1 order=2"
  "sh_degree=0 near_test=0 guard_band=0 saturation=0 early_stop=0 layered=0 index_ties=0 overflow=0 large_groups=0 taps=0")  # the machines, as settings
declare -A rung_of=([pu_compensate]="antialias=1" [pu_late]="late=1" [ru_rows]="late=1" [pu_power]="late=1 quadratic=1"
  [pu_expand]="late=1 order=1" [pu_list]="late=1 order=1" [pu_lines]="order=1"
  [lists]="late=1 order=1" [list_write]="late=1 order=1" [list_read]="late=1 order=1"
  [dopu_depth]="late=1 order=2" [dopu_bucket]="late=1 order=2" [dopu_rank]="late=1 order=2" [dopu_open]="late=1 order=2"
  [dopu_send]="late=1 order=2" [dopu_nearest]="late=1 order=2")
package() {  # the path of the package with these settings
  local folder=$scratch/${1// /,}
  if [ -z "$1" ]; then echo rtl/pipegs_pkg.sv; return; fi
  mkdir -p "$folder"
  # shellcheck disable=SC2086
  [ -e "$folder/pipegs_pkg.sv" ] || "$build/cpp_model/package_sv" $1 > "$folder/pipegs_pkg.sv"
  echo "$folder/pipegs_pkg.sv"
}
for module in "${modules[@]}"; do
  if ! log=$(verilator --lint-only -Wall --unroll-count 256 --top-module "$module" verif/support/waivers.vlt "$(package "${rung_of[$module]:-}")" \
      "${paths[@]}" "$module" 2>&1); then
    echo "FAIL verilator $module"; head -n 8 <<< "$log"; failed=$((failed + 1))
  fi
done
for rung in "${rungs[@]}"; do
  if [ -n "$rung" ] && ! log=$(verilator --lint-only -Wall --unroll-count 256 --top-module pipegs_top verif/support/waivers.vlt \
      "$(package "$rung")" "${paths[@]}" pipegs_top 2>&1); then
    echo "FAIL verilator pipegs_top $rung"; head -n 8 <<< "$log"; failed=$((failed + 1))
  fi
  if ! log=$(yosys -q -e 'implicitly declared' \
      -p "read_verilog -sv -defer -DSYNTHESIS $(package "$rung") ${files[*]}; hierarchy -check -top pipegs_top; proc" 2>&1); then
    echo "FAIL yosys $rung"; grep -v '^Warning' <<< "$log" | head -n 8; failed=$((failed + 1))
  fi
done
if ! synth/misread.sh "${files[@]}"; then echo "FAIL read wrong by Yosys"; failed=$((failed + 1)); fi
echo "${#modules[@]} modules read, $failed failed"
[ "$failed" -eq 0 ]
