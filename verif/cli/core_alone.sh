#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# core_alone.sh BUILD: the core builds with sim/studies removed.
#
# Idea    A copy of the tree without that folder is configured: every source that CMake names is there. No object of the
#         core in BUILD has read a header of a study, so each compiles without them. A copy of `pipegs`, without
#         the program of the studies beside it, renders, and says where studies are.
# Output  What needs a study; exits 1 when something does.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/tree"
tar -c --exclude=sim/studies CMakeLists.txt cpp_model scenes sim | tar -x -C "$work/tree"
[ ! -e "$work/tree/sim/studies" ]
compilers=$(sed -nE 's/^(CMAKE_CX*_COMPILER):[A-Z]+=(.*)/-D\1=\2/p' "$build/CMakeCache.txt")
# shellcheck disable=SC2086
cmake -S "$work/tree" -B "$work/build" -G Ninja -DPIPEGS_TESTS=OFF $compilers > "$work/log" 2>&1 ||
  { tail -n 20 "$work/log"; exit 1; }
if grep -n 'sim/studies/' "$work/build/build.ninja"; then exit 1; fi

ninja -C "$build" -t deps > "$work/deps"
awk '
  /^[^ ]/ {
    object = $1; sub(/:$/, "", object)
    core = object ~ /^(cpp_model|scenes|sim)\// && object !~ /^sim\/studies\//; objects += core
  }
  core && /^ .*\/sim\/studies\// {print object " reads " $1; wrong = 1}
  END {print objects " objects of the core"; exit wrong || objects < 100}' "$work/deps"

cp "$build/pipegs" "$work"
"$work/pipegs" study budget > "$work/log" 2>&1 && { cat "$work/log"; exit 1; }
grep -q 'studies are in pipegs-studies: make build' "$work/log"
"$work/pipegs" render --size 32x32 --out "$work/out" > "$work/log" 2>&1 || { cat "$work/log"; exit 1; }
[ -s "$work/out/frame.png" ]
