# SPDX-License-Identifier: Apache-2.0
# turns.cmake: tests that take turns: each day a third of them is built and run, beside all that the default machine
# needs. They are the unit tests of a module in further configurations, whole frames on other machines, proofs, readers
# once more under sanitizers, and what takes Yosys or a browser long.
#
# Rule    `make test-long` runs all of them: a test whose turn it is not has the label `long`, and another test before
#         it builds it. So `ctest -R '^su_tiny$'` works on every day. `cmake -DPIPEGS_DAY=all` makes every day all
#         days'; a number makes it that day (days since 1970).
set(PIPEGS_DAY "" CACHE STRING "whose tests `all` builds and `ctest -LE long` runs: a day, `all`; empty: today")
if(PIPEGS_DAY STREQUAL "")
  string(TIMESTAMP PIPEGS_DAY %s UTC)
  math(EXPR PIPEGS_DAY "${PIPEGS_DAY} / 86400")
endif()

# pipegs_turn(OUT): whether it is the turn of whoever asks, the next in the row.
function(pipegs_turn out)
  get_property(number GLOBAL PROPERTY PIPEGS_TURNS)
  math(EXPR number "${number} + 1")
  set_property(GLOBAL PROPERTY PIPEGS_TURNS ${number})
  set(turn 0)
  if(NOT PIPEGS_DAY STREQUAL all)
    math(EXPR turn "(${number} + ${PIPEGS_DAY}) % 3")
  endif()
  string(COMPARE EQUAL ${turn} 0 now)
  set(${out} ${now} PARENT_SCOPE)
endfunction()

# pipegs_long(NAME [TARGETS target ...] [TESTS test ...]): these tests (without TESTS the test NAME) are long ones, and
# another builds the programs that they run.
function(pipegs_long name)
  cmake_parse_arguments(ARG "" "" "TARGETS;TESTS" ${ARGN})
  if(NOT ARG_TESTS)
    set(ARG_TESTS ${name})
  endif()
  set_tests_properties(${ARG_TESTS} PROPERTIES LABELS long)
  if(NOT ARG_TARGETS)
    return()
  endif()
  set_target_properties(${ARG_TARGETS} PROPERTIES EXCLUDE_FROM_ALL ON)
  add_test(NAME ${name}_build COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR} --target ${ARG_TARGETS})
  set_tests_properties(${name}_build PROPERTIES LABELS long FIXTURES_SETUP ${name}_built RESOURCE_LOCK build)
  set_tests_properties(${ARG_TESTS} PROPERTIES FIXTURES_REQUIRED ${name}_built)
endfunction()

# pipegs_take_turns(NAME [TARGETS target ...] [TESTS test ...]): these tests, and the programs that they run, take one
# turn; on other days they are long ones.
function(pipegs_take_turns name)
  pipegs_turn(now)
  if(NOT now)
    pipegs_long(${name} ${ARGN})
  endif()
endfunction()
