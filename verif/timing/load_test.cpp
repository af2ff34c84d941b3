// SPDX-License-Identifier: Apache-2.0
// load_test: one window with far more splats than the Sorting Units hold, on the timing model.
//
// Rule    Cycles and bytes of a splat hardly depend on how the depths are spread, nor on how many there are: a set that
//         does not fit is merged from memory in n log n, and each of its records moves there and back at most twice.
//         Only the list of its keys is read for each watermark that passes meanwhile; a million wait for many of them.
// Prints  a line for each number of splats, with all spreads: docs/cycles/scale.md shows them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

#include "scenes/generate/generate_random.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/design/design_point.hpp"
#include "sim/timing/timing_check.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

constexpr int kSide = 128;          // of the picture, one window of `window=128`
constexpr double kFocal = 100;      // pixels
constexpr double kOpacity = 0.006;  // above 1/255 where a splat is nearest, and no region stops for a million of them

using Depth = std::function<double(generate::Random&)>;  // of a mean, 0.5 to 1000

const std::map<std::string, Depth>& depths() {
  static const std::map<std::string, Depth> kDepths = {
      {"random", [](generate::Random& r) { return r.uniform(2, 100); }},
      {"equal", [](generate::Random&) { return 10.0; }},
      {"clusters", [](generate::Random& r) { return (r.bits() & 1) != 0 ? r.uniform(2, 2.01) : r.uniform(80, 80.1); }},
      {"outlier", [](generate::Random& r) { return r.uniform() < 1e-4 ? 1000 : r.uniform(10, 10.01); }},
      {"logarithmic", [](generate::Random& r) { return std::exp(r.uniform(std::log(0.5), std::log(1000.0))); }},
  };
  return kDepths;
}

// Splats of about one pixel, all over the window.
Scene load(const Depth& depth, size_t count) {
  generate::Random random(1);
  std::vector<Gaussian> gaussians;
  for (size_t i = 0; i < count; ++i) {
    const double z = depth(random), most = 0.45 * kSide / kFocal;
    const double x = z * random.uniform(-most, most), y = z * random.uniform(-most, most);
    gaussians.push_back(gaussian_at({x, y, z}, static_cast<float>(0.4 * z / kFocal), kOpacity));
  }
  return scene_of(std::move(gaussians));
}

struct Cost {
  double cycles = 0, sorting = 0;  // of a splat; bytes of the sort overflow
};

// By `fast`: exact order, windows of 128 pixels. What is too much at one depth for one set goes part by part.
Cost cost(const std::string& name, size_t count) {
  SimulateOptions options;
  options.memory.dram = "lpddr5-6400x4";
  options.config = find_design_point("fast").config;
  Simulation simulation;
  const Scene scene = load(depths().at(name), count);
  simulate_pack(scene, test_camera(kSide, kSide, kFocal), options, simulation);
  const TimingResult run = timing_run(timing_trace(simulation.input), options.config, options.memory);
  double bytes = 0;
  for (const MemoryTraffic& stream : run.streams) {
    if (stream.stream == "sort_overflow") bytes = static_cast<double>(stream.bytes_read + stream.bytes_written);
  }
  const auto splats = static_cast<double>(count);
  return {static_cast<double>(run.cycles) / splats, bytes / splats};
}

// A PU takes a splat every four cycles, so four PUs need one. A record is 64 bytes: to memory and back it and its key
// take at most three times as many. Memory moves some 50 bytes in a cycle at best, and half of that here: the ways of a
// merge lie in rows of their own, so that banks change rows for nearly every line. `readings`: how often all of a list,
// on the average, is read beyond that, eight bytes and a cycle of one of four SUs for each key.
void expect_one_pace(size_t count, int readings = 0) {
  std::string line;
  double most = 0;
  for (const auto& [name, depth] : depths()) {
    const Cost found = cost(name, count);
    EXPECT_LE(found.cycles, 9.5 + 0.25 * readings) << name;
    EXPECT_LE(found.sorting, 3 * 64 + 8 * readings) << name;
    if (name == "equal" && count > 10000) EXPECT_GT(found.sorting, 64) << "all at one depth fit";
    most = std::max(most, found.sorting);
    line += fmt::format("; {} {:.2f}, {:.1f}", name, found.cycles, found.sorting);
  }
  EXPECT_GT(most, 64) << "every set fits";
  fmt::print("{} splats, cycles and bytes of sorting for each{}\n", count, line);
}

TEST(Load, TenThousandSplatsInAWindow) { expect_one_pace(10000); }
TEST(Load, AHundredThousand) { expect_one_pace(100000); }
TEST(Load, AMillion) { expect_one_pace(1000000, 10); }

}  // namespace
}  // namespace pipegs
