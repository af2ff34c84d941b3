// SPDX-License-Identifier: Apache-2.0
// waves.hpp: the waves of a unit test, and the command that replays a failed one with them.
//
// Idea    Waves are three quarters of the C++ that Verilator writes, so NAME_test has none. NAME_waves_test is the same
//         test with waves; only who replays a failure builds it. PIPEGS_WAVES=FILE.fst says where they go.
#pragma once

#include <gtest/gtest.h>
#include <verilated.h>
#if VM_TRACE
#include <verilated_fst_c.h>
#endif

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace pipegs {

template <class Dut>
class UnitWaves {
 public:
#if VM_TRACE
  UnitWaves(VerilatedContext& context, Dut& dut) {
    const char* file = std::getenv("PIPEGS_WAVES");
    if (file == nullptr) return;
    context.traceEverOn(true);
    dut.trace(&file_, 99);
    file_.open(file);
  }
  ~UnitWaves() {
    if (file_.isOpen()) file_.close();
  }
  void dump(uint64_t time) {
    if (file_.isOpen()) file_.dump(time);
  }

 private:
  VerilatedFstC file_;
#else
  UnitWaves(VerilatedContext&, Dut&) {
    if (std::getenv("PIPEGS_WAVES") != nullptr) throw std::runtime_error("waves are written by NAME_waves_test");
  }
  void dump(uint64_t) {}
#endif
};

// Prints the two commands: the program's path is BUILD/verif/ROOM/NAME_test, its target the last part of it.
inline void print_replay(uint64_t seed) {
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  std::string name = program.filename().string();
  if (const size_t end = name.rfind("_test"); end != std::string::npos && !name.ends_with("_waves_test")) {
    name.insert(end, "_waves");
  }
  std::fprintf(stderr,
               "replay with waves: cmake --build %s --target %s && PIPEGS_SEED=%llu PIPEGS_WAVES=/tmp/%s.fst %s "
               "--gtest_filter=%s.%s\n",
               program.parent_path().parent_path().parent_path().c_str(), name.c_str(),
               static_cast<unsigned long long>(seed), test->name(), (program.parent_path() / name).c_str(),
               test->test_suite_name(), test->name());
}

}  // namespace pipegs
