#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# shared.sh PIPEGS: trained scenes in the formats in which others publish them show the pictures of another renderer.
#
# Needs   scenes/ of the folder that PIPEGS_SHARED names, or of ../shared; skipped (77) without it.
# Idea    The references were rendered in float64 of the values that another decoder took from the same files. So the
#         pictures agree but for the rounding of a byte in one of ten thousand pixels.
set -uo pipefail
pipegs=$1 root=$(cd "$(dirname "$0")/../.." && pwd)
scenes=${PIPEGS_SHARED:-$root/../shared}/scenes
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tried=0 status=0
check() {  # folder, scene in it, Gaussians, view
  local folder=$scenes/$1 scene=$scenes/$1/$2 view=${4:-0}
  [ -e "$scene" ] || { echo "skipped: no $scene"; return; }
  tried=$((tried + 1))
  "$pipegs" info "$scene" | grep -q ": $3 Gaussians ($3 usable)" || { echo "$scene: not $3 Gaussians"; status=1; }
  "$pipegs" render "$scene" --cameras "$folder/cameras.json" --view "$view" --model truth --semantics inria \
    --out "$work/out" --compare "$folder/reference${4:+_$4}.png" > "$work/log" 2>&1
  local differing pixels codes
  read -r differing pixels codes < <(
    sed -n 's/^against .*: \([0-9]*\) of \([0-9]*\) pixels .* by \([0-9]*\) codes.*/\1 \2 \3/p' "$work/log"
  )
  echo "$1, view $view: ${differing:-?} of ${pixels:-?} pixels differ, by ${codes:-?} of 255 at most"
  if [ -z "$differing" ] || [ "$codes" -gt 1 ] || [ $((differing * 10000)) -gt "$pixels" ]; then
    cat "$work/log"
    status=1
  fi
}
check plushdog point_cloud_29999_clean.ply 15105
check plushdog point_cloud_29999_clean.ply 15105 1
check plushdog point_cloud_29999_clean.ply 15105 2
check statue st-peter.sog 133618
check flowers flowers/lod-meta.json 542104
check terrace splat_30000_full_output/lod-meta.json 300000
[ $tried -gt 0 ] || { echo "skipped: no scenes in $scenes (set PIPEGS_SHARED)"; exit 77; }
exit $status
