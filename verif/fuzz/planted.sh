#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# planted.sh: planted.sh FOLDER TARGET: the fuzzer finds the overflow of keep.hpp in planted_TARGET within a minute of
# CPU time, which does not depend on what else the machine does; three times, each with other random numbers.
#
# It begins with the corpus, none of which shows the overflow: that is checked first. Large documents (many_*) are left
# out: no room holds what they name.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
target=$2 program=$1/planted_$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
seeds=$work/seeds
cp -r "$here/corpus/$target" "$seeds" && rm -f "$seeds"/many_*
if ! "$program" "$seeds"/* > "$work/log" 2>&1; then
  cat "$work/log"
  echo "$target: the corpus itself shows the overflow"
  exit 1
fi
TIMEFORMAT=%U
hunt() {
  "$program" -seed="$1" -max_len=8192 -dict="$here/dictionary/$target.dict" -artifact_prefix="$work/" "$work/new" \
    "$seeds" > "$work/log" 2>&1
}
for seed in 1 2 3; do
  rm -rf "$work/new" && mkdir "$work/new"
  used=$( (ulimit -t 60; time hunt "$seed") 2>&1)
  if ! grep -q 'AddressSanitizer: heap-buffer-overflow' "$work/log"; then
    tail -n 5 "$work/log"
    echo "$target: the planted overflow was not found in 60 s, seed $seed"
    exit 1
  fi
  echo "$target: the planted overflow was found in $used s, seed $seed"
done
