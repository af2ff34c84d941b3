#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# lacks.sh MODULE [SINCE]: what belongs to a module, and what a change to it still lacks.
#
# A row for each thing: bit-accurate model, test, mutation tests, timing model, proof, page, area point. "lacks" is
# what layout.sh demands and is not there (exit code 1); "none" is what not every module has. When the module has
# changed since the commit SINCE (HEAD by default: what is not committed yet), each row also says whether it has, too: a
# row "as before" is either right as it is or forgotten, which only who made the change can know.
set -uo pipefail
cd "$(dirname "$0")/../.." || exit
name=${1:-} since=${2:-HEAD} status=0
file=$(find rtl -name "$name.sv")
[ -n "$name" ] && [ -n "$file" ] || { echo "lacks.sh: there is no module '$name' in rtl/" >&2; exit 2; }
git rev-parse --quiet --verify "$since^{commit}" > /dev/null || { echo "lacks.sh: no commit $since" >&2; exit 2; }
unit=${file#rtl/} unit=${unit%%/*} short=${name#pipegs_}
changed() { ! git diff --quiet "$since" -- "$1" || [ -n "$(git ls-files --others --exclude-standard -- "$1")" ]; }
row() {  # WHAT FILES...
  local what=$1 path state; shift
  [ $# -gt 0 ] || { printf '%-20s none\n' "$what"; return; }
  for path in "$@"; do
    state=""
    if [ -n "$moved" ]; then if changed "$path"; then state="changed"; else state="as before"; fi; fi
    printf '%-20s %s%s\n' "$what" "$path" "${state:+  ($state)}"
  done
}
named() { grep -lwE -- "$1" "${@:2}" 2> /dev/null; }

moved=""
if changed "$file"; then moved=1; fi
row "module" "$file"
covering=$(awk -v name="$name" '$1 == name {print $2}' verif/self/covered_by.txt)
stage=""
if grep -q "(${name#pu_}, " cpp_model/pu/stages.def; then stage=1 covering=pu_shape; fi
complaint=$(verif/self/layout.sh | grep -wE -- "$name" || true)

mapfile -t found < <(find cpp_model -name "$short.hpp" -o -name "$short.cpp" | sort)
row "bit-accurate model" "${found[@]}"
mapfile -t found < <(find verif -name "${short}_test.cpp" -o -name "${covering##*/}_test.cpp" | sort)
row "test" "${found[@]}"
mapfile -t found < <(named "mutant +$name" verif/mutation/table.sh)
row "mutation tests" "${found[@]}"
mapfile -t found < <(grep -rlwE -- "$name${stage:+|stages.def}" sim/timing)
row "timing model" "${found[@]}"
mapfile -t found < <(find synth/prove -name "${short}_proof.svh"; named "proof +$short" synth/prove/table.sh)
row "proof" "${found[@]}"
mapfile -t found < <(named "$name" docs/units/*.md)
row "page" "${found[@]}"
mapfile -t found < <(named "$unit,$name" synth/data/points.csv)
row "area point" "${found[@]}"
if [ -n "$complaint" ]; then printf 'lacks: %s\n' "$complaint"; status=1; fi
if [ -n "$moved" ]; then
  echo "figures of it: make figures (python3 docs/figures --check names those that are older than the sources)"
fi
exit $status
