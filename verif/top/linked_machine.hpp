// SPDX-License-Identifier: Apache-2.0
// linked_machine.hpp: frames in the machine that is linked into a test, all compared.
//
// Idea    Such a test has the machine as it is simulated, pipegs_sim, Verilated as any module is
//         (pipegs_linked_machine in CMakeLists.txt), clocked by the loop that clocks all machines. SequenceCheck holds
//         streams, pixels, requests and what units say that they do.
// Use     run_linked(*machine, options, {&first, &second}) after simulate_golden; frames of one scene, equally large.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "cpp_model/areas/frame_areas.hpp"
#include "cpp_model/control/job.hpp"
#include "sim/compare/sequence_check.hpp"

namespace pipegs {

inline RtlResult run_linked(RtlModel& machine, const SimulateOptions& options, const std::vector<Simulation*>& frames,
                            const RtlOptions& rtl = {}, RtlTaps* taps = nullptr) {
  const PackedScene& packed = *frames.front()->input.packed;
  std::vector<SequenceCheck::Expected> expected;
  uint64_t overflow = 0;  // one place for all
  for (const Simulation* one : frames) {
    const GoldenInput& input = one->input;
    expected.push_back({&input, &one->golden, frame_areas(options.config, packed, input.frame, input.picture)});
    overflow = std::max(overflow, expected.back().areas.overflow);
  }
  std::vector<pipegs_job> jobs;
  for (SequenceCheck::Expected& one : expected) {
    one.areas.overflow = overflow;
    jobs.push_back(frame_job(options.config, one.input->frame, one.areas, one.input->picture));
  }
  ExternalMemory memory(options.memory, options.config.bus_w);
  memory.load(memory_image(packed).lines, 0);
  memory.set_lines(frames.front()->input.frame.tables.overflow + overflow);
  SequenceCheck check(expected, memory, taps);
  const RtlResult result = machine.run(jobs, memory, rtl, &check, {});
  check.finish(result);
  EXPECT_EQ(check.complete(), frames.size());
  for (size_t i = 0; i < frames.size(); ++i)
    EXPECT_EQ(check.frame(i).mismatches(), 0u) << "frame " << i << ": " << check.frame(i).first()->line();
  return result;
}

}  // namespace pipegs
