// SPDX-License-Identifier: Apache-2.0
// pu_stage: runs one stage of the projection against its bit-accurate model: records in order, at every pair of paces,
// and the pace itself.
#pragma once

#include <vector>

#include "cpp_model/records.hpp"
#include "verif/pu/pu_random.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "verif/support/frame_ports.hpp"

namespace pipegs {

// A stage by its module and the names of its two streams: PIPEGS_STAGE(pu_orient, Projected, projected, Oriented,
// oriented).
#define PIPEGS_STAGE(module, In, in, Out, out)                                  \
  struct Stage {                                                                \
    using Dut = V##module;                                                      \
    using Input = In;                                                           \
    using Output = Out;                                                         \
    static auto source(Bench<Dut>& b, const Config& c, Pace pace) {             \
      return RecordSource<In, std::remove_reference_t<decltype(b.dut.in##_i)>>( \
          b, c, b.dut.in##_valid_i, b.dut.in##_ready_o, b.dut.in##_i, pace);    \
    }                                                                           \
    static auto sink(Bench<Dut>& b, const Config& c, Pace pace) {               \
      return RecordSink<Out, std::remove_reference_t<decltype(b.dut.out##_o)>>( \
          b, c, b.dut.out##_valid_o, b.dut.out##_ready_i, b.dut.out##_o, pace); \
    }                                                                           \
  }

// The records of one frame and what the model makes of them.
template <class Stage>
struct StageRun {
  Frame frame;
  std::vector<typename Stage::Input> inputs;
  std::vector<typename Stage::Output> expected;
};

// Compares in order; gives the cycles in which the output was taken, counted from the first input.
template <class Stage>
std::vector<uint64_t> check_run(const Config& config, const StageRun<Stage>& run, Pace source_pace, Pace sink_pace) {
  Bench<typename Stage::Dut> bench;
  write_frame(config, bench.dut, run.frame);
  auto source = Stage::source(bench, config, source_pace);
  auto sink = Stage::sink(bench, config, sink_pace);
  bench.reset();
  const uint64_t start = bench.cycle;
  for (const auto& input : run.inputs) source.push(input);
  bench.run_until([&] { return sink.size() >= run.expected.size() && source.empty(); }, 200 * (run.inputs.size() + 1));
  for (int i = 0; i < 20; ++i) bench.step();
  EXPECT_EQ(sink.size(), run.expected.size());
  EXPECT_EQ(bench.dut.busy_o, 0) << "busy, but empty";
  for (size_t i = 0; i < std::min(sink.size(), run.expected.size()); ++i) {
    const auto found = sink.at(i);
    if (found == run.expected[i]) continue;
    ADD_FAILURE() << "beat " << i << ", cycle " << sink.cycles[i] << ", " << to_text(source_pace) << " to "
                  << to_text(sink_pace) << ", seed " << bench.seed << ": "
                  << first_difference(config, run.expected[i], found) << "\nexpected "
                  << to_text(config, run.expected[i]);
    break;
  }
  std::vector<uint64_t> cycles = sink.cycles;
  for (uint64_t& cycle : cycles) cycle -= start;
  return cycles;
}

// make_run(random, count): a StageRun of about so many records. One frame for each pair of paces.
template <class Stage, class MakeRun>
void check_every_pace(MakeRun&& make_run) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  for (const Pace source_pace : kPaces) {
    for (const Pace sink_pace : kPaces) {
      check_run<Stage>(config, make_run(random, 300), source_pace, sink_pace);
      if (testing::Test::HasFailure()) return;
    }
  }
  for (int i = 0; i < 20; ++i) {  // many cameras
    check_run<Stage>(config, make_run(random, 400), Pace::kAlways, Pace::kAlways);
    if (testing::Test::HasFailure()) return;
  }
}

// The first output after `latency` cycles, then one every `pace`, when neither side waits.
template <class Stage, class MakeRun>
void check_pace(MakeRun&& make_run, uint64_t latency, uint64_t pace = 8) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  const std::vector<uint64_t> cycles = check_run<Stage>(config, make_run(random, 100), Pace::kAlways, Pace::kAlways);
  ASSERT_GT(cycles.size(), 1u);
  EXPECT_EQ(cycles.front(), latency);
  EXPECT_EQ(cycles.back() - cycles.front(), pace * (cycles.size() - 1));
}

// A run whose inputs come from make(random, frame) and whose outputs are the model's; one beat in ten is
// an end.
template <class Stage, class Make, class Model>
auto stage_run(Make&& make, Model&& model) {
  return [=](PuRandom& random, int count) {
    StageRun<Stage> run;
    run.frame = random.frame();
    for (int i = 0; i < count; ++i) {
      run.inputs.push_back(make(random, run.frame));
      if (random.chance(10)) {
        run.inputs.push_back(random_record<typename Stage::Input>(random.config, random.rng));
        run.inputs.back().kind = random.chance(3) ? kWindowEnd : kLayerEnd;
      }
    }
    for (const auto& input : run.inputs) run.expected.push_back(model(random.config, run.frame, input));
    return run;
  };
}

}  // namespace pipegs
