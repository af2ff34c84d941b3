# SPDX-License-Identifier: Apache-2.0
# unit_test.cmake: GoogleTests of one Verilated module each, as RTL and as netlist.

# Headers that all unit tests read, compiled once: an edit of bench.hpp, or of what it reads, recompiles all of them
# anyway. They run code that is optimised elsewhere: -O0 compiles in half the time.
foreach(level 0 1)
  set(headers unit_test_headers_O${level})
  add_executable(${headers} EXCLUDE_FROM_ALL ${PIPEGS_HEADERS_SOURCE})
  target_compile_definitions(${headers} PRIVATE VM_TRACE=0 VM_TRACE_FST=0)
  target_compile_options(${headers} PRIVATE -Wall -Wextra -O${level})
  target_link_libraries(${headers} PRIVATE verilated_runtime pipegs_model pipegs_memory pipegs_test_main fmt::fmt)
  target_precompile_headers(${headers} PRIVATE <gtest/gtest.h> <fmt/format.h> <glm/glm.hpp> <verilated.h> <algorithm>
                            <deque> <filesystem> <functional> <map> <memory> <random>
                            ${CMAKE_SOURCE_DIR}/verif/support/bench.hpp)
endforeach()

# pipegs_unit_test(NAME MODULE module [SOURCE file] [RTL_ONLY] [OPTIMISED] [LONG] [SET key=value ...]
# [PARAMETERS Name=value ...] [CHECKERS file ...]): a GoogleTest of one module against its bit-accurate model.
# PARAMETERS are the module's own, CHECKERS are SystemVerilog files read with it. OPTIMISED compiles with -O1 a test
# that runs for long. The test sees the configuration as PIPEGS_SET, a string for pipegs::test_config().
# NAME_waves_test, which only a replay builds, is the same test with waves. In the default configuration, with the
# module's own parameters, it is a test of the netlist too, unless RTL_ONLY says that there is none. In another
# configuration the test of another one (SOURCE) takes turns; with LONG it is a long test.
function(pipegs_unit_test name)
  cmake_parse_arguments(ARG "RTL_ONLY;OPTIMISED;LONG" "MODULE;SOURCE" "SET;PARAMETERS;CHECKERS" ${ARGN})
  set(again ${ARG_SOURCE})
  if(NOT ARG_SOURCE)
    set(ARG_SOURCE ${name}_test.cpp)
  endif()
  set(level 0)
  if(ARG_OPTIMISED)
    set(level 1)
  endif()
  string(REPLACE ";" " " set_text "${ARG_SET}")
  list(TRANSFORM ARG_PARAMETERS PREPEND "-G" OUTPUT_VARIABLE options)
  list(APPEND options ${ARG_CHECKERS})
  pipegs_verilated(verilated_${name} ${ARG_MODULE} SET ${ARG_SET} OPTIONS ${options})
  pipegs_verilated(verilated_${name}_waves ${ARG_MODULE} WAVES SET ${ARG_SET} OPTIONS ${options})
  add_executable(${name}_test ${ARG_SOURCE})
  target_precompile_headers(${name}_test REUSE_FROM unit_test_headers_O${level})
  add_executable(${name}_waves_test EXCLUDE_FROM_ALL ${ARG_SOURCE})
  foreach(variant ${name} ${name}_waves)
    target_compile_definitions(${variant}_test PRIVATE PIPEGS_SET="${set_text}")
    target_compile_options(${variant}_test PRIVATE -Wall -Wextra -O${level})
    target_link_libraries(${variant}_test PRIVATE verilated_${variant} pipegs_model pipegs_memory pipegs_test_main
                          fmt::fmt)
  endforeach()
  add_test(NAME ${name} COMMAND ${name}_test)
  set_tests_properties(${name} PROPERTIES SKIP_RETURN_CODE 77)
  if(NOT ARG_SET AND NOT ARG_PARAMETERS AND NOT ARG_RTL_ONLY)
    pipegs_netlist_test(${name} MODULE ${ARG_MODULE} SOURCE ${ARG_SOURCE})
  endif()
  if(ARG_LONG)
    pipegs_long(${name} TARGETS ${name}_test)
  elseif(again AND (ARG_SET OR ARG_PARAMETERS))
    pipegs_take_turns(${name} TARGETS ${name}_test)
  endif()
endfunction()

# pipegs_model_test(NAME): a GoogleTest of bit-accurate models alone, NAME_test.cpp, compiled as the unit tests are.
function(pipegs_model_test name)
  add_executable(${name}_test ${name}_test.cpp)
  target_precompile_headers(${name}_test REUSE_FROM unit_test_headers_O0)
  target_compile_definitions(${name}_test PRIVATE PIPEGS_SET="" VM_TRACE=0 VM_TRACE_FST=0)
  target_compile_options(${name}_test PRIVATE -Wall -Wextra -O0)
  target_link_libraries(${name}_test PRIVATE verilated_runtime pipegs_model pipegs_memory pipegs_test_main fmt::fmt)
  add_test(NAME ${name} COMMAND ${name}_test)
  set_tests_properties(${name} PROPERTIES SKIP_RETURN_CODE 77)
