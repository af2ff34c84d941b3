#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# page.sh: one test of the pages: page.sh NAME PIPEGS BUILD; NAME_test.mjs in this folder says what it looks at.
#
# Exit code 77, skipped, where node, npm or Chromium is not installed (`make test` installs them) or npm has no network.
set -euo pipefail
name=$1 pipegs=$(realpath "$2") build=$(realpath "$3")
here=$(cd "$(dirname "$0")" && pwd)
for tool in node npm chromium; do
  command -v "$tool" > /dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
mkdir -p "$build/page"
status=0
"$here/../../sim/report/page/build.sh" "$build/page" dev > "$build/page/build.log" 2>&1 || status=$?
if [ $status != 0 ]; then cat "$build/page/build.log"; fi
if [ $status = 4 ]; then echo "skipped: npm cannot bring the libraries"; exit 77; fi
[ $status = 0 ]
folder=$build/verif/page/$name
rm -rf "$folder"
mkdir -p "$folder"
PIPEGS=$pipegs PAGE=$build/page FOLDER=$folder node --test --test-reporter=spec "$here/${name}_test.mjs"
