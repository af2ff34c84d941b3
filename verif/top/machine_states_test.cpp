// SPDX-License-Identifier: Apache-2.0
// machine_states_test: a small machine in which every unit says what it does: mutation tests plant faults in what it
// says.
//
// Idea    The machine as it is simulated, pipegs_sim, Verilated as any module is, so that a mutant of a unit takes its
//         place; clocked by the loop that clocks all machines, and held against its borders by StateCheck, without a
//         golden model: what it draws, other tests see.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "cpp_model/areas/frame_areas.hpp"
#include "cpp_model/control/job.hpp"
#include "cpp_model/frame_setup.hpp"
#include "sim/compare/state_check.hpp"
#include "verif/frame/scenes.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

TEST(MachineStates, AreThoseOfTheBorders) {
  const Config config = test_config();
  const PackedScene packed = pack_scene(config, random_scene(3, 1500, 1), 1);
  const Frame frame = frame_setup(config, packed, test_camera(100, 70, 90), {}, 0.2);
  const Areas areas = frame_areas(config, packed, frame);
  ExternalMemory memory({.latency = 60, .jitter = 20}, config.bus_w);
  memory.load(memory_image(packed).lines, 0);
  memory.set_lines(frame.tables.overflow + areas.overflow);
  std::vector<std::string> wrong;
  StateCheck taps(config, false, [&](const StateCheck::Wrong& one) {
    wrong.push_back(fmt::format("{}, cycle {}: expected {}, found {}", one.unit, one.cycle, one.expected, one.found));
  });
  const std::unique_ptr<RtlModel> machine(pipegs_rtl_create(&config));
  taps.finish(machine->run({frame_job(config, frame, areas, {})}, memory, {}, &taps, {}));
  EXPECT_TRUE(wrong.empty()) << wrong.size() << ", the first: " << wrong.front();
}

}  // namespace
}  // namespace pipegs
