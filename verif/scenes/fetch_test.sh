#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# fetch_test.sh: scenes/fetch.sh without a network: its clear line and exit code for each thing that goes wrong, and the
# way from a repository (a folder here) through the conversion to a .ply, for a .sog and for a streamed scene.
#
# scene.sog is 1424 Gaussians of our own generator, written by splat-transform 3.7.0, so writer and reader are different
# programs. The conversion needs numpy and PIL: without them that part is skipped (exit 77).
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
fetch=$here/../../scenes/fetch.sh scene=$here/../formats/own/sog/scene.sog
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failed=0
expect() {  # CODE TEXT ARGUMENTS ...: exit code and one line that holds the text
  local log code
  log=$("$fetch" "${@:3}" --into "$scratch/out" 2>&1); code=$?
  if [ $code -ne "$1" ] || [[ $log != *"$2"* ]] || [ "$(wc -l <<< "$log")" -ne 1 ]; then
    echo "expected $1 and '$2', got $code: $log"; failed=1
  fi
}
result=8a3b470718ecddce824d12440dd2801da719e773b49bcdb65338c24ac9363d3a  # of scene.ply
source=$(sha256sum < "$scene" | cut -d ' ' -f 1)
sog=$scratch/from/own/scenes/c0ffee/sog streamed=$scratch/from/own/scenes/c0ffee/streamed
mkdir -p "$sog" "$streamed"
cp "$scene" "$sog"
list=$scratch/list.txt
printf '%s\n' "scene own own/scenes c0ffee sog" "source scene.sog $source" "result scene.sog $result" > "$list"

expect 2 "which scene? There are own" --list "$list"
expect 2 "garden is not known; there are own" garden --list "$list"
expect 2 "which scene? There are statue, plushdog, flowers"
expect 2 "--nonsense is unknown" own --nonsense
expect 2 "gone.txt cannot be read" own --list "$scratch/gone.txt"
expect 3 "sog/scene.sog could not be fetched" own --list "$list" --from "file://$scratch/gone"
expect 3 "could not be fetched" own --list "$list" --from "http://127.0.0.1:9"
sed "s/^source scene.sog ../source scene.sog zz/" "$list" > "$scratch/other.txt"
expect 1 "sog/scene.sog has another SHA-256" own --list "$scratch/other.txt" --from "file://$scratch/from"
[ -z "$(find "$scratch/out" -name '*.ply' -o -name 'scene.sog')" ] || { echo "something wrong was kept"; failed=1; }

for python in python3 /usr/bin/python3 ""; do "${python:-true}" -c 'import numpy, PIL' 2> /dev/null && break; done
if [ -z "$python" ]; then
  [ $failed -eq 0 ] || exit 1
  echo "skipped: the conversion; no python3 with numpy and PIL (apt install python3-numpy python3-pil)"
  exit 77
fi
expect 0 "out/own/own.ply" own --list "$list" --from "file://$scratch/from"
expect 0 "out/own/own.ply" own --list "$list" --from "file://$scratch/gone"  # all is there
rm "$scratch/out/own/own.ply"
sed "s/^result scene.sog ../result scene.sog zz/" "$list" > "$scratch/other.txt"
expect 1 "own.ply has another SHA-256" own --list "$scratch/other.txt" --from "file://$scratch/from"

# The same Gaussians as the two halves of a streamed scene's level 0, and one of them as level 1.
mkdir "$streamed/0_0"
"$python" -m zipfile -e "$scene" "$streamed/0_0"
printf '%s' '{"lodLevels": 2, "filenames": ["0_0/meta.json"], "tree": {"children": [' \
  '{"lods": {"0": {"file": 0, "offset": 700, "count": 724}}},' \
  '{"lods": {"0": {"file": 0, "offset": 0, "count": 700}, "1": {"file": 0, "offset": 5, "count": 1}}}]}}' \
  > "$streamed/lod-meta.json"
{
  echo "scene halves own/scenes c0ffee streamed"
  (cd "$streamed" && find . -type f -printf '%P\n' | while read -r file; do
    echo "source $file $(sha256sum < "$file" | cut -d ' ' -f 1)"; done)
  echo "result lod-meta.json $result"
} > "$list"
expect 0 "out/halves/halves.ply" halves --list "$list" --from "file://$scratch/from"
"$python" "$here/../../scenes/fetch/to_ply.py" "$streamed/lod-meta.json" "$scratch/one.ply" 1 > /dev/null
grep -aqx "element vertex 1" "$scratch/one.ply" || { echo "level 1 has not one Gaussian"; failed=1; }
exit $failed
