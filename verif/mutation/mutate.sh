#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# mutate.sh: mutation tests: each change of one line of a module must make that module's test fail.
#   mutate.sh [NAME ...]         builds and runs the mutants of these groups or modules of table.sh; without a name, all
#   mutate.sh --check            builds nothing: each change finds its line, and its test is one of the build folder's
#   mutate.sh --day DAY          one mutant in 157 of the table, others each day, as `make test` runs them
#
# A mutant is built by the commands that ninja has for the test itself: verilate.sh from a copy of rtl/ and sim/rtl/ in
# $BUILD/mutation/TEST, the C++ of the module, the link; a change of the model compiles the test again. The test must
# pass on the unchanged source first. Caught: GoogleTest names a test that failed. No build, no end, an end without such
# a name: not caught. One line each, with the processor's seconds; exits 1 when a mutant survives, 3 when one does not
# run.
set -uo pipefail
unset PIPEGS_DAY PIPEGS_SEED  # what catches a mutant is the same each day
cd "$(dirname "$0")/../.." || exit 3
root=$PWD here=verif/mutation number=0 mutants=0 caught=0 survived=0 broken=0
mkdir -p "${BUILD:-build}/mutation" && build=$(cd "${BUILD:-build}" && pwd) || exit 3
mode=run day=
if [ "${1:-}" = --check ]; then mode=check && shift; fi
if [ "${1:-}" = --day ]; then day=$2 && shift 2; fi
wanted=" $* "
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT
declare -A passed
tests=" $(ninja -C "$build" -t targets all 2> /dev/null | sed -nE 's#^.*/([a-z0-9_]+)_test: .*#\1#p' | tr '\n' ' ')"

