#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# verilate.sh: turns one module of rtl/ into C++: verilate.sh MODULE OUT_DIR PACKAGE [SHARDS [OPTION ...]]
#
# PACKAGE is a pipegs_pkg.sv printed by package_sv, or the netlist MODULE.v that `synth/synth.py --netlist` wrote: then
# only memories are read from rtl/, and Verilator optimises nothing, for its optimisations are slow on gates. The C++ is
# gathered into SHARDS files (default 1) OUT_DIR/V<module>__shard<i>.cpp, so that a build system knows their names and
# can compile them side by side, and into OUT_DIR/V<module>__once.cpp what runs once or seldom (initial values, and what
# waves need), which nobody need optimise. OUT_DIR/depends.d lists the RTL files read. Waves are written only with the
# OPTION --trace-fst; assertions are checked unless --no-assert leaves them out.
set -euo pipefail
module=$1 out=$2 package=$3 shards=${4:-1}
options=("${@:5}")
root=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$out"
rm -f "$out"/V"$module"*
sources=("$package" -y "$root/rtl" -y "$root/rtl/dopu" -y "$root/rtl/pu" -y "$root/rtl/su" -y "$root/rtl/ru"
  -y "$root/rtl/list" -y "$root/rtl/buf" -y "$root/rtl/lib" "$module")
if [[ $package == *.v ]]; then
  sources=("$package" -y "$root/rtl/lib")
  options+=(-O0 --no-assert -Wno-UNUSED -Wno-DECLFILENAME)
fi
verilator --cc --prefix "V$module" --top-module "$module" --Mdir "$out" -O3 --assert \
  --x-initial unique --x-assign unique --unroll-count 256 --output-split 20000 --output-split-cfuncs 2000 -Wall \
  "${options[@]}" "$root/sim/rtl/waivers.vlt" "${sources[@]}"
i=0
for shard in once $(seq -f shard%.0f 0 $((shards - 1))); do : > "$out/V${module}__$shard.cpp"; done
# shellcheck disable=SC2010  # largest first, and names of ours
for file in $(ls -S "$out"/V"$module"*.cpp | grep -v '__shard\|__once'); do
  case $file in
    *Slow.cpp | *__Syms.cpp | *__Trace__*) shard=once ;;
    *) shard=shard$((i % shards)) i=$((i + 1)) ;;
  esac
  echo "#include \"$(basename "$file")\"" >> "$out/V${module}__$shard.cpp"
done
{ printf '%s:' "$out/V${module}__shard0.cpp"; sed -n '1s/^[^:]*://p' "$out/V${module}__ver.d" | tr ' ' '\n' |
  grep -E '\.(sv|vlt)$' | sort -u | sed 's/^/ /' | tr -d '\n'; echo; } > "$out/depends.d"
