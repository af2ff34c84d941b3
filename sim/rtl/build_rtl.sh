#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# build_rtl.sh: the machine in one configuration as OUT_DIR/librtl.so:
#   build_rtl.sh BUILD_DIR OUT_DIR [+waves] [+noasserts] [+dopu] [+pu] [+su] [+ru] [+apart] [+verilator=OPTION,...]
#                [+cxx=OPTION,...] [+fresh] [key=value ...]
#
# PUs, SUs and RUs are classes of their own, whose code all units of a kind call: Verilator merges their functions where
# it sees that they are equal (units.vlt), the linker where only the compiler could. With +apart, and wherever waves
# or gates are asked for, every unit has code of its own, as Verilator's -O3 alone makes it: four times as much,
# which no processor's caches hold. +verilator and +cxx add options, to measure what they gain.
# With +dopu, +pu, +su, +ru these units are the gates that synth/synth.py maps them to, each unit Verilated once as a
# library of its own; the rest is RTL. What begins with + says how the machine is simulated (RtlVariant), the rest which
# machine it is.
# BUILD_DIR is the CMake build folder (its package_sv and static libraries are used). Nothing is done twice: the library
# is newer than every RTL file and as its sum says, or it is built again, the C++ through ccache where that is
# installed. With +fresh its exit code says whether nothing is to be done; then nothing is written.
set -euo pipefail
build=$(cd "$1" && pwd) out=$2
shift 2
root=$(cd "$(dirname "$0")/../.." && pwd)
fresh() {
  [ -e "$out/librtl.so" ] && [ "$(cksum < "$out/librtl.so")" = "$(cat "$out/librtl.sum" 2> /dev/null)" ] &&
    [ -z "$(find "$root/rtl" "$root/sim/rtl/rtl_bridge.cpp" \
    "$root/sim/rtl/wave_disk.cpp" "$root/sim/rtl/"*.hpp \
    "$root/sim/rtl/pins" "$root/cpp_model/driver/"*.[ch] \
    "$root/sim/memory/external_memory.hpp" "$root/sim/memory/memory_timing.hpp" "$root/sim/rtl/build_rtl.sh" \
    "$root/sim/rtl/verilate.sh" "$root/sim/rtl/units.vlt" "$root/cpp_model/config.def" "$root/cpp_model/records.def" \
    "$root/sim/rtl/pipegs_sim.sv" \
    "$build/cpp_model/package_sv" "$build/sim/memory/libpipegs_memory.a" "$build/sim/memory/dram/libpipegs_dram.a" \
    -newer "$out/librtl.so" -type f)" ]
}
if fresh; then exit 0; fi
case " $* " in *" +fresh "*) exit 1 ;; esac
mkdir -p "$out"
out=$(cd "$out" && pwd)
exec 9> "$out/lock"
flock 9
if fresh; then exit 0; fi
settings=() options=() tuning=() waves=0 shared=1 units=()
for argument in "$@"; do
  case $argument in
    +waves) options+=(--trace-fst) waves=1 shared=0 ;;
    +noasserts) options+=(--no-assert) ;;
    +dopu | +pu | +su | +ru) units+=("pipegs_${argument#+}") shared=0 ;;
    +apart) shared=0 ;;
    +verilator=*) IFS=, read -ra more <<< "${argument#*=}"; options+=("${more[@]}") ;;
    +cxx=*) IFS=, read -ra more <<< "${argument#*=}"; tuning+=("${more[@]}") ;;
    +*) echo "build_rtl.sh: $argument is unknown" >&2; exit 1 ;;
    *) settings+=("$argument") ;;
  esac
done
rm -f "$out"/*.o
touch "$out/begun"  # the library is as old as this: a file that changes from here on is newer
"$build/cpp_model/package_sv" "${settings[@]}" > "$out/pipegs_pkg.sv"
shards=4
if [ ${#units[@]} -gt 0 ]; then
  rm -rf "$out/netlists"
  "$root/synth/synth.py" --build "$build" --set "${settings[*]}" --netlist "$out/netlists" "${units[@]}"
  asked=" ${units[*]} "
  mapfile -t units < <(cd "$out/netlists" && basename -s .v -- *.v)  # a unit with parameters is several
  for unit in "${units[@]}"; do
    "$root/sim/rtl/verilate.sh" "$unit" "$out/units/$unit" "$out/netlists/$unit.v" $shards \
      --lib-create "$unit" --clk clk_i --clk rst_ni
    # Verilator 5.006 leaves it undefined, and the wrapper compares it.
    sed -i 's/long long m_seqnum;/long long m_seqnum = 0;/' "$out/units/$unit/$unit.cpp"
    options+=("$out/units/$unit/$unit.sv")  # the wrapper that it wrote: a module that is read is not looked for in rtl/
  done
  mapfile -t choices < <(find "$out/netlists" -name '*.sv')  # NAME.sv chooses among those of a unit
  options+=("${choices[@]}")
  options+=(-Wno-UNOPTFLAT)  # a wrapper is one process: what comes in as ready and goes out as valid looks like a loop
fi
if [ $shared = 1 ]; then
  options=(--inline-mult 2000 "$root/sim/rtl/units.vlt" "${options[@]}")  # -O3 inlines every module
fi
"$root/sim/rtl/verilate.sh" pipegs_sim "$out" "$out/pipegs_pkg.sv" $shards -y "$root/sim/rtl" "${options[@]}"
for unit in ${asked:-}; do
  if grep -q "$root/rtl/[^ ]*/$unit\.sv" "$out/depends.d"; then echo "build_rtl.sh: $unit is not gates" >&2; exit 1; fi
