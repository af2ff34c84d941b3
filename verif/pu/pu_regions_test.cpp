// SPDX-License-Identifier: Apache-2.0
// pu_regions_test: rtl/pu/pu_regions.sv: regions as the models of its stages give them, and beside each Gaussian its
// own payload, also when others die beside one that walks, and when nothing is taken for a long time.
#include "Vpu_regions.h"
#include "cpp_model/pu/conic/pu_coeff.hpp"
#include "cpp_model/pu/conic/pu_intersect.hpp"
#include "verif/pu/random_splat.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

// One Gaussian in `living` may have a region, the others lie far away. `halts`: now and then nothing is taken for long.
void run(Pace source_pace, Pace sink_pace, unsigned living, bool halts) {
  const Config config = test_config();
  Bench<Vpu_regions> bench;
  auto& dut = bench.dut;
  RecordSource<Conic, decltype(dut.conic_i)> in(bench, config, dut.conic_valid_i, dut.conic_ready_o, dut.conic_i,
                                                source_pace);
  RecordSink<Tiles, decltype(dut.tiles_o)> out(bench, config, dut.tiles_valid_o, dut.tiles_ready_i, dut.tiles_o,
                                               sink_pace);
  std::vector<Tiles> expected;
  std::vector<uint32_t> own, payloads, shown;  // shown: beside the tiles that are taken
  size_t put = 0, taken = 0;
  bool halted = false;  // nothing is taken
  // Payloads come as early as pu_project may put them: at most ShapePlaces Gaussians lie between it and the output of
  // pu_conic.
  const Beside beside(
      bench,
      [&] {
        put += dut.payload_valid_i;
        if (dut.conic_valid_i && dut.conic_ready_o) taken += read_record<Conic>(config, dut.conic_i).kind == kData;
        if (dut.tiles_valid_o && dut.tiles_ready_i) shown.push_back(dut.payload_o);
      },
      [&] {
        dut.payload_valid_i = put < payloads.size() && put < taken + static_cast<size_t>(config.shape_places());
        dut.payload_i = dut.payload_valid_i ? payloads[put] : static_cast<uint32_t>(bench.rng());
        if (halted) dut.tiles_ready_i = 0;
      });
  for (int i = 0; i < 1500; ++i) {
    Covariance covariance = random_covariance(config, bench.rng);
    if (covariance.kind == kData && bench.rng() % living != 0)
      covariance.mean_x = (int64_t{1} << (config.mean_w() - 1)) - 1, covariance.opacity = 0;
    const Conic conic = pu_conic(config, Frame{}, covariance);
    const Tiles tiles = pu_intersect(config, Frame{}, pu_coeff(config, Frame{}, conic));
    in.push(conic);
    const auto payload = static_cast<uint32_t>(bench.rng());
    if (conic.kind == kData) payloads.push_back(payload);
    if (tiles.kind == kData && tiles.mask == 0) continue;
    expected.push_back(tiles);
    own.push_back(tiles.kind == kData ? payload : 0);
  }
  bench.reset();
  while (halts && !in.empty()) {
    for (uint64_t i = bench.rng() % 200; i > 0; --i) bench.step();
    halted = true;
    for (uint64_t i = bench.rng() % 1000; i > 0; --i) bench.step();
    halted = false;
  }
  ASSERT_TRUE(bench.run_until([&] { return out.size() >= expected.size() && in.empty(); }, 2000000));
  for (int i = 0; i < 100; ++i) bench.step();
  ASSERT_EQ(out.size(), expected.size());
  for (size_t i = 0; i < expected.size(); ++i) {
    ASSERT_EQ(first_difference(config, expected[i], out.at(i)), "") << "beat " << i << ", seed " << bench.seed;
    ASSERT_EQ(shown[i], own[i]) << "payload of beat " << i << ", seed " << bench.seed;
  }
}

TEST(PuRegions, GivesEveryGaussianItsRegionsAndItsPayload) {
  for (const Pace source : kPaces) {
    for (const Pace sink : kPaces) {
      SCOPED_TRACE(std::string(to_text(source)) + " to " + to_text(sink));
      for (const unsigned living : {1u, 4u, 40u}) run(source, sink, living, false);
    }
  }
}

TEST(PuRegions, ManyMayDieWhileOneCannotLeave) {
  for (const unsigned living : {1u, 4u, 40u}) run(Pace::kAlways, Pace::kAlways, living, true);
}

}  // namespace
}  // namespace pipegs
