// SPDX-License-Identifier: Apache-2.0
// ru_drain_test: rtl/ru/live/ru_drain.sv against cpp_model/ru/ru_resolve.hpp: windows with words of random pixels,
// slots that are wanted, a memory that takes lines at some pace.
#include <optional>

#include "cpp_model/ru/ru_resolve.hpp"
#include "cpp_model/ru/ru_walk.hpp"
#include "verif/ru/pixel_words.hpp"
#include "verif/ru/region_ports.hpp"
#include "verif/ru/written_pixels.hpp"
#include "verif/support/config.hpp"
#include "Vru_drain.h"

namespace pipegs {
namespace {

const Config kConfig = test_config();
const int kSlots = kConfig.regions() / kConfig.units;
constexpr int kLatency = 3;  // cycles from a job to its word

// ru_live lays a row of quads out as two rows of a region.
const Config kWhole = [] {
  Config config = kConfig;
  config.quads = 0;
  return config;
}();

class Around : public Endpoint {
 public:
  Around(Bench<Vru_drain>& bench, Pace pace, int unit, bool raster) : bench_(bench), pace_(pace), unit_(unit) {
    RegionSet own;
    for (int part = 0; part < kConfig.parts(); ++part) own.mask[part] = ru_own_mask(kConfig, unit);
    write_regions(kConfig, bench.dut.own_i, own);
    bench.dut.restart_i = bench.dut.start_i = bench.dut.mem_ready_i = 0;
    frame_.raster.width = 2 * kConfig.window + 1 + bench.rng() % kConfig.window;
    frame_.raster.height = 2 * kConfig.window + 1 + bench.rng() % kConfig.window;
    frame_.tables.pixels = bench.rng() % 1000000;
    picture_ = random_picture(kConfig, frame_, bench.rng, raster);
    bench.dut.raster_i = raster;
    bench.dut.stride_i = static_cast<SData>(picture_.stride);
    frame_.raster.aovs = random_aovs(kConfig, frame_, picture_, bench.rng);
    write_aovs(kConfig, bench.dut, frame_, picture_);
    random_eyes(kConfig, picture_, bench.rng, frame_);
    bench.dut.eye_lines_i = frame_.raster.eye_lines;
    bench.add(*this);
  }

  // All words are cleared, each once, and nothing is written.
  void restart() {
    quiet_ = true;
    bench_.dut.restart_i = 1;
    bench_.step();
    bench_.dut.restart_i = 0;
    left_.assign(kSlots, 0);
    run();
  }
  void window(uint64_t x, uint64_t y) {
    words_.clear();
    RuState state = ru_start(kConfig, frame_, unit_);
    state.window_x = x;
    state.window_y = y;
    std::vector<int> left(kSlots, 4);
    std::vector<uint32_t> outside(port_words<decltype(Vru_drain::outside_i)>() + 1);
    for (int slot = 0; slot < kSlots; ++slot) {
      const int r = ru_region(kConfig, unit_, slot);
      const RegionState region = random_region(kConfig, bench_.rng);
      const RegionAovs aovs = random_region_aovs(kConfig, bench_.rng);
      for (int row = 0; row < 4; ++row) words_.push_back(pixel_word(kWhole, region, row, 0, &aovs));
      if (!ru_inside(kConfig, frame_, x, y, r)) {
        put_bits(outside.data(), slot, 1, 1);
        continue;
      }
      left[slot] = 0;
      state.regions[slot] = region;
      if (kConfig.has_aovs()) state.aovs[slot] = aovs;
      lines_.expect(kConfig, frame_, picture_, state, r);
    }
    quiet_ = false;
    auto& dut = bench_.dut;
    EXPECT_TRUE(dut.ready_o);
    const auto side = static_cast<uint64_t>(kConfig.window);
    dut.line_i = picture_.format != 0 ? ru_raster_line(picture_, x * side, y * side)
                                      : ru_pixel_line(kConfig, frame_, x, y, 0, 0);
    dut.columns_i = std::min(side, frame_.raster.width - x * side);
    dut.rows_i = std::min(side, frame_.raster.height - y * side);
    write_port(dut.outside_i, outside.data());
    dut.start_i = 1;
    bench_.step();
    dut.start_i = 0;
    dut.line_i = dut.columns_i = dut.rows_i = 0;
    left_ = left;
    steady_ = false;
    run();
    EXPECT_TRUE(lines_.empty()) << "lines that were not written";
  }
  void run() {
    bench_.run_until([&] { return bench_.dut.idle_o || testing::Test::HasFailure(); });
    for (int slot = 0; slot < kSlots; ++slot) EXPECT_EQ(left_[slot], 4) << "words of slot " << slot;
  }

