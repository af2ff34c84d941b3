// runtime.cpp: what Verilator calls when a module stops the simulation: a failed assertion becomes an exception that
// GoogleTest and the harness can report, instead of the end of the program.
#include <verilated.h>

#include <stdexcept>
#include <string>

void vl_stop(const char* filename, int linenum, const char* hier) VL_MT_UNSAFE {
  throw std::runtime_error(std::string(filename) + ":" + std::to_string(linenum) + ": assertion failed in " + hier);
}
