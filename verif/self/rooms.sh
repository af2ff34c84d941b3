#!/usr/bin/env bash
# rooms.sh: the layout's rule, checked: rtl/<unit>/<name>.sv = cpp_model/<unit>/<name>.hpp = verif/<unit>/<name>_test.cpp.
#
# Plumbing (rtl/lib queues and memories, rtl/buf) has no twin but a test; wiring modules are covered by their unit's test
# and are named in the list below with that test. Prints what lacks its rhyme and fails when anything does.
set -uo pipefail
cd "$(dirname "$0")/../.."
status=0
for file in rtl/*/*.sv; do
  unit=$(basename "$(dirname "$file")") name=$(basename "$file" .sv)
  tested_by=$(sed -n "s/^$name  *//p" verif/self/covered_by.txt)
  if [ ! -e "verif/$unit/${name}_test.cpp" ] && [ ! -e "verif/$unit/${tested_by:-none}_test.cpp" ]; then
    echo "$file: no verif/$unit/${name}_test.cpp and no line in verif/self/covered_by.txt"
    status=1
  fi
  case $unit in lib|buf) continue ;; esac
  if [ ! -e "cpp_model/$unit/$name.hpp" ] && [ -z "$tested_by" ]; then
    echo "$file: no cpp_model/$unit/$name.hpp and no line in verif/self/covered_by.txt"
    status=1
  fi
done
for file in rtl/*.sv rtl/*/*.sv; do
  lines=$(wc -l < "$file")
  [ "$lines" -le 400 ] || [ "$(basename "$file")" = pipegs_pkg.sv ] || { echo "$file: $lines lines, at most 400"; status=1; }
  [ "$(head -n 1 "$file" | cut -c 1-3)" = "// " ] || { echo "$file: no head comment"; status=1; }
done
exit $status
