#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# commands.sh PIPEGS: the command line with scenes of every format: info, convert and a picture of each; a file that is
# cut is refused with exit code 2 and one line, or the rest of a row is named.
set -uo pipefail
pipegs=$1 own=$(cd "$(dirname "$0")" && pwd)/own
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0
complain() { echo "$1"; status=1; }
refused() {  # what is said, then the command
  local part=$1
  "${@:2}" > "$work/out" 2> "$work/err"
  local code=$?
  if [ $code != 2 ] || [ "$(wc -l < "$work/err")" != 1 ] || ! grep -qF -- "$part" "$work/err"; then
    complain "exit code $code, expected 2 and one line with '$part': ${*:2}"
    cat "$work/err"
  fi
}
cat > "$work/cameras.json" << 'JSON'
[{"id": 0, "img_name": "a", "width": 64, "height": 48, "position": [0, -1, -6],
  "rotation": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "fx": 60, "fy": 60}]
JSON
render() { "$pipegs" render "$@" --cameras "$work/cameras.json" > "$work/log" 2>&1; }
python3 -m zipfile -e "$own/sog/scene.sog" "$work/sog_dir"
python3 -m zipfile -e "$own/sog/streamed.zip" "$work/streamed"
for scene in "$own"/scene.* "$own"/*/scene.* "$work/sog_dir" "$work/streamed"; do
  case $scene in */expected/*) continue ;; esac
  name=$(basename "$scene")
  "$pipegs" info "$scene" --json > "$work/info.json" 2>&1 || complain "info $name"
  grep -q '"position": ".*bits\|"position": "float32\|"all values"' "$work/info.json" || complain "info $name: no bits"
  "$pipegs" convert "$scene" --out "$work/inria" > "$work/log" 2>&1 || complain "convert $name"
  render "$scene" --out "$work/as_is" || complain "render $name"
  render "$work/inria/scene.ply" --out "$work/converted" || complain "render $name, converted"
  # What was converted shows the same picture, to the last bit.
  cmp -s "$work/as_is/frame.exr" "$work/converted/frame.exr" || complain "$name: another picture once it is converted"
  [ -d "$scene" ] && continue
  head -c 333 "$scene" > "$work/cut"
  if [[ $scene == *.splat ]]; then  # rows to the end, and no count: the rest of a row is left out
    "$pipegs" info "$work/cut" | grep -q '13 bytes behind the last Gaussian' || complain "$name, cut: not told"
    continue
  fi
  refused "pipegs: $work/cut: " "$pipegs" info "$work/cut"
  refused "pipegs: $work/cut: " "$pipegs" sim "$work/cut" --cameras "$work/cameras.json"
done
refused "--lod: found 2, expected 0 to 1" "$pipegs" info "$work/streamed" --lod 2
refused "one level of detail" "$pipegs" info "$own/scene.splat" --lod 1
refused "--axes: found 'XYZ'" "$pipegs" info "$own/scene.splat" --axes XYZ
refused "pipegs: $work/cut: " "$pipegs" convert "$work/cut" --out "$work/none"
[ -e "$work/none" ] && complain "convert left a folder behind"
"$pipegs" convert "$work/streamed" --out "$work/level" --lod 1 | grep -q '1060 Gaussians' || complain "--lod 1"
exit $status
