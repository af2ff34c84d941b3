# SPDX-License-Identifier: Apache-2.0
# verilate.cmake: Verilated modules as CMake targets, all through sim/rtl/verilate.sh.

execute_process(COMMAND sh -c "verilator -V | sed -n 's/^ *VERILATOR_ROOT *= //p' | grep -v '^$' | tail -n 1"
                OUTPUT_VARIABLE VERILATOR_ROOT OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT VERILATOR_ROOT)
  set(VERILATOR_ROOT /usr/share/verilator)
endif()

# What every Verilated program links: compiled once.
add_library(verilated_runtime STATIC ${VERILATOR_ROOT}/include/verilated.cpp
            ${VERILATOR_ROOT}/include/verilated_threads.cpp ${CMAKE_SOURCE_DIR}/sim/rtl/runtime.cpp)
target_include_directories(verilated_runtime PRIVATE ${CMAKE_SOURCE_DIR})
target_include_directories(verilated_runtime SYSTEM PUBLIC ${VERILATOR_ROOT}/include ${VERILATOR_ROOT}/include/vltstd)
target_compile_definitions(verilated_runtime PUBLIC VL_USER_STOP VM_COVERAGE=0 VM_SC=0 VM_TRACE_VCD=0)
target_compile_options(verilated_runtime PUBLIC -faligned-new PRIVATE -w)
target_link_libraries(verilated_runtime PUBLIC Threads::Threads z atomic)

# The headers of Verilated C++, compiled once. A target that only compiles headers ahead has this source.
set(PIPEGS_HEADERS_SOURCE ${CMAKE_BINARY_DIR}/generated/main.cpp)
file(CONFIGURE OUTPUT ${PIPEGS_HEADERS_SOURCE} CONTENT "int main() {}\n")
add_library(verilated_headers OBJECT EXCLUDE_FROM_ALL ${PIPEGS_HEADERS_SOURCE})
target_compile_definitions(verilated_headers PRIVATE VM_TRACE=0 VM_TRACE_FST=0)
target_compile_options(verilated_headers PRIVATE -w -O1)
target_link_libraries(verilated_headers PRIVATE verilated_runtime)
target_precompile_headers(verilated_headers PRIVATE <verilated.h>)

# What writes waves, linked by the programs that do.
add_library(verilated_waves STATIC EXCLUDE_FROM_ALL ${VERILATOR_ROOT}/include/verilated_fst_c.cpp)
target_compile_definitions(verilated_waves PUBLIC VM_TRACE=1 VM_TRACE_FST=1)
target_compile_options(verilated_waves PRIVATE -w -O1)
target_link_libraries(verilated_waves PUBLIC verilated_runtime)

# pipegs_package(OUT key=value ...): the path of a pipegs_pkg.sv for this configuration, made at build time.
function(pipegs_package out)
  string(REPLACE ";" "," key "${ARGN}")
  string(MAKE_C_IDENTIFIER "package_${key}" name)
  string(LENGTH ${name} length)
  if(length GREATER 200)  # no file system takes more than 255 bytes
    string(MD5 hash ${name})
    string(SUBSTRING ${name} 0 160 name)
    string(APPEND name _${hash})
  endif()
  set(file ${CMAKE_BINARY_DIR}/packages/${name}/pipegs_pkg.sv)
  if(NOT TARGET ${name})
    file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/packages/${name})
    add_custom_command(OUTPUT ${file} COMMAND package_sv ${ARGN} > ${file} DEPENDS package_sv)
    add_custom_target(${name} DEPENDS ${file})
  endif()
  set(${out} ${file} PARENT_SCOPE)
  set(${out}_target ${name} PARENT_SCOPE)
endfunction()

# pipegs_verilated(NAME MODULE [WAVES] [SET key=value ...] [OPTIONS option ...]): a static library with the Verilated
# module, built when a target needs it; with WAVES its waves can be written. OPTIONS go to Verilator. In it
# pipegs_stream_check compares beats.
function(pipegs_verilated name module)
  cmake_parse_arguments(ARG "WAVES" "" "SET;OPTIONS" ${ARGN})
  pipegs_package(package ${ARG_SET})
  set(dir ${CMAKE_BINARY_DIR}/verilated/${name})
  if(ARG_WAVES)
    set(sources ${dir}/V${module}__shard0.cpp ${dir}/V${module}__once.cpp)
    set(options 1 --trace-fst)
  else()
    set(sources ${dir}/V${module}__all.cpp)
    set(options 0)
  endif()
  add_custom_command(OUTPUT ${sources}
    COMMAND ${CMAKE_SOURCE_DIR}/sim/rtl/verilate.sh ${module} ${dir} ${package} ${options}
            -DPIPEGS_BEATS ${ARG_OPTIONS}
    DEPENDS ${CMAKE_SOURCE_DIR}/sim/rtl/verilate.sh ${package} ${package_target} DEPFILE ${dir}/depends.d
    COMMENT "Verilating ${module} (${name})" VERBATIM COMMAND_EXPAND_LISTS)
  add_library(${name} STATIC EXCLUDE_FROM_ALL ${sources})
  target_include_directories(${name} SYSTEM PUBLIC ${dir})
  target_compile_options(${name} PRIVATE -w -O1)
  if(ARG_WAVES)
    set_source_files_properties(${dir}/V${module}__once.cpp PROPERTIES COMPILE_OPTIONS -O0)
    target_link_libraries(${name} PUBLIC verilated_waves)
  else()
    target_compile_definitions(${name} PUBLIC VM_TRACE=0 VM_TRACE_FST=0)
    target_link_libraries(${name} PUBLIC verilated_runtime)
    target_precompile_headers(${name} REUSE_FROM verilated_headers)
  endif()
endfunction()