  void drive() override {
    auto& dut = bench_.dut;
    dut.mem_ready_i = goes(pace_, bench_.rng);
    if (bench_.rng() % 8 == 0) wanted_ = static_cast<int>(bench_.rng() % static_cast<uint64_t>(kSlots + 1)) - 1;
    std::vector<uint32_t> wanted(port_words<decltype(dut.wanted_i)>() + 1);
    if (wanted_ >= 0) put_bits(wanted.data(), wanted_, 1, 1);
    write_port(dut.wanted_i, wanted.data());
    Words noise(static_cast<size_t>(pixel_word_width(kWhole) / 32 + 2));
    for (uint32_t& word : noise) word = static_cast<uint32_t>(bench_.rng());
    const auto& job = jobs_[kLatency - 1];
    const Words& word = job && !quiet_ ? words_[*job] : noise;
    write_port(dut.word_i, word.data());
    if (kConfig.has_aovs()) {
      const int below = kRegionPixels / 4 * (3 * kConfig.rgb_w + kConfig.t_w + 1), width = kConfig.aov_bits() * 16;
      Words aovs(port_words<decltype(dut.aovs_i)>() + 2);
      copy_bits(word.data(), below, aovs.data(), 0, width);
      write_port(dut.aovs_i, aovs.data());
    }
    for (int i = kLatency - 1; i > 0; --i) jobs_[i] = jobs_[i - 1];
    jobs_[0].reset();
  }
  void observe() override {
    auto& dut = bench_.dut;
    std::vector<uint32_t> held(port_words<decltype(dut.held_o)>() + 1);
    read_port(dut.held_o, held.data());
    for (int slot = 0; slot < kSlots; ++slot) {
      const bool handed = left_.empty() || left_[slot] == 4;
      ASSERT_EQ(get_bits(held.data(), slot, 1), !handed) << "slot " << slot << " cycle " << bench_.cycle;
    }
    if (dut.job_o) take_job();
    if (dut.mem_valid_o && dut.mem_ready_i) take_line();
  }
  void take_job() {
    const int address = bench_.dut.job_address_o, slot = address / 4;
    ASSERT_LT(slot, kSlots);
    ASSERT_EQ(address % 4, left_[slot]) << "words of a slot are out of order, cycle " << bench_.cycle;
    if (steady_ && chosen_for_ >= 0 && left_[chosen_for_] == 0) {  // chosen with the last job of the slot before
      EXPECT_EQ(slot, chosen_for_) << "a wanted slot waits, cycle " << bench_.cycle;
    }
    steady_ = address % 4 == 3;
    chosen_for_ = wanted_;
    ++left_[slot];
    jobs_[0] = address;
  }
  void take_line() {
    auto& dut = bench_.dut;
    ++lines_taken;
    ASSERT_FALSE(quiet_) << "pixels are written when a frame begins";
    lines_.take(dut.mem_address_o, dut.mem_halves_o, dut.mem_data_o, bench_.seed);
    ASSERT_EQ(dut.mem_wide_o, picture_.format != 0 && WrittenPixels::wide(frame_, picture_, dut.mem_address_o));
  }
  uint64_t lines_taken = 0;
  uint64_t aovs() const { return frame_.raster.aovs.wanted; }

 private:
  Bench<Vru_drain>& bench_;
  Pace pace_;
  int unit_, wanted_ = -1, chosen_for_ = -1;
  bool quiet_ = true, steady_ = false;  // steady: the last job was the last one of its slot
  Frame frame_;
  Picture picture_;
  std::vector<Words> words_;  // by address
  std::vector<int> left_;     // words of each slot that were read; 4: it is handed over
  WrittenPixels lines_;
  std::optional<int> jobs_[kLatency];
};

TEST(RuDrain, WritesTheLinesOfItsModelAtEveryPace) {
  for (const Pace pace : kPaces) {
    for (int i = 0; i < 2 * kConfig.units; ++i) {
      Bench<Vru_drain> bench(test_seed() + i);
      Around around(bench, pace, i / 2, i % 2 != 0);
      bench.reset();
      around.restart();
      for (const uint64_t window : {0, 2, 1, 2}) {
        around.window(window, 2 - window);
        if (HasFailure()) FAIL() << to_text(pace) << ", window " << window << ", seed " << bench.seed;
      }
    }
  }
}

// A place is free again five cycles after its word was asked for; a word that is two requests, of 64-bit pixels or in
// raster order, takes a cycle more to leave.
TEST(RuDrain, BringsTwoWordsInFiveCycles) {
  for (const bool raster : {false, true}) {
    Bench<Vru_drain> bench;
    Around around(bench, Pace::kAlways, 0, raster);
    bench.reset();
    const uint64_t before = bench.cycle;
    around.restart();
    EXPECT_LE(bench.cycle - before, 4u * kSlots + 8) << "a word is cleared in a cycle";
    const uint64_t start = bench.cycle;
    around.window(0, 0);
    if (around.aovs() != 0) continue;  // each takes a turn more
    const uint64_t words = 4u * kSlots, most = kConfig.pixel_w == 32 && !raster ? (5 * words + 1) / 2 : 3 * words;
    EXPECT_LE(bench.cycle - start, most + 8) << "raster order: " << raster;
  }
}

}  // namespace
}  // namespace pipegs
