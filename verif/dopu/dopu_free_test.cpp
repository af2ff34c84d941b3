// SPDX-License-Identifier: Apache-2.0
// dopu_free_test: a DOPU whose clock never stops asks and sends the same in the same cycles as one whose clock does.
//
// A slow memory and PUs that are seldom ready let it sleep for long; the phase of its box test must not depend on
// whether its clock counted these cycles, nor when planes are ready that are made again at the end of a frame.
#include "verif/dopu/dopu_bench.hpp"

namespace pipegs {
namespace {

struct Sent {
  std::vector<Chunk> chunks;
  std::vector<uint64_t> cycles, requests;  // in which each was taken, and each line asked for
  uint64_t end = 0, slept = 0;
};

Sent run(bool gated) {
  Dopu<GatedBench<Vpipegs_dopu>> dopu({.latency = 400, .jitter = 100});
  dopu.units.rare = 200;
  std::vector<uint64_t> requests;
  const Beside beside(dopu.bench, [&] {
    if (dopu.bench.dut.mem_valid_o && dopu.bench.dut.mem_ready_i) requests.push_back(dopu.bench.cycle);
  });
  // Of the last window a side closes again and again, so planes are under way whenever the frame ends.
  const Beside closing(
      dopu.bench, [] {},
      [&] {
        if (!dopu.config.occlusion) return;
        Open open{.known = 1, .window_x = 1, .window_y = 1};
        open.whole.left = dopu.bench.cycle / 40 % 15;
        write_record(dopu.config, dopu.bench.dut.open_i, open);
      });
  for (const size_t gaussians : {3000, 500, 400, 600, 700}) {
    if (gaussians == 400) dopu.units.rare = 0;  // from here on the last end is taken at once
    dopu.frame(World(dopu.bench.rng, gaussians, 200, 150), gated);
    for (int pause = 0; pause < 100; ++pause) gated ? dopu.bench.gated_step() : dopu.bench.step();
  }
  return {dopu.units.beats, dopu.units.cycles, requests, dopu.bench.cycle, dopu.bench.gated};
}

TEST(DopuFree, TakesTheCyclesOfOneThatSleeps) {
  const Sent sleeps = run(true), free = run(false);
  EXPECT_GT(sleeps.chunks.size(), 100u);
  EXPECT_GT(sleeps.slept, 1000u);
  EXPECT_EQ(free.chunks, sleeps.chunks);
  EXPECT_EQ(free.cycles, sleeps.cycles);
  EXPECT_EQ(free.requests, sleeps.requests);
  EXPECT_EQ(free.end, sleeps.end);
}

}  // namespace
}  // namespace pipegs
