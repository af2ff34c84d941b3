// SPDX-License-Identifier: Apache-2.0
// dopu_free_test: a DOPU whose clock never stops asks and sends the same in the same cycles as one whose clock does.
//
// A slow memory and PUs that are seldom ready let it sleep for long; the phase of its box test must not depend on
// whether its clock counted these cycles.
#include "verif/dopu/dopu_bench.hpp"

namespace pipegs {
namespace {

struct Sent {
  std::vector<Chunk> chunks;
  std::vector<uint64_t> cycles, requests;  // in which each was taken, and each line asked for
  uint64_t end = 0, slept = 0;
};

struct Requests : Endpoint {
  explicit Requests(Bench<Vpipegs_dopu>& b) : bench(b) { b.add(*this); }
  void drive() override {}
  void observe() override {
    if (bench.dut.mem_valid_o && bench.dut.mem_ready_i) cycles.push_back(bench.cycle);
  }
  Bench<Vpipegs_dopu>& bench;
  std::vector<uint64_t> cycles;
};

Sent run(bool gated) {
  GatedBench<Vpipegs_dopu> bench;
  const Config config = test_config();
  bench.dut.start_i = 0;
  no_feedback(bench);
  ExternalMemory memory({.latency = 400, .jitter = 100});
  Units units(bench, config, Pace::kAlways);
  units.rare = 200;
  Memory port(bench, memory, bench.dut.mem_valid_o, bench.dut.mem_ready_i, nullptr, bench.dut.mem_address_o, nullptr,
              bench.dut.rsp_valid_i, bench.dut.rsp_data_i, Pace::kAlways, &bench.dut.mem_lines_o);
  Requests requests(bench);
  bench.reset();
  for (const size_t gaussians : {3000, 500}) {
    const World world(bench.rng, gaussians, 200, 150);
    world.load(memory);
    start(bench, world);
    const auto done = [&] { return !bench.dut.busy_o; };
    EXPECT_TRUE(gated ? bench.run_gated_until(done, 3000000) : bench.run_until(done, 3000000));
  }
  return {units.beats, units.cycles, requests.cycles, bench.cycle, bench.gated};
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
