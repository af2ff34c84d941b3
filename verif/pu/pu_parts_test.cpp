// SPDX-License-Identifier: Apache-2.0
// pu_parts_test: rtl/pu/pu_parts.sv against its bit-accurate model; the model against the projection in a window
// as large as the part.
#include "cpp_model/pu/pu_parts.hpp"

#include <array>

#include "Vpu_parts.h"
#include "cpp_model/pu/project/pu_project.hpp"
#include "verif/pu/random_box.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

struct PartsRun {
  PartsRun(const Config& config, Pace source, Pace sink)
      : config(config),
        in(bench, config, bench.dut.conic_valid_i, bench.dut.conic_ready_o, bench.dut.conic_i, source),
        beside(
            bench,
            [this] {
              auto& dut = bench.dut;
              put += dut.payload_valid_i;
              taken +=
                  dut.conic_valid_i && dut.conic_ready_o && read_record<Conic>(this->config, dut.conic_i).kind == kData;
            },
            [this] {
              auto& dut = bench.dut;
              dut.payload_valid_i =
                  put < payloads.size() && put < taken + static_cast<size_t>(this->config.shape_places());
              write_record(this->config, dut.payload_i, dut.payload_valid_i ? payloads[put] : Payload{});
            }),
        out(bench, config, bench.dut.placed_valid_o, bench.dut.placed_ready_i, bench.dut.placed_o, sink),
        parted(bench, config, bench.dut.parted_valid_o, parted_ready, bench.dut.parted_o) {
    bench.reset();
  }
  void push(const Conic& conic, uint64_t walk = kWholeWalk) {
    conics.push_back(conic);
    if (conic.kind != kData) {
      expected.push_back({});
      expected.back().kind = conic.kind;
      return;
    }
    payloads.push_back(random_record<Payload>(config, bench.rng));
    payloads.back().walk = walk;
    if (walk_eye(config, walk) != kAllEyes) payloads.back().eye = static_cast<uint64_t>(walk_eye(config, walk));
    for (const PuPart& one : pu_parts(config, conic, walk, payloads.back().eye)) {
      expected.push_back(one.conic);
      expected_parted.push_back({payloads.back(), one.part});
    }
  }
  void check() {
    for (int i = 0; i < 5; ++i) bench.step();  // a payload is there long before its conic
    for (const Conic& conic : conics) in.push(conic);
    ASSERT_TRUE(bench.run_until([&] { return out.size() >= expected.size() && in.empty(); }, 400000));
    for (int i = 0; i < 20; ++i) bench.step();
    ASSERT_EQ(out.size(), expected.size());
    ASSERT_EQ(parted.size(), expected_parted.size());
    EXPECT_EQ(bench.dut.busy_o, 0);
    size_t data = 0;
    for (size_t i = 0; i < expected.size(); ++i) {
      ASSERT_EQ(first_difference(config, expected[i], out.at(i)), "") << "beat " << i << ", seed " << bench.seed;
      if (expected[i].kind != kData) continue;
      ASSERT_EQ(first_difference(config, expected_parted[data], parted.at(data)), "")
          << "payload " << data << ", seed " << bench.seed;
      EXPECT_LT(parted.cycles[data++], out.cycles[i]) << "a payload behind its beat";
    }
  }

  Config config;
  Bench<Vpu_parts> bench;
  RecordSource<Conic, std::remove_reference_t<decltype(Vpu_parts::conic_i)>> in;
  // Payloads come as early as pu_project may put them: at most ShapePlaces Gaussians lie between it and the output of
  // pu_conic.
  std::vector<Payload> payloads;
  size_t put = 0, taken = 0;
  Beside beside;
  RecordSink<Conic, std::remove_reference_t<decltype(Vpu_parts::placed_o)>> out;
  CData parted_ready = 0;  // what goes beside a beat is not refused
  RecordSink<Parted, std::remove_reference_t<decltype(Vpu_parts::parted_o)>> parted;
  std::vector<Conic> conics, expected;
  std::vector<Parted> expected_parted;
};

