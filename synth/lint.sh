#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# lint.sh [--rest]: each RTL module alone through `verilator --lint-only -Wall`, machines through Yosys
# lint.sh MODULE ...: these modules alone, through both
# lint.sh --corners N [--seed S]: N machines that nobody chose, of the seeds S, S + 1, ..., through both
#
# --rest: only what the tests in $BUILD do not read as strictly: modules that none of them has Verilated (which is done
# with -Wall), and a third of the machines that none of them elaborates, another one each day.
# Some modules exist in some machines only: they are read with the package of such a machine, printed by
# $BUILD/cpp_model/package_sv. So is the whole machine of each design point, and one without any effect that can be
# absent, for Yosys as pipegs_axi, for Verilator as it is simulated, sim/rtl/pipegs_sim.sv. The waivers are those of
# sim/rtl/waivers.vlt, each with its reason. Yosys 0.23 reads some constructs without a word and gets them wrong
# (docs/decisions.md): misread.sh searches for those, and its warning "implicitly declared", which goes
# with one of them, is an error; declared.py names what is used before its declaration, which only conforming tools
# refuse. Ends in a count.
# --corners: random legal configurations (cpp_model/lib/corners.hpp), before them those that were once broken; each as
# the whole machine. One that fails is printed with the command that repeats it.
set -uo pipefail
cd "$(dirname "$0")/.." || exit
mapfile -t paths < <(find rtl sim/rtl -type d | sort | sed 's/^/-y\n/')
mapfile -t files < <(find rtl -name '*.sv' ! -name pipegs_pkg.sv | sort)
modules=() build=${BUILD:-build} failed=0 rest='' corners='' seed=1
while [ $# -gt 0 ]; do
  case $1 in
    --rest) rest=1 ;;
    --corners) shift; corners=${1:-none} ;;
    --seed) shift; seed=${1:-none} ;;
    *) modules+=("$1") ;;
  esac
  shift