done
# A level of instructions by its name, not the processor's own: through ccache they could reach another one.
levels=$(/lib64/ld-linux-x86-64.so.2 --help 2> /dev/null | sed -n 's/^ *\(x86-64-v[34]\) (supported.*/\1/p' || true)
if [ -n "$levels" ]; then tuning=("-march=${levels%%$'\n'*}" "${tuning[@]}"); fi
cxx=$(command -v clang++ || echo "${CXX:-g++}")
ccache=$(command -v ccache || true)
verilator=$(verilator -V | sed -n 's/^ *VERILATOR_ROOT *= //p' | grep -v '^$' | tail -n 1)
verilator=${verilator:-/usr/share/verilator}
common="-std=c++20 -fPIC -I$root -isystem $verilator/include -isystem $verilator/include/vltstd \
  -DVL_USER_STOP -DVM_COVERAGE=0 -DVM_SC=0 -DVM_TRACE=$waves -DVM_TRACE_FST=$waves -DVM_TRACE_VCD=0"
flags="$common -isystem $out"
compile() { CCACHE_SLOPPINESS=pch_defines,time_macros $ccache "$cxx" $flags "$@"; }
export -f compile
export ccache cxx flags
# ahead OPTION ...: the options that read verilated.h as these options compile it, once for all machines; it takes as
# long as all else that a file reads. None for waves, and for another compiler than Clang.
ahead() {
  local file
  if [[ $waves = 1 || $cxx != *clang++ ]]; then return; fi
  file=$build/rtl_headers/$(cksum <<< "$(verilator --version) $cxx $common $*" | tr ' ' _).pch
  mkdir -p "${file%/*}"
  # shellcheck disable=SC2086
  flock "${file%/*}" bash -c '[ -e "$0" ] || { "$@" -o "$0.new" && mv "$0.new" "$0"; }' "$file" "$cxx" $common "$@" -w \
    -Xclang -fno-pch-timestamp -x c++-header "$verilator/include/verilated.h"
  echo "-include-pch $file"
}
{ for unit in "${units[@]}"; do
    echo "$out/units/$unit/$unit.cpp $out/$unit.o -O2 -w"
    for i in $(seq 0 $((shards - 1))); do
      echo "$out/units/$unit/V${unit}__shard$i.cpp $out/${unit}_shard$i.o -O1 -w -I$out/units/$unit"
    done
    echo "$out/units/$unit/V${unit}__once.cpp $out/${unit}_once.o -O0 -w -I$out/units/$unit"
  done
  # -O3 takes twice as long to compile and is no faster: Verilator has done what it would do.
  fast="-O1 -ffunction-sections ${tuning[*]}"
  # shellcheck disable=SC2086
  fast+=" $(ahead $fast)"
  for i in $(seq 0 $((shards - 1))); do echo "$out/Vpipegs_sim__shard$i.cpp $out/shard$i.o $fast -w"; done
  echo "$out/Vpipegs_sim__once.cpp $out/once.o -O0 $(ahead -O0) -w"  # what waves need is in it: half of all code
  if [ $waves = 1 ]; then
    echo "$verilator/include/verilated_fst_c.cpp $out/fst.o -O2 -w"
    echo "$root/sim/rtl/wave_disk.cpp $out/disk.o -O2 -Wall -Wextra"
  fi
  echo "$root/sim/rtl/rtl_bridge.cpp $out/bridge.o $fast -Wall -Wextra"; } |
  xargs -P "$(nproc)" -L 1 bash -c 'compile -c "$0" -o "$1" "${@:2}"'
linking=()
if [ $waves = 1 ]; then  # wave_disk.cpp
  linking=("-Wl,--wrap=fwrite,--wrap=fputc,--wrap=fflush,--wrap=fclose,--wrap=mmap")
fi
if [ $shared = 1 ] && command -v ld.gold > /dev/null; then linking=(-fuse-ld=gold "-Wl,--icf=all"); fi
"$cxx" -shared "${linking[@]}" -o "$out/librtl.so.new" "$out"/*.o "$build/sim/memory/libpipegs_memory.a" \
  "$build/sim/memory/dram/libpipegs_dram.a" \
  "$build/libverilated_runtime.a" "$build/cpp_model/libpipegs_model.a" -lz -latomic -lpthread
touch -r "$out/begun" "$out/librtl.so.new"
cksum < "$out/librtl.so.new" > "$out/librtl.sum.new"
mv "$out/librtl.sum.new" "$out/librtl.sum"
mv "$out/librtl.so.new" "$out/librtl.so"
