#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# lint.sh [MODULE ...]: each RTL module alone through `verilator --lint-only -Wall`, every machine through Yosys
#
# Some modules exist in some machines only: they are read with the package of such a machine, printed by
# $BUILD/cpp_model/package_sv. So is the whole machine of each design point, and one without any effect that can be
# absent. The waivers are those of sim/rtl/waivers.vlt, each with its reason. Yosys 0.23 reads some constructs without a
# word and gets them wrong (docs/decisions/systemverilog.md): misread.sh searches for those, and its warning "implicitly
# declared", which goes with one of them, is an error. Ends in a count.
set -uo pipefail
cd "$(dirname "$0")/.." || exit
mapfile -t paths < <(find rtl -type d | sort | sed 's/^/-y\n/')
mapfile -t files < <(find rtl -name '*.sv' ! -name pipegs_pkg.sv | sort)
modules=("$@")
if [ ${#modules[@]} -eq 0 ]; then for file in "${files[@]}"; do modules+=("$(basename "$file" .sv)"); done; fi
build=${BUILD:-build} failed=0 scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
# The machines, as settings.
machines=("" "antialias=1" "late=1" "order=1" "late=1 order=1" "late=1 order=1 quadratic=1" "late=1 order=2"
  "late=1 order=2 quads=1"
  "sh_degree=0 near_test=0 guard_band=0 saturation=0 early_stop=0 layered=0 index_ties=0 overflow=0 large_groups=0 \
taps=0")
declare -A machine_of=([pu_compensate]="antialias=1" [pu_late]="late=1" [ru_rows]="late=1"
  [pu_power]="late=1 quadratic=1" [pu_expand]="late=1 order=1" [pu_list]="late=1 order=1" [pu_record]="late=1 order=1"
  [pu_lines]="order=1" [pu_fill]="order=1" [pu_marks]="late=1 order=2"
  [lists]="late=1 order=1" [list_write]="late=1 order=1" [list_read]="late=1 order=1"
  [dopu_depth]="late=1 order=2" [dopu_bucket]="late=1 order=2" [dopu_rank]="late=1 order=2" [dopu_open]="late=1 order=2"
  [ru_live]="late=1 order=2 quads=1" [ru_regions]="late=1 order=2 quads=1" [ru_power]="late=1 order=2 quads=1"
  [ru_quads]="late=1 order=2 quads=1"
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
  if ! log=$(verilator --lint-only -Wall --unroll-count 256 --top-module "$module" sim/rtl/waivers.vlt \
      "$(package "${machine_of[$module]:-}")" "${paths[@]}" "$module" 2>&1); then
    echo "FAIL verilator $module"; head -n 8 <<< "$log"; failed=$((failed + 1))
  fi
done
for machine in "${machines[@]}"; do
  if [ -n "$machine" ] && ! log=$(verilator --lint-only -Wall --unroll-count 256 --top-module pipegs_top \
      sim/rtl/waivers.vlt "$(package "$machine")" "${paths[@]}" pipegs_top 2>&1); then
    echo "FAIL verilator pipegs_top $machine"; head -n 8 <<< "$log"; failed=$((failed + 1))
  fi
  if ! log=$(yosys -q -e 'implicitly declared' \
      -p "read_verilog -sv -defer -DSYNTHESIS $(package "$machine") ${files[*]}
          hierarchy -check -top pipegs_top; proc" 2>&1); then
    echo "FAIL yosys $machine"; grep -v '^Warning' <<< "$log" | head -n 8; failed=$((failed + 1))
  fi
done
if ! synth/misread.sh "${files[@]}"; then echo "FAIL read wrong by Yosys"; failed=$((failed + 1)); fi
echo "${#modules[@]} modules read, $failed failed"
[ "$failed" -eq 0 ]
