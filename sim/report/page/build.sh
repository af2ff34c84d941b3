#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# build.sh: the templates of the pages, OUT/*.html, each with its libraries in it, and OUT/svg.mjs, which draws charts:
#   build.sh OUT [dev|fresh]
#
# npm installs what package-lock.json names into OUT (dev: also the driver of the browser that the tests use), esbuild
# makes one script of all modules. Nothing is done twice: a template is older than nothing that lies in this folder, or
# it is made again. With fresh the exit code says whether nothing is to be done, and nothing is written. Exit code 4:
# npm has not brought the libraries, as without a network.
set -euo pipefail
room=$(cd "$(dirname "$0")" && pwd) out=$1 what=${2:-}
fresh() { [ -e "$out/made" ] && [ -z "$(find "$room" -newer "$out/made" -type f)" ]; }
if [ "$what" = fresh ]; then fresh; exit; fi
mkdir -p "$out"
out=$(cd "$out" && pwd)
exec 9> "$out/lock"
flock 9
installed=$out/installed$what
if [ ! -e "$installed" ] || [ "$room/package-lock.json" -nt "$installed" ]; then
  command -v npm > /dev/null || { echo "npm is not installed (Debian: apt-get install nodejs npm)" >&2; exit 4; }
  cp "$room/package.json" "$room/package-lock.json" "$out"
  omit=(--omit=dev)
  if [ "$what" = dev ]; then omit=(); fi
  (cd "$out" && npm ci --ignore-scripts --no-audit --no-fund "${omit[@]}") || exit 4
  touch "$out/installed" "$installed"
fi
if fresh; then exit 0; fi
touch "$out/begun"
node "$room/bundle.mjs" "$out"
mv "$out/begun" "$out/made"
