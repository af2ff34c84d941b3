#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# misread_window.sh BUILD: gates that Yosys made of what it reads wrong are refused, and only by their cycles.
#
# The sources are those of verif/self/misread_tree.sh; the machine is `exact` with one unit of each kind, its DOPU as
# gates. synth/synth.py must refuse them. Then `check -assert` is taken out of it, as it was when this reading was in a
# netlist: beats and pixels of the window agree, and `pipegs sim --netlist` must exit 1 because the cycles do not.
# Gates of the sources as they are agree in all. Exit code 1 when one of these is not so.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=$(realpath "$1") scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
settings=(units=1 late=1 order=2 records=2048 bucket_bits=5)
window=(sim --design exact --set units=1 --window "8,6" --netlist --gates dopu --no-truth --json --out "$scratch/out")
fail() { echo "misread_window.sh: $1" >&2; exit 1; }

"$build/pipegs" "${window[@]}" > "$scratch/good.json" || fail "gates of the sources as they are differ"
mkdir "$scratch/tree"
verif/self/misread_tree.sh "$scratch/tree"
synth=("$scratch/tree/synth/synth.py" --build "$build" --set "${settings[*]}" --netlist "$scratch/gates" pipegs_dopu)
if "${synth[@]}" 2> "$scratch/err"; then fail "synth.py takes it"; fi
grep -q "elaborate\|yosys failed" "$scratch/err" || fail "synth.py says: $(cat "$scratch/err")"
sed -i '/^check -assert$/d' "$scratch/tree/synth/synth.py"
"$scratch/tree/sim/rtl/build_rtl.sh" "$build" "$scratch/rtl" +dopu "${settings[@]}" > "$scratch/log" 2>&1 ||
  fail "does not build: $(tail -n 3 "$scratch/log")"
code=0
PIPEGS_LIBRTL=$scratch/rtl/librtl.so "$build/verif/cli/pipegs_faulty" "${window[@]}" > "$scratch/bad.json" \
  2> "$scratch/err" || code=$?
[ "$code" = 1 ] || fail "the window ends with exit code $code"
grep "gates take" "$scratch/err" || fail "no word of cycles: $(cat "$scratch/err")"
grep -q '^  "mismatches": 1,$' "$scratch/bad.json" || fail "beats or pixels differ, too"
