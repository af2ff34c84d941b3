// SPDX-License-Identifier: Apache-2.0
// ru_lanes_test: rtl/ru/ru_lanes.sv against cpp_model/ru/ru_lanes.hpp, with the pixel buffer as an array.
#include <optional>

#include "cpp_model/ru/ru_resolve.hpp"
#include "verif/ru/alpha_lines.hpp"
#include "verif/ru/pixel_words.hpp"
#include "verif/support/config.hpp"
#include "Vru_lanes.h"

namespace pipegs {
namespace {

const Config kConfig = test_config();
const BlendConstants kBlend(kConfig);

struct Beat {
  Blend blend;
  Codes codes;
};

// Source of beats, pixel buffer and window control around the module; keeps the golden state beside it.
class Around : public Endpoint {
 public:
  Around(Bench<Vru_lanes>& bench, Pace in_pace, Pace resolve_pace)
      : words(kConfig.regions() / kConfig.units * 4), bench_(bench), in_pace_(in_pace), resolve_pace_(resolve_pace) {
    bench.dut.in_valid_i = bench.dut.restart_i = 0;
    bench.add(*this);
    frame.raster.width = 2 * kConfig.window + 17;
    frame.raster.height = 2 * kConfig.window + 33;
    start_window();
  }
  void start_window() {
    regions.clear();
    touched = 0;
    for (int r = 0; r < kConfig.regions(); ++r) regions.push_back(ru_fresh_region(kConfig, frame, window, window, r));
    for (auto& word : words) word.reset();
    bench_.dut.columns_i = std::min<uint64_t>(kConfig.window, frame.raster.width - window * kConfig.window);
    bench_.dut.rows_i = std::min<uint64_t>(kConfig.window, frame.raster.height - window * kConfig.window);
  }
  void drive() override {
    auto& dut = bench_.dut;
    if (next_window_) start_window();
    next_window_ = false;
    if (!up_ && !beats.empty() && goes(in_pace_, bench_.rng)) up_ = true;
    dut.in_valid_i = up_;
    if (up_) {
      write_record(kConfig, dut.in_i, beats.front().blend);
      write_port(dut.in_line_i, pack_codes(kConfig, beats.front().codes).data());
    }
    dut.resolve_ready_i = goes(resolve_pace_, bench_.rng);
    Words noise(port_words<decltype(dut.rdata_i)>() + 2);
    if (read_) {  // the buffer holds its output
      for (uint32_t& word : noise) word = static_cast<uint32_t>(bench_.rng());
      write_port(dut.rdata_i, words[*read_] ? words[*read_]->data() : noise.data());
      dut.fresh_i = !words[*read_];
      read_.reset();
    }
  }
  void observe() override {
    auto& dut = bench_.dut;
    if (dut.read_o) read_ = dut.raddr_o;
    if (dut.read_o && dut.write_o && dut.raddr_o == dut.waddr_o)
      ADD_FAILURE() << "read and write of one word in one cycle";
    const bool taken = up_ && dut.in_ready_o;
    EXPECT_EQ(dut.layer_done_o, taken && beats.front().blend.kind != kData) << "cycle " << bench_.cycle;
    if (taken) take_beat();  // in the cycle of its last quarter, which is that of its first word's write
    if (dut.write_o) take_word();
  }
  void take_word() {
    auto& dut = bench_.dut;
    Words found(port_words<decltype(dut.wdata_o)>() + 2);
    read_port(dut.wdata_o, found.data());
    ASSERT_FALSE(expected_.empty()) << "a word too many, cycle " << bench_.cycle;
    ASSERT_EQ(dut.tap_region_o, expected_.front().region) << "cycle " << bench_.cycle;
    ASSERT_EQ(dut.tap_quarter_o, expected_.front().quarter) << "cycle " << bench_.cycle;
    ASSERT_EQ(pixel_difference(kConfig, expected_.front().word, found), "")
        << "region " << expected_.front().region << " quarter " << expected_.front().quarter << " cycle "
        << bench_.cycle << " seed " << bench_.seed;
    ASSERT_EQ(dut.waddr_o, ru_slot(kConfig, expected_.front().region) * 4 + expected_.front().quarter);
    words[dut.waddr_o] = found;
    expected_.pop_front();
    cycles.push_back(bench_.cycle);
  }
  void take_beat() {
    auto& dut = bench_.dut;
    const Beat beat = beats.front();
    const Blend& blend = beat.blend;
    beats.pop_front();
    up_ = false;
    if (blend.kind == kData) {
      const uint32_t color[3] = {static_cast<uint32_t>(blend.red), static_cast<uint32_t>(blend.green),
                                 static_cast<uint32_t>(blend.blue)};
      ru_blend_region(kBlend, regions[blend.region], beat.codes.data(), color);
      touched |= uint64_t{1} << blend.region;
      for (int q = 0; q < 4; ++q) expected_.push_back({blend.region, q, pixel_word(kConfig, regions[blend.region], q)});
      return;
    }
    EXPECT_TRUE(expected_.empty()) << "an end passed before all words were written";
    uint64_t done = 0;
    for (int r = 0; r < kConfig.regions(); ++r)
      done |= uint64_t{kConfig.early_stop && (touched >> r & 1) && regions[r].all_done()} << r;
    EXPECT_EQ(dut.done_o, done) << "cycle " << bench_.cycle;
    EXPECT_EQ(dut.window_done_o, blend.kind == kWindowEnd);
    if (blend.kind != kWindowEnd) return;
    EXPECT_TRUE(dut.resolve_ready_i);
    window = (window + 1) % 3;
    next_window_ = true;
  }
  void push(const Beat& beat) { beats.push_back(beat); }

