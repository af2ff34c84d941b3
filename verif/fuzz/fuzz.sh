#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# fuzz.sh: runs the fuzz targets, each for so many seconds: fuzz.sh FOLDER SECONDS [TARGET...], all without a name.
#
# FOLDER is where the build has put fuzz_TARGET. What a target finds new it keeps in FOLDER/corpus/TARGET, to begin
# there the next time; an input that breaks the reader is named, kept in FOLDER, and the exit code is 1. Such an input
# belongs into verif/fuzz/corpus/TARGET, which is replayed at the start of each run.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
folder=$1 seconds=$2
shift 2
if ! [[ $seconds =~ ^[1-9][0-9]*$ ]]; then
  echo "fuzz.sh: found '$seconds' seconds, expected an integer above 0" >&2
  exit 2
fi
targets=("$@")
[ $# -gt 0 ] || mapfile -t targets < <(find "$folder" -maxdepth 1 -type f -name 'fuzz_*' -printf '%f\n' | cut -c6-)
status=0
for target in "${targets[@]}"; do
  mkdir -p "$folder/corpus/$target"
  log=$folder/$target.log
  longest=$([ "$target" = scene ] && echo 8192 || echo 4096)  # a .ksplat has a header of 5120
  if "$folder/fuzz_$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=1024 -max_len="$longest" \
      -dict="$here/dictionary/$target.dict" -print_final_stats=1 -artifact_prefix="$folder/$target-" \
      "$folder/corpus/$target" "$here/corpus/$target" > "$log" 2>&1; then
    runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
    echo "$target: $runs inputs in $seconds s, nothing found"
  else
    grep -E '^(==[0-9]+==ERROR|SUMMARY|.*runtime error|Test unit written)' "$log" | sed "s/^/$target: /"
    echo "$target: found something, see $log"
    status=1
  fi
done
exit $status
