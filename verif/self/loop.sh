#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# loop.sh: what `make run` from nothing and the loops of docs/developing.md take in processor seconds, without the
# compiler's cache, as JSON; of `make run` also the megabytes of its folder and of the memory of its largest process.
#
# The test of a module and the machine are built from nothing, which is the most that an edit of one module can cost;
# C++ that both need is there before. `docs/figures` runs this script (measurement loops/all). Exit code 3 when a step
# fails, with the end of its log.
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 3
build=$(realpath "${BUILD:-build}") work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export CCACHE_DISABLE=1

step() {  # COMMAND ...: runs it, or ends the script
  "$@" > "$work/log" 2>&1 || { tail -n 5 "$work/log" >&2; echo "loop.sh: $* failed" >&2; exit 3; }
}
timed() {  # NAME COMMAND ...: the same, and its processor seconds
  local before after
  times > "$work/times"; before=$(total)
  step "${@:2}"
  times > "$work/times"; after=$(total)
  found+=("\"$1\": $((after - before))")
}
total() {  # of all that was started until now
  sed -n 2p "$work/times" | tr 'ms' '  ' | awk '{printf "%.0f", $1 * 60 + $2 + $3 * 60 + $4}'
}
module_test() {
  cmake --build "$build" --target pu_conic_test && ctest --test-dir "$build" -R '^pu_conic$' --no-tests=error
}

largest() {  # COMMAND ...: runs it, and prints last the megabytes of its largest process
  python3 -c 'import resource, subprocess, sys
code = subprocess.run(sys.argv[1:]).returncode
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1024)
sys.exit(code)' "$@"
}

found=()
timed compile largest make core BUILD="$work/build"
memory=$(tail -n 1 "$work/log")
timed run largest "$work/build/pipegs" sim --out "$work/build/out"
simulated=$(tail -n 1 "$work/log")
found+=("\"memory_mb\": $((memory > simulated ? memory : simulated))" "\"disk_mb\": $(du -sm "$work/build" | cut -f 1)")
rm -rf "$work/build"
step cmake --build "$build" --target pipegs rtl pu_conic_test
machine=$(synth/design_points.py | sed -n 's/^fast //p')
rm -rf "$build/verilated/verilated_pu_conic" "$build"/verif/pu/conic/{libverilated_pu_conic.a,pu_conic_test}
timed module module_test
# shellcheck disable=SC2086  # the settings are words
timed machine sim/rtl/build_rtl.sh "$build" "$work/machine" $machine
timed frame "$build/pipegs" sim --no-truth --out "$work/frame"
(IFS=,; echo "{${found[*]}}")
