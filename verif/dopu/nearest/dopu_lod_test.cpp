// SPDX-License-Identifier: Apache-2.0
// dopu_lod_test: rtl/dopu/nearest/dopu_lod.sv against its bit-accurate model, and the model's sizes by hand.
#include "cpp_model/dopu/nearest/dopu_lod.hpp"

#include "Vdopu_lod.h"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

TEST(DopuLod, EqualsItsModel) {
  const Config config = test_config();
  Bench<Vdopu_lod> bench;
  const auto below = [&](int bits) { return bench.rng() & ((uint64_t{1} << bits) - 1); };
  uint64_t taken = 0, edges = 0;
  for (int i = 0; i < 300000; ++i) {
    Frame frame;
    frame.lens.near_plane = uint64_t{1} << (bench.rng() % 30);
    frame.lens.near_plane += bench.rng() % frame.lens.near_plane;
    Node group;
    group.error = bench.rng() % 16 == 0 ? below(config.error_w()) | 0xfe : below(config.error_w());
    group.count = 1 + bench.rng() % static_cast<uint64_t>(config.group);
    group.first = below(config.slot_w() - 1);
    const int bucket = static_cast<int>(below(config.bucket_w()));
    frame.lod = bench.rng() % 8 == 0 ? 0 : below(config.lod_w() - 1);
    if (i % 2 == 0) {  // at its own limit, and beside it
      const int64_t step = static_cast<int64_t>(group.error << (config.bucket_bits - Config::error_bits()));
      const int64_t lod = dopu_depth_edge(config, frame, bucket) - step + static_cast<int64_t>(bench.rng() % 3) - 1;
      frame.lod = lod > 0 ? static_cast<uint64_t>(lod) : 0;
      edges += lod > 0;
    }
    bench.dut.lod_i = static_cast<SData>(frame.lod);
    bench.dut.near_step_i = static_cast<SData>(dopu_depth_near(config, frame));
    bench.dut.bucket_i = static_cast<SData>(bucket);
    bench.dut.range_i = ((group.error << config.count_w() | group.count) << config.slot_w()) | group.first;
    bench.dut.eval();
    const Node opened = dopu_lod(config, frame, group, bucket);
    ASSERT_EQ(bench.dut.range_o, opened.count << config.slot_w() | opened.first)
        << "seed " << bench.seed << ", lod " << frame.lod << ", bucket " << bucket << ": " << to_text(config, group);
    taken += opened.first != group.first;
  }
  EXPECT_GT(taken, 30000u);
  EXPECT_GT(edges, 50000u);
}

// A pixel at depth z is z / focal wide: a group whose proxies will do from pixels of one unit on takes them where that
// is reached, to a step of depth and a step of the error.
TEST(DopuLod, ProxiesStandWhereAPixelIsAsLargeAsTheirError) {
  const Config config = test_config();
  Frame frame;
  frame.lens.near_plane = 1;
  for (const double focal : {100.0, 800.0}) {
    for (const double pixels : {0.5, 1.0, 3.0}) {
      frame.lod = dopu_lod_of(config, focal, pixels);
      for (const int octave : {0, 3}) {
        Node group{.first = 1000, .count = 16, .error = static_cast<uint64_t>(octave) << Config::error_bits()};
        int bucket = 0;
        while (dopu_lod(config, frame, group, bucket).first == group.first) ++bucket;
        const double depth = std::exp2(bucket / std::exp2(config.bucket_bits)),
                     wanted = std::exp2(octave) * focal / pixels;
        EXPECT_NEAR(std::log2(depth / wanted), 0, 0.02) << focal << " " << pixels << " " << octave;
      }
    }
  }
}

TEST(DopuLod, ChunksOfProxiesHoldTwoForEachChunk) {
  const Config config = test_config();
  EXPECT_EQ(config.chunk, 16);
  EXPECT_EQ(dopu_lod_chunks(config, 1), 1u);
  EXPECT_EQ(dopu_lod_chunks(config, 8), 1u);
  EXPECT_EQ(dopu_lod_chunks(config, 9), 2u);
  EXPECT_EQ(dopu_lod_chunks(config, 16), 2u);
}

TEST(DopuLod, NoSizeIsNoLevelAndTheLargestErrorIsNeverTaken) {
  const Config config = test_config();
  EXPECT_EQ(dopu_lod_of(config, 1000, 0), 0u);
  Frame frame;
  frame.lens.near_plane = 1;
  const Node never{.first = 10, .count = 4, .error = 255}, always{.first = 10, .count = 4, .error = 0};
  const int last = (1 << config.bucket_w()) - 1;
  frame.lod = 1;
  EXPECT_EQ(dopu_lod(config, frame, never, last).first, 10u);
  EXPECT_EQ(dopu_lod(config, frame, always, last).first, 14u);
  frame.lod = 0;
  EXPECT_EQ(dopu_lod(config, frame, always, last).first, 10u);
}

}  // namespace
}  // namespace pipegs