  struct Expected {
    uint64_t region;
    int quarter;
    Words word;
  };
  std::deque<Beat> beats;
  std::vector<RegionState> regions;
  std::vector<std::optional<Words>> words;
  std::vector<uint64_t> cycles;  // of each word
  Frame frame;
  uint64_t window = 0, touched = 0;

 private:
  Bench<Vru_lanes>& bench_;
  Pace in_pace_, resolve_pace_;
  std::deque<Expected> expected_;
  std::optional<int> read_;
  bool up_ = false, next_window_ = false;
};

Beat random_beat(std::mt19937_64& rng, int unit, int strength, uint64_t kind = kData) {
  Beat beat{random_record<Blend>(kConfig, rng), random_codes(kConfig, rng, strength)};
  beat.blend.kind = kind;
  beat.blend.region = ru_region(kConfig, unit, rng() % (kConfig.regions() / kConfig.units));
  return beat;
}

void run(Bench<Vru_lanes>& bench, Around& around) {
  for (uint64_t limit = bench.cycle + 200000; !around.beats.empty() || bench.dut.busy_o;) {
    ASSERT_LT(bench.cycle, limit) << "nothing more came";
    bench.step();
    if (testing::Test::HasFailure()) return;
  }
}

TEST(RuLanes, EqualsItsModelOverLayersAndWindows) {
  for (const Pace in_pace : kPaces) {
    for (const Pace resolve_pace : kPaces) {
      Bench<Vru_lanes> bench;
      Around around(bench, in_pace, resolve_pace);
      bench.reset();
      const int unit = bench.rng() % kConfig.units;
      for (int i = 0; i < 1500; ++i) {
        const uint64_t dice = bench.rng() % 300;
        Beat beat = random_beat(bench.rng, unit, bench.rng() % 3, dice < 2 ? kWindowEnd : dice < 6 ? kLayerEnd : kData);
        if (i > 0 && i % 3 == 0) beat.blend.region = around.beats.back().blend.region;  // the same region right again
        around.push(beat);
      }
      around.push(random_beat(bench.rng, unit, 0, kWindowEnd));
      ASSERT_NO_FATAL_FAILURE(run(bench, around));
      if (HasFailure()) return;
    }
  }
}

TEST(RuLanes, ARegionTakesFourCycles) {
  for (const bool same : {true, false}) {
    Bench<Vru_lanes> bench;
    Around around(bench, Pace::kAlways, Pace::kAlways);
    bench.reset();
    for (int i = 0; i < 100; ++i) {
      Beat beat = random_beat(bench.rng, 0, 0);
      if (same) beat.blend.region = 0;
      around.push(beat);
    }
    ASSERT_NO_FATAL_FAILURE(run(bench, around));
    ASSERT_EQ(around.cycles.size(), 400u);
    EXPECT_EQ(around.cycles.back() - around.cycles.front(), 399u);
  }
}

}  // namespace
}  // namespace pipegs
