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

#include "cpp_model/areas/frame_areas.hpp"
#include "cpp_model/control/job.hpp"
#include "cpp_model/frame_setup.hpp"
#include "verif/top/state_check.hpp"
#include "verif/frame/scenes.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

class Listener final : public RtlTaps {
 public:
  explicit Listener(const Config& config)
      : config_(config), check_(config, false, [this](const StateCheck::Wrong& wrong) {
          ++wrong_;
          if (first_.empty())
            first_ = fmt::format("{}, cycle {}: expected {}, found {}", wrong.unit, wrong.cycle, wrong.expected,
                                 wrong.found);
        }) {}
  bool wants_cycles() const override { return true; }
  void on_cycle(uint64_t, const uint8_t* states) override { check_.on_cycle(cycle, states); }
  void on_border(const uint8_t* border) override { check_.on_border(border); }
  void on_chunk(int unit, int kind) override {
    if (kind != kData) check_.on_end(unit);
  }
  void on_layer_done(int unit, bool) override { check_.on_layer_done(unit); }
  void on_request(int tag, bool write, uint64_t, int lines) override { check_.on_request(tag, write, lines); }
  void on_pixels(int lane, int, int, const uint32_t*) override { check_.on_pixels(lane / config_.tap_lanes()); }

  void expect_none(const RtlResult& counters) {
    check_.finish(counters);
    EXPECT_EQ(wrong_, 0) << first_;
  }

 private:
  const Config& config_;
  StateCheck check_;
  int wrong_ = 0;
  std::string first_;
};

TEST(MachineStates, AreThoseOfTheBorders) {
  const Config config = test_config();
  const PackedScene packed = pack_scene(config, random_scene(3, 1500, 1), 1);
  const Frame frame = frame_setup(config, packed, test_camera(100, 70, 90), {}, 0.2);
  const Areas areas = frame_areas(config, packed, frame);
  ExternalMemory memory({.latency = 60, .jitter = 20}, config.bus_w);
  memory.load(memory_image(packed).lines, 0);
  memory.set_lines(frame.tables.overflow + areas.overflow);
  Listener taps(config);
  const std::unique_ptr<RtlModel> machine(pipegs_rtl_create(&config));
  taps.expect_none(machine->run({frame_job(config, frame, areas, {})}, memory, {}, &taps, {}));
}

}  // namespace
}  // namespace pipegs
