# SPDX-License-Identifier: Apache-2.0
# design_points.cmake: the settings of design points for who builds machines, read from design_points.def.
set(PIPEGS_DESIGN_POINTS ${CMAKE_CURRENT_LIST_DIR}/design_points.def)

# pipegs_design_point(OUT NAME): "key=value,..." or "default" as config_difference() says it, the name of the folder in
# which the program looks for the machine.
function(pipegs_design_point out name)
  file(READ ${PIPEGS_DESIGN_POINTS} text)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PIPEGS_DESIGN_POINTS})
  if(NOT text MATCHES "PIPEGS_POINT\\(${name},.*PIPEGS_END\\(${name}\\)")
    message(FATAL_ERROR "${PIPEGS_DESIGN_POINTS}: no design point ${name}")
  endif()
  string(REGEX MATCHALL "PIPEGS_(SETTING|PICTURE)\\([a-z_]+, [0-9]+\\)" settings "${CMAKE_MATCH_0}")
  list(TRANSFORM settings REPLACE "PIPEGS_[A-Z]+\\(([a-z_]+), ([0-9]+)\\)" "\\1=\\2")
  list(JOIN settings "," difference)
  if(difference STREQUAL "")
    set(difference default)
  endif()
  set(${out} ${difference} PARENT_SCOPE)
endfunction()

# pipegs_design_points(OUT): their names, in the order of the table.
function(pipegs_design_points out)
  file(STRINGS ${PIPEGS_DESIGN_POINTS} names REGEX "^PIPEGS_POINT")
  list(TRANSFORM names REPLACE "PIPEGS_POINT.([a-z_]+),.*" "\\1")
  set(${out} ${names} PARENT_SCOPE)
endfunction()

# pipegs_machine(TARGET DIFFERENCE): builds the RTL of this configuration where the program looks for it.
function(pipegs_machine target difference)
  set(settings)
  if(NOT difference STREQUAL default)
    string(REPLACE "," ";" settings ${difference})
  endif()
  add_custom_target(${target} ALL
    COMMAND ${CMAKE_SOURCE_DIR}/sim/rtl/build_rtl.sh ${CMAKE_BINARY_DIR} ${CMAKE_BINARY_DIR}/rtl/${difference}
            ${settings}
    DEPENDS package_sv pipegs_memory pipegs_dram pipegs_model verilated_runtime
    COMMENT "RTL, ${difference}" VERBATIM)
endfunction()
