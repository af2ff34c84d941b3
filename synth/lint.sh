#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# lint.sh [--rest | MODULE ...]: each RTL module alone through `verilator --lint-only -Wall`, machines through Yosys
#
# --rest: only what the tests in $BUILD do not read as strictly: modules that none of them has Verilated (which is done
# with -Wall), and machines that none of them elaborates.
# Some modules exist in some machines only: they are read with the package of such a machine, printed by
# $BUILD/cpp_model/package_sv. So is the whole machine of each design point, and one without any effect that can be
# absent, for Yosys as pipegs_axi, for Verilator as it is simulated, sim/rtl/pipegs_sim.sv. The waivers are those of
# sim/rtl/waivers.vlt, each with its reason. Yosys 0.23 reads some constructs without a word and gets them wrong
# (docs/decisions/systemverilog.md): misread.sh searches for those, and its warning "implicitly declared", which goes
# with one of them, is an error. Ends in a count.
set -uo pipefail
cd "$(dirname "$0")/.." || exit
mapfile -t paths < <(find rtl sim/rtl -type d | sort | sed 's/^/-y\n/')
mapfile -t files < <(find rtl -name '*.sv' ! -name pipegs_pkg.sv | sort)
modules=("$@")
build=${BUILD:-build} failed=0 scratch=$(mktemp -d) rest=
if [ "${modules[*]:-}" = --rest ]; then rest=1 modules=(); fi
if [ ${#modules[@]} -eq 0 ]; then
  for file in "${files[@]}"; do
    module=$(basename "$file" .sv)
    if [ -n "$rest" ] && compgen -G "$build/verilated/*/V${module}__ver.d" > /dev/null; then continue; fi
    modules+=("$module")
  done
fi
trap 'rm -rf "$scratch"' EXIT
design_point() {  # its settings, from the table
  sed -nE "/^PIPEGS_POINT\($1,/,/^PIPEGS_END/s/^PIPEGS_(SETTING|PICTURE)\(([a-z_]+), ([0-9]+)\).*/\2=\3/p" \
    sim/design/design_points.def | paste -sd ' '
}
# The machines, as settings; of the first ones verif/cli/static_cost_test.cpp elaborates what --rest leaves out.
machines=("" "$(design_point fast)")
[ -z "$rest" ] || machines=()
machines+=("antialias=1" "tight_cull=1" "late=1" "order=1" "late=1 order=1" "late=1 order=1 quadratic=1"
  "late=1 order=2" "late=1 order=2 quads=1" "bus_w=128"
  "sh_degree=0 near_test=0 guard_band=0 saturation=0 early_stop=0 layered=0 index_ties=0 overflow=0 large_groups=0 \
taps=0")
simulated=("" "bus_w=0")
[ -n "$rest" ] || simulated+=("${machines[@]:1}")
declare -A machine_of=([pu_compensate]="antialias=1" [pu_late]="late=1" [ru_rows]="late=1"
  [pu_power]="late=1 quadratic=1" [pu_expand]="late=1 order=1" [pu_list]="late=1 order=1" [pu_record]="late=1 order=1"
  [pu_lines]="order=1" [pu_fill]="order=1" [pu_marks]="late=1 order=2"
  [lists]="late=1 order=1" [list_write]="late=1 order=1" [list_read]="late=1 order=1"
  [dopu_depth]="late=1 order=2" [dopu_bucket]="late=1 order=2" [dopu_rank]="late=1 order=2" [dopu_open]="late=1 order=2"
  [ru_live]="late=1 order=2 quads=1" [ru_regions]="late=1 order=2 quads=1" [ru_power]="late=1 order=2 quads=1"
  [ru_quads]="late=1 order=2 quads=1" [pu_parts]="late=1 order=2 quads=1 window=128"
  [pu_reach]="tight_cull=1"
  [dopu_send]="late=1 order=2" [dopu_nearest]="late=1 order=2")
package() {  # the path of the package with these settings
  local folder=$scratch/${1// /,}
  if [ -z "$1" ]; then echo rtl/pipegs_pkg.sv; return; fi
  mkdir -p "$folder"
  # shellcheck disable=SC2086
  [ -e "$folder/pipegs_pkg.sv" ] || "$build/cpp_model/package_sv" $1 > "$folder/pipegs_pkg.sv"
  echo "$folder/pipegs_pkg.sv"
}
lint() {  # one module with these settings
  local log
  if ! log=$(verilator --lint-only -Wall --unroll-count 256 --top-module "$1" sim/rtl/waivers.vlt "$(package "$2")" \
      "${paths[@]}" "$1" 2>&1); then
    echo "FAIL verilator $1 $2"; head -n 8 <<< "$log"; failed=$((failed + 1))
  fi
}
for module in "${modules[@]}"; do lint "$module" "${machine_of[$module]:-}"; done
for machine in "${simulated[@]}"; do lint pipegs_sim "$machine"; done
for machine in "${machines[@]}"; do
  if ! log=$(yosys -q -e 'implicitly declared' \
      -p "read_verilog -sv -defer -DSYNTHESIS $(package "$machine") ${files[*]}
          hierarchy -check -top pipegs_axi; proc" 2>&1); then
    echo "FAIL yosys $machine"; grep -v '^Warning' <<< "$log" | head -n 8; failed=$((failed + 1))
  fi
done
if ! synth/misread.sh "${files[@]}"; then echo "FAIL read wrong by Yosys"; failed=$((failed + 1)); fi
echo "${#modules[@]} modules read, $failed failed"
[ "$failed" -eq 0 ]
