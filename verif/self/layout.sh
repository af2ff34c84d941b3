#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# layout.sh: the layout's rule, checked: rtl/<folder>/<module>.sv = cpp_model/<folder>/<name>.hpp =
# verif/<folder>/<name>_test.cpp = a heading or a row in docs/units. A folder is that of a unit, or of a part of it as
# pu/color; a name is that of the module without the prefix pipegs_, which keeps it apart from modules of others in one
# system. So every module has it, but those whose name begins with their unit: dopu_, pu_, su_, ru_.
#
# Plumbing (rtl/lib queues and memories, rtl/buf) has no bit-accurate model but a test. A module that lacks its test or
# its bit-accurate model needs a line in covered_by.txt with the test that covers it, and no line may be stale: its
# module, its test and the need for it must exist. A stage of cpp_model/pu/stages.def is covered by pu_shape. Also: at
# most 430 lines a file, a head comment, no page that names a module that is gone. Prints what is missing and fails when
# anything is.
set -uo pipefail
cd "$(dirname "$0")/../.." || exit
list=verif/self/covered_by.txt
status=0
complain() { echo "$1"; status=1; }

# The file of the test that covers module $1 of folder $2: that of a stage, or according to the list; nothing without a
# line.
covering_test() {
  local test
  if [ ! -e "verif/$2/$1_test.cpp" ] && grep -q "(${1#pu_}, " cpp_model/pu/stages.def; then
    echo verif/pu/pu_shape_test.cpp
    return
  fi
  test=$(awk -v name="$1" '$1 == name {print $2}' "$list")
  case $test in
    "") ;;
    self/package) echo verif/self/package_test.py ;;
    prove/*) if grep -qE "^proof +${test#*/} " synth/prove/table.sh; then echo synth/prove/table.sh; fi ;;
    */*) echo "verif/${test}_test.cpp" ;;
    *) echo "verif/$2/${test}_test.cpp" ;;
  esac
}

folder_of() { local folder; folder=$(dirname "${1#rtl/}"); echo "${folder/#./rtl}"; }

mapfile -t files < <(find rtl -name "*.sv" | sort)
for file in "${files[@]}"; do
  folder=$(folder_of "$file") name=$(basename "$file" .sv)
  own_test=verif/$folder/${name#pipegs_}_test.cpp model=cpp_model/$folder/${name#pipegs_}.hpp
  covering=$(covering_test "$name" "$folder")
  [ -e "$own_test" ] || [ -e "${covering:-none}" ] || complain "$file: no $own_test and no valid line in $list"
  case ${folder%%/*}:$name in
    *:pipegs_* | dopu:dopu_* | pu:pu_* | su:su_* | ru:ru_*) ;;
    *) complain "$file: a module is named pipegs_NAME, or UNIT_NAME in its unit's folder" ;;
  esac
  grep -qE "^(module|package) $name\b" "$file" || complain "$file: no module of this name"
  case $folder in
    lib | lib/math | buf) needs_model= ;;
    *) needs_model=1; [ -e "$model" ] || [ -n "$covering" ] || complain "$file: no $model and no line in $list" ;;
  esac
  if [ -n "$covering" ] && [ -e "$own_test" ] && { [ -z "$needs_model" ] || [ -e "$model" ]; }; then
    complain "$list: $name has a test and a model of its own, its line is not needed"
  fi
  grep -qw -- "$name" docs/units/*.md || complain "$file: no heading or row in docs/units"
  lines=$(wc -l < "$file")
  [ "$lines" -le 430 ] || [ "$name" = pipegs_pkg ] || complain "$file: $lines lines, at most 430"
  [ "$(sed -n 2p "$file" | cut -c 1-3)" = "// " ] || complain "$file: no head comment"
done

while read -r name test; do
  file=$(find rtl -name "$name.sv")
  [ -n "$file" ] || { complain "$list: no module $name"; continue; }
  covering=$(covering_test "$name" "$(folder_of "$file")")
  [ -e "$covering" ] || complain "$list: $name: no test $test"
done < <(grep -v '^#' "$list")

# A page may name modules, tests and functions of the models, but none that is gone.
pages=(docs sim/studies)
for name in $(grep -rohE --include='*.md' '`(pipegs|dopu|pu|su|ru)_[a-z0-9_]+`' "${pages[@]}" | tr -d '`' | sort -u); do
  [ -n "$(find rtl verif -name "$name.sv" -o -name "$name.cpp")" ] ||
    grep -rqw --include={*.sv,*.?pp,*.[ch],*.def,CMakeLists.txt,table.sh} -- "$name" \
      rtl cpp_model verif synth/prove cpp_model/driver ||
    complain "docs: there is no $name"
done
exit $status
