# verilate.cmake: Verilated modules as CMake targets, all through sim/verilate.sh.

execute_process(COMMAND sh -c "verilator -V | sed -n 's/^ *VERILATOR_ROOT *= //p' | grep -v '^$' | tail -n 1"
                OUTPUT_VARIABLE VERILATOR_ROOT OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT VERILATOR_ROOT)
  set(VERILATOR_ROOT /usr/share/verilator)
endif()

# What every Verilated program links: compiled once.
add_library(verilated_runtime STATIC ${VERILATOR_ROOT}/include/verilated.cpp ${VERILATOR_ROOT}/include/verilated_fst_c.cpp
            ${VERILATOR_ROOT}/include/verilated_threads.cpp ${CMAKE_SOURCE_DIR}/verif/support/runtime.cpp)
target_include_directories(verilated_runtime SYSTEM PUBLIC ${VERILATOR_ROOT}/include ${VERILATOR_ROOT}/include/vltstd)
target_compile_definitions(verilated_runtime PUBLIC VL_USER_STOP VM_COVERAGE=0 VM_SC=0 VM_TRACE=1 VM_TRACE_FST=1 VM_TRACE_VCD=0)
target_compile_options(verilated_runtime PUBLIC -faligned-new PRIVATE -w)
target_link_libraries(verilated_runtime PUBLIC Threads::Threads z atomic)

# pipegs_package(OUT key=value ...): the path of a pipegs_pkg.sv for this configuration, made at build time.
function(pipegs_package out)
  string(REPLACE ";" "," key "${ARGN}")
  string(MAKE_C_IDENTIFIER "package_${key}" name)
  set(file ${CMAKE_BINARY_DIR}/packages/${name}/pipegs_pkg.sv)
  if(NOT TARGET ${name})
    file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/packages/${name})
    add_custom_command(OUTPUT ${file} COMMAND package_sv ${ARGN} > ${file} DEPENDS package_sv)
    add_custom_target(${name} DEPENDS ${file})
  endif()
  set(${out} ${file} PARENT_SCOPE)
  set(${out}_target ${name} PARENT_SCOPE)
endfunction()

# pipegs_verilated(NAME MODULE [SET key=value ...]): a static library with the Verilated module.
function(pipegs_verilated name module)
  cmake_parse_arguments(ARG "" "SHARDS" "SET" ${ARGN})
  if(NOT ARG_SHARDS)
    set(ARG_SHARDS 1)
  endif()
  pipegs_package(package ${ARG_SET})
  set(dir ${CMAKE_BINARY_DIR}/verilated/${name})
  set(shards "")
  math(EXPR last "${ARG_SHARDS} - 1")
  foreach(i RANGE ${last})
    list(APPEND shards ${dir}/V${module}__shard${i}.cpp)
  endforeach()
  add_custom_command(OUTPUT ${shards}
    COMMAND ${CMAKE_SOURCE_DIR}/sim/verilate.sh ${module} ${dir} ${package} ${ARG_SHARDS}
    DEPENDS ${CMAKE_SOURCE_DIR}/sim/verilate.sh ${package} ${package_target} DEPFILE ${dir}/depends.d
    COMMENT "Verilating ${module} (${name})" VERBATIM)
  add_library(${name} STATIC ${shards})
  target_include_directories(${name} SYSTEM PUBLIC ${dir})
  target_compile_options(${name} PRIVATE -w -O1)
  target_link_libraries(${name} PUBLIC verilated_runtime)
endfunction()

# pipegs_unit_test(NAME MODULE module [SOURCE file] [RTL_ONLY] [SET key=value ...]): a GoogleTest of one module against its twin.
# The test sees the configuration as PIPEGS_SET, a string for pipegs::test_config(). In the default configuration it is a test
# of the module's netlist too, unless RTL_ONLY says that there is none.
function(pipegs_unit_test name)
  cmake_parse_arguments(ARG "RTL_ONLY" "MODULE;SOURCE" "SET" ${ARGN})
  if(NOT ARG_SOURCE)
    set(ARG_SOURCE ${name}_test.cpp)
  endif()
  pipegs_verilated(verilated_${name} ${ARG_MODULE} SET ${ARG_SET})
  add_executable(${name}_test ${ARG_SOURCE})
  string(REPLACE ";" " " set_text "${ARG_SET}")
  target_compile_definitions(${name}_test PRIVATE PIPEGS_SET="${set_text}")
  target_compile_options(${name}_test PRIVATE -Wall -Wextra -O1)
  target_link_libraries(${name}_test PRIVATE verilated_${name} pipegs_model pipegs_memory GTest::gtest_main fmt::fmt)
  add_test(NAME ${name} COMMAND ${name}_test)
  if(NOT ARG_SET AND NOT ARG_RTL_ONLY)
    pipegs_netlist_test(${name} MODULE ${ARG_MODULE} SOURCE ${ARG_SOURCE})
  endif()
