#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# shared_scenes.sh PIPEGS: every .ply and cameras.json of a folder of trained scenes is read, strict as the readers are.
#
# Needs   scenes/ of the folder that PIPEGS_SHARED names, or of ../shared; skipped (77) without it.
# Idea    A view that no file has is refused when scene and cameras have been read, which costs no more than reading.
set -uo pipefail
pipegs=$1 root=$(cd "$(dirname "$0")/../.." && pwd)
scenes=${PIPEGS_SHARED:-$root/../shared}/scenes
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
read=0 status=0
for cameras in "$scenes"/*/cameras.json; do
  for file in "$(dirname "$cameras")"/*.ply "$(dirname "$cameras")"/*.ply.xz; do
    case $file in *'*'*) continue ;; esac
    ply=$file
    if [[ $file == *.xz ]]; then
      command -v xz > /dev/null || { echo "skipped: $file (no xz)"; continue; }
      ply=$work/scene.ply
      xz -dc "$file" > "$ply" || exit 1
    fi
    "$pipegs" sim "$ply" --cameras "$cameras" --view 2147483647 --no-rtl --out "$work/out" 2> "$work/err"
    code=$?
    if [ $code != 2 ] || ! grep -q -- '--view: found 2147483647, expected 0 to' "$work/err"; then
      echo "$file with $cameras, exit code $code:"
      cat "$work/err"
      status=1
    fi
    read=$((read + 1))
  done
done
[ $read -gt 0 ] || { echo "skipped: no scenes in $scenes (set PIPEGS_SHARED)"; exit 77; }
echo "$read scenes and their cameras are read"
exit $status
