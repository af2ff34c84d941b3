# SPDX-License-Identifier: Apache-2.0
# program_test.cmake: GoogleTests of C++ that contains no Verilated module of its own.

# Headers that nearly all of them read, compiled once. They run code that is optimised elsewhere: -O0 compiles in half
# the time.
add_executable(program_test_headers EXCLUDE_FROM_ALL ${PIPEGS_HEADERS_SOURCE})
target_compile_options(program_test_headers PRIVATE -Wall -Wextra -O0)
target_link_libraries(program_test_headers PRIVATE pipegs_sim pipegs_test_main)
target_precompile_headers(program_test_headers PRIVATE <gtest/gtest.h> <fmt/format.h> <nlohmann/json.hpp> <algorithm>
                          <filesystem> <fstream> <functional> <map> <random> <sstream>)

# pipegs_test(NAME [SOURCES file ...] [DEFINES ...] [LIBRARIES ...]): the test NAME, of NAME_test.cpp and pipegs_sim if
# nothing else is said.
function(pipegs_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEFINES;LIBRARIES" ${ARGN})
  if(NOT ARG_SOURCES)
    set(ARG_SOURCES ${name}_test.cpp)
  endif()
  if(NOT ARG_LIBRARIES)
    set(ARG_LIBRARIES pipegs_sim)
    if(CMAKE_CURRENT_SOURCE_DIR MATCHES "/sim/studies/")
      set(ARG_LIBRARIES pipegs_studies)
    endif()
  endif()
  add_executable(${name}_test ${ARG_SOURCES})
  target_compile_definitions(${name}_test PRIVATE ${ARG_DEFINES})
  target_compile_options(${name}_test PRIVATE -Wall -Wextra -O0)
  target_link_libraries(${name}_test PRIVATE ${ARG_LIBRARIES} pipegs_test_main)
  target_precompile_headers(${name}_test REUSE_FROM program_test_headers)
  add_test(NAME ${name} COMMAND ${name}_test)
  set_tests_properties(${name} PROPERTIES SKIP_RETURN_CODE 77)
endfunction()
