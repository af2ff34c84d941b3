// SPDX-License-Identifier: Apache-2.0
// runtime.cpp: what Verilator calls when a module stops the simulation: a failed assertion becomes an exception that
// GoogleTest and the harness can report, instead of the end of the program.
#include <verilated.h>

#include <string>

#include "sim/rtl/rtl_fault.hpp"

void vl_stop(const char* filename, int linenum, const char* hier) VL_MT_UNSAFE {
  throw pipegs::RtlFault(std::string(filename) + ":" + std::to_string(linenum) + ": assertion failed in " + hier);
}