TEST(PuParts, EqualsItsModelAtEveryPace) {
  const Config config = test_config();
  size_t dropped = 0, several = 0, saturated = 0;
  for (const Pace source : kPaces) {
    for (const Pace sink : kPaces) {
      PartsRun run(config, source, sink);
      PuRandom random{config, run.bench.rng};
      for (int i = 0; i < 1500; ++i) {
        Conic conic = random_box(random, 2, 2, config.part_side());
        if (random.chance(30)) conic.kind = std::array{kLayerEnd, kWindowEnd, kPartEnd}[run.bench.rng() % 3];
        if (conic.kind != kData) conic = {.kind = conic.kind};
        const size_t before = run.expected.size();
        run.push(conic, random.walk());
        if (conic.kind != kData) continue;
        dropped += run.expected.size() == before;
        several += run.expected.size() > before + 1;
        const int64_t most = (int64_t{1} << (config.window_mean_w() - 1)) - 1;
        for (size_t k = before; k < run.expected.size(); ++k) saturated += run.expected[k].mean_x == most;
      }
      run.check();
    }
  }
  EXPECT_GT(dropped, 500u);
  EXPECT_GT(several, 500u);
  EXPECT_GT(saturated, 50u);
}

TEST(PuParts, GivesAPartEveryCycle) {
  const Config config = test_config();
  PartsRun run(config, Pace::kAlways, Pace::kAlways);
  constexpr size_t kGaussians = 300;
  for (size_t i = 0; i < kGaussians; ++i) {
    Conic conic = random_record<Conic>(config, run.bench.rng);
    conic.kind = kData;
    conic.mean_x = conic.mean_y = int64_t{64} << config.mean_f;
    conic.extent_x = conic.extent_y = 50 * 16;
    run.push(conic);
  }
  run.check();
  ASSERT_EQ(run.out.size(), 4 * kGaussians);
  EXPECT_LE(run.out.cycles.back() - run.out.cycles.front(), 5 * kGaussians);
}

TEST(PuPartsModel, PlacesAMeanAsTheProjectionInAWindowOfThatSize) {
  const Config config = test_config();
  Config small = config;
  small.window = config.part_side();
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  int saturated = 0, compared = 0;
  for (int i = 0; i < 300; ++i) {
    const Frame frame = random.frame();
    for (int k = 0; k < 100; ++k) {
      Visible v = random.visible(frame);
      v.window_x /= 2, v.window_y /= 2;
      if (random.chance(2)) v.view_z = std::max<int64_t>(1, v.view_z >> random.integer(4, 14));  // means far away
      const Center whole = pu_project(config, frame, v).center;
      Conic conic = random_box(random, 2, 2, config.part_side());
      conic.mean_x = whole.mean_x, conic.mean_y = whole.mean_y;
      for (const PuPart& one : pu_parts(config, conic)) {
        Visible alone = v;
        alone.window_x = 2 * v.window_x + one.part % 2, alone.window_y = 2 * v.window_y + one.part / 2;
        ProjectCounts counts;
        const Center center = pu_project(small, frame, alone, &counts).center;
        ASSERT_EQ(one.conic.mean_x, center.mean_x) << to_text(small, alone);
        ASSERT_EQ(one.conic.mean_y, center.mean_y) << to_text(small, alone);
        saturated += counts.saturated;
        ++compared;
      }
    }
  }
  EXPECT_GT(saturated, 10) << "of " << compared;
}

TEST(PuPartsModel, LeavesOutNoPartInWhichTheBoxHoldsAPixel) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  int inside = 0;
  for (int i = 0; i < 20000; ++i) {
    const Conic conic = random_box(random, 2, 2, config.part_side());
    const std::vector<PuPart> parts = pu_parts(config, conic);
    for (uint64_t part = 0; part < 4; ++part) {
      const int to_mean = clog2(config.part_side()) + config.mean_f;
      const auto holds = [&](int64_t mean, uint64_t extent, uint64_t square) {  // as pu_intersect makes its box
        const int64_t in_part = saturate(mean - (static_cast<int64_t>(square) << to_mean), config.window_mean_w()),
                      half = static_cast<int64_t>(extent) << (config.mean_f - 4), unit = int64_t{1} << config.mean_f;
        return std::max<int64_t>((in_part - half + unit - 1) >> config.mean_f, 0) <=
               std::min<int64_t>((in_part + half) >> config.mean_f, config.part_side() - 1);
      };
      if (!holds(conic.mean_x, conic.extent_x, part % 2) || !holds(conic.mean_y, conic.extent_y, part / 2)) continue;
      ++inside;
      EXPECT_TRUE(std::any_of(parts.begin(), parts.end(), [&](const PuPart& one) { return one.part == part; }))
          << part << " " << to_text(config, conic);
    }
  }
  EXPECT_GT(inside, 10000);
}

}  // namespace
}  // namespace pipegs