done
if ! [[ ${corners:-1}$seed =~ ^[0-9]+$ ]]; then echo "lint.sh: --corners N --seed S, expected numbers" >&2; exit 2; fi
named=${modules[0]:-}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
if [ ${#modules[@]} -eq 0 ] && [ -z "$corners" ]; then
  for file in "${files[@]}"; do
    module=$(basename "$file" .sv)
    if [ -n "$rest" ] && compgen -G "$build/verilated/*/V${module}__ver.d" > /dev/null; then continue; fi
    modules+=("$module")
  done
fi
declare -A point  # settings of each design point
while read -r name settings; do point[$name]=$settings; done < <(synth/design_points.py)
# Machines beside the design points, as settings, for what none of those has: pu_compensate, codes and stages of four
# cycles; a second cull or living quads in windows of one part; a narrow bus and clocks that never stop; nothing that
# can be left out.
others=("antialias=1 pace=4 record=48 bus_w=128 clock_gates=0" "tight_cull=1" "late=1 order=2 quads=1 lod=1"
  "sh_degree=0 near_test=0 guard_band=0 saturation=0 early_stop=0 layered=0 index_ties=0 overflow=0 large_groups=0 \
taps=0")
elaborated=() simulated=("bus_w=0")
# verif/cli/static_cost_test.cpp elaborates dop and fast, and machines like the last two with two units;
# verif/self/streams/ready.py tspp and dpc.
elsewhere=("${point[dop]}" "${point[fast]}" "${point[tspp]}" "${point[dpc]}" "tight_cull=1"
           "late=1 order=2 quads=1 lod=1")
for machine in "${point[@]}" "${others[@]}"; do
  for other in "${elsewhere[@]}"; do [[ -z $rest || $machine != "$other" ]] || continue 2; done
  elaborated+=("$machine")
done
if [ -n "$rest" ]; then
  simulated+=("${point[dop]}")
  for i in "${!elaborated[@]}"; do (((i + $(date +%s) / 86400) % 3 == 0)) || unset "elaborated[$i]"; done
else
  simulated+=("${point[@]}" "${others[@]}")
fi
# Modules that the default configuration has not: a machine that has them.
declare -A machine_of=([pu_compensate]="antialias=1" [pu_decode]="record=48" [pu_color_codes]="record=48"
  [dopu_lod]="late=1 order=2 lod=1" [pu_eyes]="late=1 order=2 window=128 quads=1 pixel_w=32 eyes=2")
for module in project orient jacobian factors squares covariance conic extent coeff; do
  machine_of[pu_four_$module]="pace=4"
done
for module in ru_aovs ru_aov_lines ru_linear; do
  machine_of[$module]="late=1 order=2 quads=1 pixel_w=32 aov_coverage=1 aov_depth=1 aov_median=1 aov_index=1"
done
of() { local module; for module in "${@:2}"; do machine_of[$module]=${point[$1]}; done; }
of late pu_late ru_rows
of baseline pu_power
of dpc pu_expand pu_list pu_record pipegs_lists pipegs_list_write pipegs_list_read
of tspp pu_lines pu_fill
of exact pu_marks dopu_depth dopu_bucket dopu_rank dopu_open dopu_send dopu_nearest
of fast dopu_load ru_live ru_regions ru_power ru_quads pu_parts pu_reach
of gscore pu_axes pu_box pu_touch
package() {  # the path of the package with these settings
  local folder; folder=$scratch/$(cksum <<< "$1" | tr ' ' _)
  mkdir -p "$folder"
  # shellcheck disable=SC2086
  [ -e "$folder/pipegs_pkg.sv" ] || "$build/cpp_model/package_sv" $1 > "$folder/pipegs_pkg.sv"
  echo "$folder/pipegs_pkg.sv"
}
fail() {  # what the tool and what it read; its first lines
  echo "FAIL $1"; grep -v '^Warning' <<< "$2" | head -n 8; failed=$((failed + 1))
}
lint() {  # MODULES, SETTINGS: these modules with these settings
  local log
  # shellcheck disable=SC2086
  log=$(verilator --lint-only -Wall -Wno-MULTITOP --unroll-count 256 sim/rtl/waivers.vlt "$(package "$2")" \
    "${paths[@]}" $1 2>&1) || fail "verilator $1 $2" "$log"
}
elaborate() {  # MODULES, SETTINGS: each of them as the top of a design
  local log top script
  script="read_verilog -sv -defer -DSYNTHESIS $(package "$2") ${files[*]}; design -save all"
  for top in $1; do script+="; design -load all; hierarchy -check -top $top; proc; check -assert"; done
  log=$(yosys -q -e 'implicitly declared' -p "$script" 2>&1) || fail "yosys $1 $2" "$log"
}
top_of() { if [[ " $1 " == *" bus_w=0 "* ]]; then echo pipegs_host; else echo pipegs_axi; fi; }
if [ -n "$corners" ]; then
  broken=("index_ties=0 depth_w=12 bucket_bits=6 world_w=44 scale_m_w=14" "mean_f=11 order=1")
  for ((i = 0; i < ${#broken[@]} + corners; i += 1)); do
    before=$failed replay=''
    if [ "$i" -lt ${#broken[@]} ]; then
      machine=${broken[i]}
    else
      number=$((seed + i - ${#broken[@]})) replay="synth/lint.sh --corners 1 --seed $number"
      if ! machine=$("$build/cpp_model/package_sv" --corner $number); then fail "corner $number" ""; continue; fi
    fi
    lint pipegs_sim "$machine"
    elaborate "$(top_of "$machine")" "$machine"
    [ "$failed" -eq "$before" ] || [ -z "$replay" ] || echo "replay: $replay"
  done
  echo "$corners corners from seed $seed on and ${#broken[@]} others read, $failed failed"
  [ "$failed" -eq 0 ]
  exit
fi
for module in "${modules[@]}"; do lint "$module" "${machine_of[$module]:-}"; done
if [ -n "$named" ]; then  # no machine
  simulated=() elaborated=()
  for module in "${modules[@]}"; do elaborate "$module" "${machine_of[$module]:-}"; done
fi
for machine in "${simulated[@]}"; do lint pipegs_sim "$machine"; done
for machine in "${elaborated[@]}"; do
  elaborate "$(top_of "$machine")" "$machine"
done
if ! synth/misread.sh "${files[@]}"; then echo "FAIL read wrong by Yosys"; failed=$((failed + 1)); fi
mapfile -t all < <(find rtl sim/rtl synth/prove verif -name '*.sv' -o -name '*.svh' | sort)
if ! synth/declared.py "${all[@]}"; then echo "FAIL used before the declaration"; failed=$((failed + 1)); fi
echo "${#modules[@]} modules read, $failed failed"
[ "$failed" -eq 0 ]
