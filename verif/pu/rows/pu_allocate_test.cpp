// SPDX-License-Identifier: Apache-2.0
// pu_allocate_test: rtl/pu/rows/pu_allocate.sv against its bit-accurate model, with done bits and layers that change
// while it runs. Without Overflow every layer fits its store, or an assertion says so.
#include <map>

#include "cpp_model/pu/rows/pu_allocate.hpp"
#include "cpp_model/ru/ru_walk.hpp"
#include "verif/support/config.hpp"
#include "verif/support/frame_ports.hpp"
#include "verif/support/gated_bench.hpp"
#include "Vpu_allocate.h"

namespace pipegs {
namespace {

// The RUs: they show random done bits of the right or of a wrong window, and some time after the end of a layer they
// free its lines, one by one in any order of layers, and then the layer.
struct World : Endpoint {
  World(BenchBase& bench, Vpu_allocate& dut, const Config& config, const Frame& frame)
      : bench(bench),
        dut(dut),
        config(config),
        frame(frame),
        model(config),
        x(frame.raster.windows.first_x),
        y(frame.raster.windows.first_y) {
    bench.add(*this);
  }
  void drive() override {
    write_record(config, dut.payload_i, payload);
    dut.restart_i = restart;
    if (restart) x = frame.raster.windows.first_x, y = frame.raster.windows.first_y, model = PuAllocate(config);
    restart = false;
    Words done(port_words<decltype(dut.done_i)>() + 2), done_x(8), done_y(8);
    live = 0;
    for (int j = 0; j < config.units; ++j) {
      const uint64_t bits = done_pace == 0 ? 0 : bench.rng() & bench.rng();  // noise also in regions of other units
      const bool here = bench.rng() % 2 == 0, same_x = bench.rng() % 2 == 0;
      put_bits(done.data(), j * config.regions(), config.regions(), bits & all());
      put_bits(done_x.data(), j * 10, 10, here || same_x ? x : (x + 1) & 1023);
      put_bits(done_y.data(), j * 10, 10, here || !same_x ? y : (y + 1) & 1023);
      for (int r = 0; r < config.regions(); ++r) {
        if (here && ru_owner(config, r) == j) live |= bits & (uint64_t{1} << r);
      }
    }
    write_port(dut.done_i, done.data());
    write_port(dut.done_x_i, done_x.data());
    write_port(dut.done_y_i, done_y.data());
    const uint64_t ended = std::min(row_ends(), color_ends());
    dut.line_free_i = 0;
    if (bench.rng() % line_one_in == 0) {
      std::vector<uint64_t> of;  // layers with lines in the store that may be read
      for (uint64_t one = freed; one < ended; ++one)
        if (in_store[one] != 0) of.push_back(one);
      if (!of.empty()) {
        dut.line_free_i = 1;
        --in_store[meetings < 0 ? of[bench.rng() % of.size()] : of.front()];
        --used;
      }
    }
    bool now = bench.rng() % free_one_in == 0;
    if (meetings >= 0) {
      now = meetings > 0 && dut.tiles_valid_i && dut.tiles_ready_o &&
            read_record<Tiles>(config, dut.tiles_i).kind != kData;
    }
    dut.layer_free_i = now && freed < ended && in_store[freed] == 0;
    if (meetings > 0 && dut.layer_free_i) --meetings;
  }
  void observe() override {
    overflowed += dut.overflowed_o;
    waited += dut.waiting_o;
    if (dut.tiles_valid_i && dut.tiles_ready_o) {
      const Tiles tiles = read_record<Tiles>(config, dut.tiles_i);
      ASSERT_LT(layer - freed, static_cast<uint64_t>(config.alpha_layers))
          << "too many layers live, cycle " << bench.cycle;
      const auto out = model(tiles, payload, live);
      payload = random_record<Payload>(config, bench.rng);  // of the next one
      if (out) {
        expected.push_back(*out);
        expected_overflowed += out->overflowed;
      }
      if (tiles.kind != kData) ++layer;
      if (tiles.kind == kWindowEnd) {
        if (x++ == frame.raster.windows.last_x) x = frame.raster.windows.first_x, ++y;
      }
    }
    // Addresses and areas are used again only after their layer was freed, and no more lines live than have a slot.
    if (dut.row_job_valid_o && !shown) {
      shown = true;
      const RowJob job = read_record<RowJob>(config, dut.row_job_o);
      if (job.kind == kData && !job.ext) {
        for (int i = 0; i < std::popcount(job.mask); ++i) {
          const uint64_t line =
              (job.address + static_cast<uint64_t>(i)) % static_cast<uint64_t>(config.alpha_addresses());
          ASSERT_TRUE(held.emplace(line, layer).second) << "line " << line << " is given twice, cycle " << bench.cycle;
          ++in_store[layer], ++used;
        }
        ASSERT_LE(used, config.alpha_lines) << "cycle " << bench.cycle;
      } else if (job.kind == kData) {
        const auto [area, fresh] = areas.emplace(job.address >> ru_number_w(config), layer);
        ASSERT_EQ(area->second, layer) << "an area is given twice, cycle " << bench.cycle;
      }
    }
    if (dut.row_job_valid_o && dut.row_job_ready_i) shown = false;
    if (dut.layer_free_i) {
      std::erase_if(held, [&](const auto& line) { return line.second == freed; });
      std::erase_if(areas, [&](const auto& area) { return area.second == freed; });
      ++freed;
    }
  }
  uint64_t all() const { return config.regions() == 64 ? ~uint64_t{0} : (uint64_t{1} << config.regions()) - 1; }