endfunction()

# pipegs_netlist_test(NAME MODULE module [SOURCE file] [BROKEN]): the same GoogleTest on the netlist of the module, as test
# netlist_NAME. The target `netlists` builds them, not `all`; the test netlists_build does. With BROKEN one gate of it is
# another, an or for an and, and the GoogleTest must fail.
function(pipegs_netlist_test name)
  cmake_parse_arguments(ARG "BROKEN" "MODULE;SOURCE" "" ${ARGN})
  if(NOT ARG_SOURCE)
    set(ARG_SOURCE ${name}_test.cpp)
  endif()
  set_property(GLOBAL APPEND PROPERTY PIPEGS_NETLISTS ${ARG_MODULE})
  set(netlist ${CMAKE_BINARY_DIR}/netlists/${ARG_MODULE}.v)
  if(ARG_BROKEN)
    set(whole ${netlist})
    set(netlist ${CMAKE_BINARY_DIR}/netlists/${name}.v)
    add_custom_command(OUTPUT ${netlist} COMMAND sed "0,/&/s//|/" ${whole} > ${netlist} DEPENDS ${whole} netlist_files VERBATIM)
  endif()
  set(dir ${CMAKE_BINARY_DIR}/verilated/netlist_${name})
  add_custom_command(OUTPUT ${dir}/V${ARG_MODULE}__shard0.cpp
    COMMAND ${CMAKE_SOURCE_DIR}/sim/verilate.sh ${ARG_MODULE} ${dir} ${netlist}
    DEPENDS ${CMAKE_SOURCE_DIR}/sim/verilate.sh ${netlist} netlist_files COMMENT "Verilating the netlist of ${ARG_MODULE}" VERBATIM)
  add_executable(netlist_${name}_test EXCLUDE_FROM_ALL ${ARG_SOURCE} ${dir}/V${ARG_MODULE}__shard0.cpp)
  target_include_directories(netlist_${name}_test SYSTEM PRIVATE ${dir})
  target_compile_definitions(netlist_${name}_test PRIVATE PIPEGS_SET="")
  target_compile_options(netlist_${name}_test PRIVATE -w -O1)  # -O0 compiles in a third of the time and runs a tenth as fast
  target_link_libraries(netlist_${name}_test PRIVATE verilated_runtime pipegs_model pipegs_memory GTest::gtest_main fmt::fmt)
  add_dependencies(netlists netlist_${name}_test)
  add_test(NAME netlist_${name} COMMAND netlist_${name}_test)
  set_tests_properties(netlist_${name} PROPERTIES LABELS "long;netlist" FIXTURES_REQUIRED netlists)
  if(ARG_BROKEN)
    set_tests_properties(netlist_${name} PROPERTIES PASS_REGULAR_EXPRESSION "FAILED TEST")
  endif()
endfunction()

# pipegs_netlists(): behind the last pipegs_netlist_test: how their netlists are made, all in one run.
function(pipegs_netlists)
  get_property(modules GLOBAL PROPERTY PIPEGS_NETLISTS)
  list(REMOVE_DUPLICATES modules)
  list(TRANSFORM modules REPLACE "(.+)" "${CMAKE_BINARY_DIR}/netlists/\\1.v" OUTPUT_VARIABLE files)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/rtl/*.sv)
  file(GLOB synth CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/synth/*.py)
  add_custom_command(OUTPUT ${files} DEPENDS ${sources} ${synth} package_sv VERBATIM USES_TERMINAL COMMENT "Netlists of the units"
    COMMAND ${CMAKE_SOURCE_DIR}/synth/synth.py --build ${CMAKE_BINARY_DIR} --netlist ${CMAKE_BINARY_DIR}/netlists ${modules})
  add_custom_target(netlist_files DEPENDS ${files})
  add_test(NAME netlists_build COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR} --target netlists)
  set_tests_properties(netlists_build PROPERTIES LABELS "long;netlist" FIXTURES_SETUP netlists TIMEOUT 7200)
endfunction()