source_of() { if [[ $1 == */* ]]; then ls "cpp_model/$1" 2> /dev/null; else find rtl -name "$1.sv"; fi; }

# apply SOURCE CHANGE: the changed text in $work/changed; fails unless exactly one line differs
apply() {
  sed -E "$2" "$1" > "$work/changed" &&
    [ "$(diff "$1" "$work/changed" | sed -n '/^[<>]/s/\(.\).*/\1/p' | tr -d '\n')" = "<>" ]
}

seconds() {  # into $now: of the processor, of all children until now
  times > "$work/times"
  now=$(sed -n 2p "$work/times" | tr 'ms' '  ' | awk '{print $1 * 60 + $2 + $3 * 60 + $4}')
}

# build_mutant TEST SOURCE: with $work/changed in place of SOURCE; $copy/test is the program
build_mutant() {
  local test=$1 copy=$build/mutation/$1 dir=$build/verilated/verilated_$1 all=$work/commands link
  local part="s# -M[TF] \S+| -MD##g; s# -o \S+(.*/([^/]+)\.cpp)\$# -o $copy/part/\2.o\1#; p"
  ninja -C "$build" -t commands "$test"_test > "$all" || return
  link=$(tail -n 1 "$all" | sed -E "s# -o \S+# -o $copy/test#")
  rm -rf "${copy:?}"/{rtl,sim,cpp_model,verilated,part,test} && mkdir -p "$copy/sim/rtl" "$copy/part" "$copy/${2%/*}" &&
    cp -r rtl "$copy" && cp sim/rtl/*.sh sim/rtl/*.vlt "$copy/sim/rtl" && cp "$work/changed" "$copy/$2" || return
  if [[ $2 == rtl/* ]]; then
    sed -nE "s#^cd .* && $root(/sim/rtl/verilate.sh \S+ )$dir (.*) && \S+ -E cmake_transform_depfile .*#\
$copy\1$copy/verilated \2 -Wno-fatal#p" "$all"
    sed -nE "/ -c \S*verilated_$test\/V/{s#$dir#$copy/verilated#g; $part}" "$all"
    sed -E "s# \S*libverilated_$test\.a # $copy/part/*.o #" <<< "$link"
  else
    sed -nE "/ -c \S*_test\.cpp\$/{s# -I$root # -I$copy&#; $part}" "$all"
    sed -E "s# \S*_test\.cpp\.o # $copy/part/*.o #" <<< "$link"
  fi > "$copy/commands"
  (cd "$build" && bash -e "$copy/commands") > "$copy/log" 2>&1 && [ -x "$copy/test" ]
}

run_test() { timeout 300 "$1" --gtest_fail_fast --gtest_brief=1 > "$2" 2>&1; }

# passes TEST: the test is built and passes on the unchanged source; found out once for each test
passes() {
  local program
  if [ -z "${passed[$1]:-}" ]; then
    passed[$1]=no
    flock "$build/mutation" cmake --build "$build" --target "$1"_test > "$work/log" 2>&1 &&
      program=$(ninja -C "$build" -t commands "$1"_test | tail -n 1 | sed -E 's#.* -o (\S+) .*#\1#') &&
      run_test "$build/$program" "$work/log" && passed[$1]=yes
  fi
  [ "${passed[$1]}" = yes ]
}

# verdict TEST SOURCE: "caught by" a GoogleTest, "SURVIVED", or what went wrong
verdict() {
  local copy=$build/mutation/$1 first
  mkdir -p "$copy" && exec 9> "$copy/lock" && flock 9 || return
  if ! build_mutant "$1" "$2"; then echo "BROKEN: it does not build, see $copy/log"; return; fi
  if run_test "$copy/test" "$copy/log"; then echo SURVIVED; return; fi
  first=$(sed -nE 's/^\[  FAILED  \] ([A-Za-z0-9_.\/]+).*/\1/p' "$copy/log" | head -n 1)
  if [ -z "$first" ]; then echo "BROKEN: no test says that it failed, see $copy/log"; return; fi
  echo "caught by $first"
  rm -rf "$copy"
}

# --- the two words of the table ---------------------------------------------------------------------------------------
group() { group=$1; }  # NAME TITLE

mutant() {  # MODULE WHAT CHANGE [TEST]
  local module=$1 what=$2 test=${4:-${1#pipegs_}} source begin result
  [[ $wanted = "  " || $wanted = *" $module "* || $wanted = *" $group "* ]] || return 0
  number=$((number + 1))
  [[ -z $day || $(((number + day) % 157)) = 0 ]] || return 0
  mutants=$((mutants + 1)) source=$(source_of "$module")
  if [ -z "$source" ] || ! apply "$source" "$3"; then
    echo "$here/table.sh: $module: $what: does not change exactly one line of ${source:-a module}"
    broken=$((broken + 1))
    return
  fi
  if [[ $tests = *[a-z]* && $tests != *" $test "* ]]; then
    echo "$here/table.sh: $module: $what: there is no test $test"
    broken=$((broken + 1))
    return
  fi
  [ "$mode" = run ] || return 0
  seconds && begin=$now
  result="BROKEN: $test fails on the unchanged source"
  if passes "$test"; then result=$(verdict "$test" "$source"); fi
  case $result in
    caught*) caught=$((caught + 1)) ;;
    SURVIVED) survived=$((survived + 1)) ;;
    *) broken=$((broken + 1)) ;;
  esac
  seconds
  awk -v name="$module" -v from="$begin" -v to="$now" -v what="$what: $result" \
    'BEGIN {printf "%-24s %6.1f s  %s\n", name, to - from, what}'
}

. "$here/table.sh"
[ $mutants -gt 0 ] || { echo "mutate.sh: no such group or module: $*" >&2; exit 2; }

if [ "$mode" = check ]; then
  echo "$mutants mutants, $broken errors"
  exit $((broken > 0))
fi
echo "$mutants mutants, $caught caught, $survived survived, $broken could not be run"
if [ $broken -gt 0 ]; then exit 3; fi
exit $((survived > 0))