  BenchBase& bench;
  Vpu_allocate& dut;
  Config config;
  Frame frame;
  Payload payload;  // beside the tiles that are shown
  PuAllocate model;
  std::function<uint64_t()> row_ends, color_ends;
  std::vector<PuAllocate::Out> expected;
  std::map<uint64_t, uint64_t> held, areas;  // layers of addresses, of overflow areas
  std::map<uint64_t, uint64_t> in_store;     // lines of layers that have a slot
  int used = 0;                              // of all layers
  uint64_t x, y, live = 0, layer = 0, freed = 0, overflowed = 0, expected_overflowed = 0, waited = 0;
  uint64_t done_pace = 1, free_one_in = 20, line_one_in = 2;
  int meetings = -1;  // layers that are still freed, in the very cycle that takes an end; -1: freed at random
  bool shown = false, restart = false;
};

struct AllocateBench {
  Config config = test_config();
  Frame frame{.raster = {.windows = {.first_x = 3, .first_y = 5, .last_x = 4, .last_y = 6}}};
  GatedBench<Vpu_allocate> bench;
  RecordSource<Tiles, decltype(bench.dut.tiles_i)> in{bench, config, bench.dut.tiles_valid_i, bench.dut.tiles_ready_o,
                                                      bench.dut.tiles_i};
  RecordSink<RowJob, decltype(bench.dut.row_job_o)> rows{bench, config, bench.dut.row_job_valid_o,
                                                         bench.dut.row_job_ready_i, bench.dut.row_job_o};
  RecordSink<ColorJob, decltype(bench.dut.color_job_o)> colors{bench, config, bench.dut.color_job_valid_o,
                                                               bench.dut.color_job_ready_i, bench.dut.color_job_o};
  World world{bench, bench.dut, config, frame};

