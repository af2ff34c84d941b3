// SPDX-License-Identifier: Apache-2.0
// machine_test: a small machine, so that mutation tests reach modules that only whole frames cover.
//
// Idea    A mutant of any module takes its place in the machine that is linked here. What it changes of streams,
//         pixels, requests or states, or of the cycles that the timing model says, is seen. Behind a fast memory units
//         wait for each other, behind a slow one they sleep.
#include <gtest/gtest.h>

#include <memory>

#include "sim/timing/timing_model.hpp"
#include "sim/timing/trace/trace.hpp"
#include "verif/frame/scenes.hpp"
#include "verif/support/config.hpp"
#include "verif/top/linked_machine.hpp"

namespace pipegs {
namespace {

// How often frames were given up.
class GiveUps final : public RtlTaps {
 public:
  void on_give_up() override { ++count; }
  int count = 0;
};

class Machine : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    options_.config = test_config();
    options_.memory = {.latency = GetParam(), .jitter = GetParam() / 3};
    simulate_golden(random_scene(3, 1500, 1), test_camera(100, 70, 90), options_, first_);
    simulate_frame(first_.packed, test_camera(100, 70, 60), options_, second_);
    simulate_golden(options_, second_);
    machine_.reset(pipegs_rtl_create(&options_.config));
  }

  SimulateOptions options_;
  Simulation first_, second_;
  std::unique_ptr<RtlModel> machine_;
};

TEST_P(Machine, DrawsAndTakesWhatItsModelsSay) {
  const TimingResult model = timing_run(timing_trace(first_.input), options_.config, options_.memory);
  EXPECT_EQ(run_linked(*machine_, options_, {&first_}).cycles, model.cycles);
}

TEST_P(Machine, DrawsAFrameBehindAnother) { run_linked(*machine_, options_, {&first_, &second_}); }

TEST_P(Machine, BeginsAnewWhatWasAborted) {
  GiveUps given_up;
  run_linked(*machine_, options_, {&first_, &second_}, {.disturbances = {{0, 900}, {1, 4000}}}, &given_up);
  EXPECT_EQ(given_up.count, 2);
}

INSTANTIATE_TEST_SUITE_P(Latency, Machine, testing::Values(2, 60, 300));

}  // namespace
}  // namespace pipegs
