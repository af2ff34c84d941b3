#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# viewer.sh: how far a viewer of the web is from the machine: viewer.sh PIPEGS OPTION ...
#
# The page of `pipegs sim OPTION ... --viewer` is opened in headless Chromium with each of its settings.
# Prints JSON: bytes of the page, milliseconds until it is ready, PSNR by settings.
set -euo pipefail
pipegs=$(realpath "$1") here=$(cd "$(dirname "$0")" && pwd)
build=$(dirname "$pipegs") folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
shift
mkdir -p "$build/page"
"$here/../../sim/report/page/build.sh" "$build/page" dev > "$build/page/build.log" 2>&1 ||
  { cat "$build/page/build.log" >&2; exit 3; }
"$pipegs" sim "$@" --out "$folder" --viewer > "$folder/out.txt"
PAGE=$build/page FOLDER=$folder node "$here/viewer.mjs"