  AllocateBench() {
    write_frame(config, bench.dut, frame);
    world.row_ends = [this] { return ends(rows, rows_seen, row_ends); };
    world.color_ends = [this] { return ends(colors, colors_seen, color_ends); };
    bench.reset();
  }
  template <class Sink>
  static uint64_t ends(const Sink& sink, size_t& seen, uint64_t& count) {
    for (; seen < sink.size(); ++seen) count += sink.at(seen).kind != kData;
    return count;
  }
  void restart() {  // before any beat of the frame
    world.restart = true;
    bench.gated_step();
  }
  // The four windows of a frame, each of one to three layers of up to `most` Gaussians; without Overflow of those that
  // fit.
  void push_frame(uint64_t most) {
    restart();
    for (int w = 0; w < 4; ++w) {
      for (int layers = 1 + static_cast<int>(bench.rng() % 3); layers > 0; --layers) {
        int room = config.alpha_lines;
        for (uint64_t n = bench.rng() % (most + 1); n > 0; --n) {
          Tiles tiles = random_record<Tiles>(config, bench.rng);
          tiles.kind = kData;
          if (bench.rng() % 2 == 0) tiles.mask &= bench.rng() & bench.rng() & bench.rng() & bench.rng();
          room -= std::popcount(tiles.mask);
          if (!config.overflow && room < 0) break;
          in.push(tiles);
        }
        Tiles end = random_record<Tiles>(config, bench.rng);
        end.kind = layers == 1 ? kWindowEnd : kLayerEnd;
        in.push(end);
      }
    }
  }
  void run_and_compare(bool gated) {
    const auto finished = [&] {
      return testing::Test::HasFatalFailure() ||
             (in.empty() && bench.dut.tiles_valid_i == 0 && rows.size() == world.expected.size() &&
              colors.size() == world.expected.size() && world.freed == world.layer);
    };
    if (gated) bench.run_gated_until(finished, 400000);
    else bench.run_until(finished, 400000);
    for (size_t i = 0; i < std::min({rows.size(), colors.size(), world.expected.size()}); ++i) {
      const PuAllocate::Out& out = world.expected[i];
      ASSERT_EQ(rows.at(i).kind, out.row_job.kind) << "job " << i;
      ASSERT_EQ(colors.at(i).kind, out.row_job.kind) << "job " << i;
      if (out.row_job.kind != kData) continue;
      ASSERT_EQ(first_difference(config, out.row_job, rows.at(i)), "")
          << "row job " << i << ", cycle " << rows.cycles[i];
      ASSERT_EQ(first_difference(config, out.color_job, colors.at(i)), "")
          << "color job " << i << ", cycle " << colors.cycles[i];
    }
    EXPECT_EQ(world.overflowed, world.expected_overflowed);
  }
  size_t rows_seen = 0, colors_seen = 0;
  uint64_t row_ends = 0, color_ends = 0;
};

TEST(PuAllocate, EqualsItsModelAtEveryPairOfPaces) {
  uint64_t overflowed = 0, waited = 0;  // at some pair: not at each of them with every draw
  for (Pace source : kPaces) {
    for (Pace sink : kPaces) {
      AllocateBench s;
      s.in.pace = source, s.rows.pace = sink, s.colors.pace = Pace::kCoin;
      s.world.free_one_in =
          sink == Pace::kAlways || !s.config.overflow ? 1000 : 20;  // also slow RUs: layers wait for each other
      s.world.line_one_in = sink == Pace::kAlways ? 8 : 2;
      for (int frames = 0; frames < 3; ++frames) {
        s.push_frame(8 * static_cast<uint64_t>(s.config.alpha_lines / s.config.regions()));  // some layers overflow
        s.run_and_compare(true);
      }
      overflowed += s.world.overflowed, waited += s.world.waited;
      if (HasFailure()) { FAIL() << "source " << to_text(source) << ", sink " << to_text(sink); }
    }
  }
  EXPECT_EQ(overflowed > 0, test_config().overflow != 0);
  EXPECT_GT(waited, 0u);
}

TEST(PuAllocate, DropsGaussiansOfOpaqueRegions) {
  AllocateBench s;
  s.push_frame(60);
  for (Words& beat : s.in.beats) {
    Tiles tiles = unpack<Tiles>(s.config, beat.data());
    tiles.mask = uint64_t{1} << (s.bench.rng() % static_cast<uint64_t>(s.config.regions()));
    pack(s.config, tiles, beat.data());
  }
  const size_t pushed = s.in.beats.size();
  s.run_and_compare(false);
  EXPECT_LT(s.rows.size(), pushed);
}

// Small layers: the first one is freed in the very cycle that takes the end of a later one. So one more than
// AlphaLayers comes in without another pulse, and the one behind it waits.
TEST(PuAllocate, FreesALayerInTheCycleThatTakesAnEnd) {
  for (const bool gated : {false, true}) {
    for (int layers_before = 0; layers_before < 3; ++layers_before) {  // also meetings in a row
      AllocateBench s;
      s.world.done_pace = 0;
      s.restart();
      const int live = s.config.alpha_layers, layers = 2 + live + layers_before;
      for (int layer = 0; layer < layers; ++layer) {
        Tiles tiles = random_record<Tiles>(s.config, s.bench.rng);
        tiles.kind = kData;
        tiles.mask = 0xf;
        s.in.push(tiles);
        Tiles end = random_record<Tiles>(s.config, s.bench.rng);
        end.kind = layer == layers - 1 ? kWindowEnd : kLayerEnd;
        s.in.push(end);
      }
      const uint64_t meetings = 1 + static_cast<uint64_t>(layers_before);
      const uint64_t before_last = (meetings + static_cast<uint64_t>(live)) * 2;
      s.world.line_one_in = 1;
      s.world.meetings = static_cast<int>(meetings);
      const auto reached = [&] { return HasFatalFailure() || s.in.taken >= before_last; };
      if (gated) s.bench.run_gated_until(reached, 4000);
      else s.bench.run_until(reached, 4000);
      ASSERT_EQ(s.world.freed, meetings) << "the pulses did not meet the ends";
      for (int i = 0; i < 50; ++i) {
        if (gated) s.bench.gated_step();
        else s.bench.step();
      }
      ASSERT_EQ(s.in.taken, before_last) << "one layer too many is let in";
      s.world.meetings = -1;
      s.run_and_compare(gated);
      EXPECT_EQ(s.world.overflowed, 0u);
      if (HasFailure()) { FAIL() << (gated ? "gated, " : "") << meetings << " meetings"; }
    }
  }
}

TEST(PuAllocate, TakesAGaussianPerFourCycles) {
  AllocateBench s;
  s.world.done_pace = 0;
  s.restart();
  for (int i = 0; i < 30; ++i) {
    Tiles tiles = random_record<Tiles>(s.config, s.bench.rng);
    tiles.kind = kData, tiles.mask = 3;
    s.in.push(tiles);
  }
  s.run_and_compare(false);
  EXPECT_EQ(s.rows.cycles.back() - s.rows.cycles.front(), 4 * (s.rows.size() - 1));
}

// Of two Gaussians that do not both fit the store, the second one of each layer goes to memory.
TEST(PuAllocate, AThirdLayerWaitsForAnOverflowArea) {
  AllocateBench s;
  const int lines = s.config.alpha_lines * 5 / 8;
  if (!s.config.overflow || s.config.alpha_layers < 3 || lines > s.config.regions()) {
    GTEST_SKIP() << "three live layers of one Gaussian each would need more addresses than there are";
  }
  s.world.done_pace = 0, s.world.line_one_in = 1, s.world.free_one_in = UINT64_MAX;
  s.restart();
  for (int layer = 0; layer < 3; ++layer) {
    for (const uint64_t kind : {kData, kData, layer == 2 ? kWindowEnd : kLayerEnd}) {
      Tiles tiles = random_record<Tiles>(s.config, s.bench.rng);
      tiles.kind = kind, tiles.mask = (uint64_t{1} << lines) - 1;
      s.in.push(tiles);
    }
  }
  for (int i = 0; i < 400; ++i) s.bench.gated_step();
  EXPECT_EQ(s.in.taken, 8u) << "the third layer's second Gaussian waits";
  EXPECT_EQ(s.rows.size(), 7u);
  s.world.free_one_in = 1;
  s.run_and_compare(true);
  EXPECT_EQ(s.world.overflowed, 3 * static_cast<uint64_t>(lines));
}

TEST(PuAllocate, SaysSoWhenALayerDoesNotFit) {
  AllocateBench s;
  if (s.config.overflow) GTEST_SKIP() << "what does not fit goes to memory";
  s.world.done_pace = 0;
  s.restart();
  // One line too many.
  for (int left = s.config.alpha_lines + 1; left > 0; left -= s.config.regions()) {
    Tiles tiles = random_record<Tiles>(s.config, s.bench.rng);
    tiles.kind = kData, tiles.mask = left > s.config.regions() ? s.world.all() : 1;
    s.in.push(tiles);
  }
  EXPECT_THROW(s.run_and_compare(false), std::runtime_error);
  EXPECT_EQ(s.in.taken, static_cast<uint64_t>(s.config.alpha_lines / s.config.regions() + 1));
}

}  // namespace
}  // namespace pipegs
