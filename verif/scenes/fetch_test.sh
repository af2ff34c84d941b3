#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# fetch_test.sh: scenes/fetch.sh without a network: its clear line and exit code for each thing that goes wrong, and the
# way from a repository (a folder here) to a scene of one file and one of several.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
fetch=$here/../../scenes/fetch.sh
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
from=$scratch/from/own/scenes/c0ffee list=$scratch/list.txt
mkdir -p "$from/0_0"
cp "$here/../formats/own/sog/scene.sog" "$from"
echo '{}' | tee "$from/lod-meta.json" > "$from/0_0/meta.json"
hash() { sha256sum < "$from/$1" | cut -d ' ' -f 1; }
printf '%s\n' "scene own own/scenes c0ffee ." "source scene.sog $(hash scene.sog)" "scene-file scene.sog" \
  "scene parts own/scenes c0ffee ." "source 0_0/meta.json $(hash 0_0/meta.json)" \
  "source lod-meta.json $(hash lod-meta.json)" "scene-file lod-meta.json" > "$list"

expect 2 "which scene? There are own, parts" --list "$list"
expect 2 "garden is not known; there are own, parts" garden --list "$list"
expect 2 "which scene? There are statue, plushdog, flowers"
expect 2 "--nonsense is unknown" own --nonsense
expect 2 "gone.txt cannot be read" own --list "$scratch/gone.txt"
expect 3 "scene.sog could not be fetched" own --list "$list" --from "file://$scratch/gone"
expect 3 "could not be fetched" own --list "$list" --from "http://127.0.0.1:9"
sed "s/^source scene.sog ../source scene.sog zz/" "$list" > "$scratch/other.txt"
expect 1 "scene.sog has another SHA-256" own --list "$scratch/other.txt" --from "file://$scratch/from"
[ -z "$(find "$scratch/out" -name 'scene.sog')" ] || { echo "something wrong was kept"; failed=1; }
expect 0 "out/own/scene.sog" own --list "$list" --from "file://$scratch/from"
expect 0 "out/own/scene.sog" own --list "$list" --from "file://$scratch/gone"  # all is there
expect 0 "out/parts/lod-meta.json" parts --list "$list" --from "file://$scratch/from"
cmp -s "$scratch/out/parts/0_0/meta.json" "$from/0_0/meta.json" || { echo "0_0/meta.json is missing"; failed=1; }
exit $failed
