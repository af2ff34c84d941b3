#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# verilate.sh: turns one module of rtl/ into C++: verilate.sh MODULE OUT_DIR PACKAGE [SHARDS [OPTION ...]]
#
# PACKAGE is a pipegs_pkg.sv printed by package_sv, or the netlist MODULE.v that `synth/synth.py --netlist` wrote: then
# only memories are read from rtl/, and Verilator optimises nothing, for its optimisations are slow on gates. The C++ is
# gathered into one file OUT_DIR/V<module>__all.cpp, so that a build system knows its name. With SHARDS it is that many
# files OUT_DIR/V<module>__shard<i>.cpp, to be compiled side by side, and OUT_DIR/V<module>__once.cpp for what runs once
# or seldom (initial values, and what waves need), which nobody need optimise. SHARDS 0: one file. OUT_DIR/depends.d
# lists the RTL files read. Waves are written only with the OPTION --trace-fst; assertions are checked unless
# --no-assert leaves them out.
set -euo pipefail
module=$1 out=$2 package=$3 shards=${4:-0}
options=("${@:5}")
root=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$out"
rm -f "$out"/V"$module"*
mapfile -t folders < <(find "$root/rtl" -type d | sort | sed 's/^/-y\n/')
sources=("$package" "${folders[@]}" "$module")
if [[ $package == *.v ]]; then
  sources=("$package" -y "$root/rtl/lib")
  options+=(-O0 --no-assert -Wno-UNUSED -Wno-DECLFILENAME)
fi
verilator --cc --prefix "V$module" --top-module "$module" --Mdir "$out" -O3 --assert \
  --x-initial unique --x-assign unique --unroll-count 256 --output-split 20000 --output-split-cfuncs 2000 -Wall \
  "$root/sim/rtl/waivers.vlt" "${sources[@]}" "${options[@]}"
i=0
parts=(all)
if [ "$shards" != 0 ]; then mapfile -t parts < <(echo once; seq -f shard%.0f 0 $((shards - 1))); fi
for part in "${parts[@]}"; do : > "$out/V${module}__$part.cpp"; done
# shellcheck disable=SC2010  # largest first, and names of ours
for file in $(ls -S "$out"/V"$module"*.cpp | grep -v '__all\|__shard\|__once'); do
  case $shards:$file in
    0:*) part=all ;;
    *Slow.cpp | *__Syms.cpp | *__Trace__*) part=once ;;
    *) part=shard$((i % shards)) i=$((i + 1)) ;;
  esac
  echo "#include \"$(basename "$file")\"" >> "$out/V${module}__$part.cpp"
done
{ printf '%s:' "$out/V${module}__${parts[-1]}.cpp"; sed -n '1s/^[^:]*://p' "$out/V${module}__ver.d" | tr ' ' '\n' |
  grep -E '\.(sv|vlt)$' | sort -u | sed 's/^/ /' | tr -d '\n'; echo; } > "$out/depends.d"