endfunction()

# pipegs_netlist_test(NAME MODULE module [SOURCE file] [DESIGN point] [BROKEN]): the same GoogleTest on the netlist of
# the module in a design point, without DESIGN the default configuration, as test netlist_NAME. The target `netlists`
# builds them, not `all`; the test netlists_build does. With BROKEN one gate of it is another, an or for an and, and
# the GoogleTest must fail.
function(pipegs_netlist_test name)
  cmake_parse_arguments(ARG "BROKEN" "MODULE;SOURCE;DESIGN" "" ${ARGN})
  if(NOT ARG_SOURCE)
    set(ARG_SOURCE ${name}_test.cpp)
  endif()
  if(NOT ARG_DESIGN)
    set(ARG_DESIGN dop)
  endif()
  pipegs_design_point(settings ${ARG_DESIGN})
  string(REGEX REPLACE "^default$" "" settings ${settings})
  string(REPLACE "," " " settings "${settings}")
  set_property(GLOBAL APPEND PROPERTY PIPEGS_NETLISTS ${ARG_DESIGN})
  set_property(GLOBAL APPEND PROPERTY PIPEGS_NETLISTS_${ARG_DESIGN} ${ARG_MODULE})
  set(netlist ${CMAKE_BINARY_DIR}/netlists/${ARG_DESIGN}/${ARG_MODULE}.v)
  if(ARG_BROKEN)
    set(whole ${netlist})
    set(netlist ${CMAKE_BINARY_DIR}/netlists/${name}.v)
    add_custom_command(OUTPUT ${netlist} COMMAND sed "0,/&/s//|/" ${whole} > ${netlist}
                       DEPENDS ${whole} netlist_files_${ARG_DESIGN} VERBATIM)
  endif()
  set(dir ${CMAKE_BINARY_DIR}/verilated/netlist_${name})
  set(gates ${dir}/V${ARG_MODULE}__all.cpp)
  add_custom_command(OUTPUT ${gates}
    COMMAND ${CMAKE_SOURCE_DIR}/sim/rtl/verilate.sh ${ARG_MODULE} ${dir} ${netlist}
    DEPENDS ${CMAKE_SOURCE_DIR}/sim/rtl/verilate.sh ${netlist} netlist_files_${ARG_DESIGN}
    COMMENT "Verilating the netlist of ${ARG_MODULE}" VERBATIM)
  add_executable(netlist_${name}_test EXCLUDE_FROM_ALL ${ARG_SOURCE} ${gates})
  target_include_directories(netlist_${name}_test SYSTEM PRIVATE ${dir})
  target_compile_definitions(netlist_${name}_test PRIVATE PIPEGS_SET="${settings}" VM_TRACE=0 VM_TRACE_FST=0)
  # -O0 compiles in a third of the time and runs a tenth as fast.
  target_compile_options(netlist_${name}_test PRIVATE -w -O1)
  target_link_libraries(netlist_${name}_test PRIVATE verilated_runtime pipegs_model pipegs_memory pipegs_test_main
                        fmt::fmt)
  add_dependencies(netlists netlist_${name}_test)
  add_test(NAME netlist_${name} COMMAND netlist_${name}_test)
  set_tests_properties(netlist_${name} PROPERTIES LABELS "long;netlist" FIXTURES_REQUIRED netlists)
  if(ARG_BROKEN)
    set_tests_properties(netlist_${name} PROPERTIES PASS_REGULAR_EXPRESSION "FAILED TEST")
  endif()
endfunction()

# pipegs_netlists(): behind the last pipegs_netlist_test: how their netlists are made, all of a design point in one run.
function(pipegs_netlists)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/rtl/*.sv)
  file(GLOB synth CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/synth/*.py)
  get_property(designs GLOBAL PROPERTY PIPEGS_NETLISTS)
  list(REMOVE_DUPLICATES designs)
  foreach(design ${designs})
    get_property(modules GLOBAL PROPERTY PIPEGS_NETLISTS_${design})
    list(REMOVE_DUPLICATES modules)
    set(folder ${CMAKE_BINARY_DIR}/netlists/${design})
    list(TRANSFORM modules REPLACE "(.+)" "${folder}/\\1.v" OUTPUT_VARIABLE files)
    add_custom_command(OUTPUT ${files} DEPENDS ${sources} ${synth} package_sv VERBATIM USES_TERMINAL
      COMMENT "Netlists of the units, ${design}"
      COMMAND ${CMAKE_SOURCE_DIR}/synth/synth.py --build ${CMAKE_BINARY_DIR} --design ${design} --netlist ${folder}
              ${modules})
    add_custom_target(netlist_files_${design} DEPENDS ${files})
  endforeach()
  add_test(NAME netlists_build COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR} --target netlists)
  set_tests_properties(netlists_build PROPERTIES LABELS "long;netlist" FIXTURES_SETUP netlists TIMEOUT 7200)
endfunction()
