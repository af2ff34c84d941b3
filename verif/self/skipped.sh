#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# skipped.sh BUILD: one line that says how many cases the last ctest skipped in entries that passed all the same, and in
# which entries. Those in which all were skipped, ctest names itself (verif/self/test_main.cpp).
log=$1/Testing/Temporary/LastTest.log
awk '/^[0-9]+\/[0-9]+ Test: / {name = $3}
  /^skipped [0-9]+ of [0-9]+ cases$/ && $2 < $4 {cases += $2; entries++; names = names " " name "(" $2 ")"}
  END {if (entries) print "Skipped " cases " cases in " entries " entries that passed:" names}' "$log" >&2
