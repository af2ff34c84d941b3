// SPDX-License-Identifier: Apache-2.0
// ru_quads_test: rtl/ru/live/ru_quads.sv (group 0) against cpp_model/ru/ru_quads.hpp, with the pixels as an array; the
// other groups in ru_live. Jobs of ru_drain clear all words before a window, and words of the last slot at any time.
#include <optional>

#include "cpp_model/pu/rows/pu_alpha.hpp"
#include "verif/ru/pixel_words.hpp"
#include "cpp_model/ru/ru_walk.hpp"
#include "verif/support/config.hpp"
#include "Vru_quads.h"

namespace pipegs {
namespace {

const Config kConfig = test_config();
const BlendConstants kBlend(kConfig);
const PuAlpha kAlpha(kConfig);
constexpr int kGroup = 0;
const int kSlots = kConfig.regions() / kConfig.units;

// T = 1, black: what a job leaves behind.
const Words kClear = [] {
  RegionState region{};
  std::fill(std::begin(region.t), std::end(region.t), 1u << (kConfig.t_w - 1));
  return pixel_word(kConfig, region, 0, kGroup);
}();

// One half of a region: what goes in, and what its quads are blended with.
struct Half {
  int region, half;
  uint32_t live;
  uint64_t index;
  uint32_t color[3];
  Exponent exponents[2 * kQuadPixels];
};

// Gives halves, is the pixel buffer, begins windows; keeps the golden state beside it.
class Around : public Endpoint {
 public:
  Around(Bench<Vru_quads>& bench, Pace pace, int unit)
      : bench_(bench),
        unit_(unit),
        in_(bench, bench.dut.in_valid_i, bench.dut.in_ready_o, bench.dut.in_i, pace),
        buffer_(4 * kSlots) {
    bench.dut.clear_i = bench.dut.drain_i = 0;
    bench.add(*this);
    frame_.raster.width = 2 * kConfig.window + 1 + bench.rng() % kConfig.window;
    frame_.raster.height = 2 * kConfig.window + 1 + bench.rng() % kConfig.window;
  }
  // Everything of the window before has been blended.
  void start_window(uint64_t window) {
    regions_.clear();
    std::vector<uint32_t> outside;  // quads of each slot
    for (int slot = 0; slot < kSlots; ++slot) {
      regions_.push_back(ru_fresh_region(kConfig, frame_, window, window, ru_region(kConfig, unit_, slot)));
      outside.push_back(ru_stopped_quads(regions_.back()));
    }
    auto& dut = bench_.dut;
    for (int address = 0; address < 4 * kSlots; ++address) {
      to_drain_ = address;
      while (to_drain_ && !testing::Test::HasFailure()) bench_.step();
    }
    for (int i = 0; i < 8; ++i) bench_.step();
    dut.columns_i = std::min<uint64_t>(kConfig.window, frame_.raster.width - window * kConfig.window);
    dut.rows_i = std::min<uint64_t>(kConfig.window, frame_.raster.height - window * kConfig.window);
    write_port(dut.outside_i, words_of(outside).data());
    dut.clear_i = 1;
    clear_ = outside;
    bench_.step();
    dut.clear_i = 0;
    write_port(dut.outside_i, Words(port_words<decltype(dut.outside_i)>() + 1).data());
  }
  void push(const Half& half) {
    Words words(port_words<decltype(Vru_quads::in_i)>() + 2);
    const int width = record_width<Exponent>(kConfig);
    for (int i = 0; i < 2 * kQuadPixels; ++i) {
      Words one(2);
      pack(kConfig, half.exponents[i], one.data());
      put_bits(words.data(), i * width, width, one[0]);
    }
    in_.push(words);
    halves_.push_back(half);
  }
  void drive() override {
    auto& dut = bench_.dut;
    if (dut.in_valid_i) {
      const Half& half = halves_[in_.taken];
      dut.in_live_i = half.live;
      dut.in_half_i = half.half;
      dut.in_region_i = half.region;
      dut.in_color_i =
          ((uint64_t{half.color[2]} << kConfig.color_w | half.color[1]) << kConfig.color_w) | half.color[0];
      dut.in_index_i = half.index;
    }
    if (read_) {  // the buffer holds its output
      Words noise(port_words<decltype(dut.rdata_i)>() + 2);
      for (uint32_t& word : noise) word = static_cast<uint32_t>(bench_.rng());
      write_port(dut.rdata_i, buffer_[*read_] ? buffer_[*read_]->data() : noise.data());
      read_.reset();
    }
    if (spare_jobs && !to_drain_ && ++since_job_ > 8 && bench_.rng() % 8 == 0)
      to_drain_ = 4 * (kSlots - 1) + bench_.rng() % 4;
    dut.drain_i = to_drain_ && bench_.rng() % 4 != 0;
    if (dut.drain_i) dut.drain_address_i = *to_drain_, since_job_ = 0;
  }
  void observe() override {
    auto& dut = bench_.dut;
    if (dut.read_o) read_ = dut.raddr_o;
    EXPECT_FALSE(dut.read_o && dut.write_o && dut.raddr_o == dut.waddr_o) << "a word is read and written at once";
    if (!dut.busy_o) {
      EXPECT_TRUE(expected_.empty() && next_ == taken_) << "not busy with something inside, cycle " << bench_.cycle;
    }
    taken_ = in_.taken;
    Words found(port_words<decltype(dut.stopped_o)>() + 1);
    read_port(dut.stopped_o, found.data());
    if (!stopped_.empty()) { EXPECT_EQ(found, words_of(stopped_)) << "cycle " << bench_.cycle; }
    if (dut.clear_i) stopped_ = clear_;
    if (dut.write_o) ASSERT_NO_FATAL_FAILURE(take_word());
    EXPECT_EQ(dut.tap_word_valid_o && !dut.write_o, 0);
    if (dut.tap_quad_valid_o) ASSERT_NO_FATAL_FAILURE(take_quad());
    if (jobs_[1]) {
      ASSERT_FALSE(dut.tap_quad_valid_o) << "a job and a quad at once, cycle " << bench_.cycle;
      ASSERT_TRUE(dut.read_o && dut.raddr_o == *jobs_[1]) << "a job does not read its word, cycle " << bench_.cycle;
      expected_.push_back({0, *jobs_[1], kClear, false, true});
    }
    jobs_[1] = jobs_[0];
    jobs_[0].reset();
    if (dut.drain_i) {
      EXPECT_FALSE(dut.issue_o) << "a quad starts in a job's turn, cycle " << bench_.cycle;
      jobs_[0] = to_drain_;
      to_drain_.reset();
    }
    if (dut.issue_o) issues.push_back(bench_.cycle);
  }
  // A quad's codes are known, in the order in which its halves were given.
  void take_quad() {
    auto& dut = bench_.dut;
    ASSERT_LT(next_, halves_.size()) << "a quad too many, cycle " << bench_.cycle;
    const Half& half = halves_[next_];
    const int j = second_ || !(half.live & 1), row = 2 * half.half + j, quad = ru_quad(kGroup, row);
    second_ = j == 0 && half.live == 3;
    next_ += !second_;
    ASSERT_EQ(dut.tap_quad_index_o, half.index) << "cycle " << bench_.cycle;
    ASSERT_EQ(dut.tap_quad_region_o, half.region) << "cycle " << bench_.cycle;
    ASSERT_EQ(dut.tap_quad_row_o, row) << "cycle " << bench_.cycle;
    uint16_t codes[kRegionPixels] = {};
    for (int i = 0; i < kQuadPixels; ++i) {
      const Exponent& exponent = half.exponents[kQuadPixels * j + i];
      uint16_t& code = codes[ru_quad_pixel(quad, i)];
      code = static_cast<uint16_t>(code_of(exponent));
      Words found(port_words<decltype(dut.tap_quad_o)>() + 1);
      read_port(dut.tap_quad_o, found.data());
      ASSERT_EQ(get_bits(found.data(), i * kConfig.alpha_w, kConfig.alpha_w), code) << "cycle " << bench_.cycle;
    }
    RegionState& state = regions_[ru_slot(kConfig, half.region)];
    ru_blend_quad(kBlend, state, quad, codes, half.color);
    expected_.push_back({half.region, row, pixel_word(kConfig, state, row, kGroup),
                         static_cast<bool>(ru_stopped_quads(state) >> quad & 1), false});
  }
  void take_word() {
    auto& dut = bench_.dut;
    Words found(port_words<decltype(dut.wdata_o)>() + 2);
    read_port(dut.wdata_o, found.data());
    ASSERT_FALSE(expected_.empty()) << "a word too many, cycle " << bench_.cycle;
    const Expected expected = expected_.front();
    expected_.pop_front();
    ASSERT_EQ(dut.tap_word_valid_o, !expected.job) << "cycle " << bench_.cycle;
    if (expected.job) {
      ASSERT_EQ(dut.waddr_o, expected.row) << "cycle " << bench_.cycle;
      ASSERT_EQ(pixel_difference(kConfig, kClear, found), "") << "a job leaves something, cycle " << bench_.cycle;
      buffer_[dut.waddr_o] = found;
      return;
    }
    ASSERT_EQ(dut.tap_word_region_o, expected.region) << "cycle " << bench_.cycle;
    ASSERT_EQ(dut.tap_word_row_o, expected.row) << "cycle " << bench_.cycle;
    const int slot = ru_slot(kConfig, expected.region);
    ASSERT_EQ(dut.waddr_o, 4 * slot + expected.row) << "cycle " << bench_.cycle;
    ASSERT_EQ(pixel_difference(kConfig, expected.word, found), "")
        << "region " << expected.region << " row " << expected.row << " cycle " << bench_.cycle << " seed "
        << bench_.seed;
    buffer_[dut.waddr_o] = found;
    if (expected.stopped) stopped_[slot] |= 1u << ru_quad(kGroup, expected.row);
  }
  void run() {
    bench_.run_until(
        [&] { return (in_.empty() && next_ == halves_.size() && !bench_.dut.busy_o) || testing::Test::HasFailure(); });
  }

  std::vector<uint64_t> issues;  // cycles in which a quad starts
  bool spare_jobs = false;       // in the last slot

 private:
  struct Expected {
    int region, row;  // of a job: the word's address
    Words word;
    bool stopped, job;
  };
  // The quads of the group, row by row of each slot, as a port has them.
  static Words words_of(const std::vector<uint32_t>& slots) {
    Words words(port_words<decltype(Vru_quads::stopped_o)>() + 1);
    for (size_t i = 0; i < 4 * slots.size(); ++i) {
      const int row = static_cast<int>(i % 4);
      put_bits(words.data(), static_cast<int>(i), 1, slots[i / 4] >> ru_quad(kGroup, row) & 1);
    }
    return words;
  }
  static uint32_t code_of(const Exponent& e) {
    const int64_t low = kConfig.power_f - kConfig.exp_f();
    const int64_t fraction = static_cast<int64_t>(e.fraction) << low;
    // power = fraction - whole, in units of 2^-PowerF
    return e.visible ? kAlpha(fraction - static_cast<int64_t>(e.whole << kConfig.power_f)) : 0;
  }

  Bench<Vru_quads>& bench_;
  int unit_;
  WordSource<decltype(Vru_quads::in_i)> in_;
  Frame frame_;
  std::vector<RegionState> regions_;          // by slot
  std::vector<uint32_t> stopped_, clear_;     // quads by slot; those of the window that begins
  std::vector<std::optional<Words>> buffer_;  // empty: never written
  std::vector<Half> halves_;
  size_t taken_ = 0, next_ = 0;  // halves taken, the one whose quad comes next
  bool second_ = false;
  std::deque<Expected> expected_;
  int since_job_ = 0;                             // cycles: a word is drained once in a window
  std::optional<int> read_, to_drain_, jobs_[2];  // jobs_: of one and two cycles ago
};

// Powers from just above 0 to just below the cut; near 0 they close pixels quickly.
Half random_half(std::mt19937_64& rng, int unit, uint64_t index, bool strong, int slots = kSlots) {
  Half half{.region = ru_region(kConfig, unit, static_cast<int>(rng() % static_cast<uint64_t>(slots))),
            .half = static_cast<int>(rng() % 2),
            .live = static_cast<uint32_t>(1 + rng() % 3),
            .index = index,
            .color = {},
            .exponents = {}};
  for (uint32_t& channel : half.color) channel = rng() % (1u << kConfig.color_w);
  for (Exponent& exponent : half.exponents) {
    const int64_t depth = static_cast<int64_t>(rng() % static_cast<uint64_t>(kConfig.power_cut() + 1000));
    exponent = kAlpha.exponent(500 - (strong ? depth / 8 : depth));
  }
  return half;
}

TEST(RuQuads, EqualsItsModelOverWindowsAtEveryPace) {
  for (const Pace pace : kPaces) {
    for (int unit = 0; unit < kConfig.units; ++unit) {
      Bench<Vru_quads> bench(test_seed() + unit);
      Around around(bench, pace, unit);
      bench.reset();
      around.spare_jobs = kSlots > 1;
      uint64_t index = 0;
      for (const uint64_t window : {0, 2, 1, 2, 0}) {
        around.start_window(window);
        int last = ru_region(kConfig, unit, 0);
        for (int i = 0; i < 600; ++i) {
          Half half = random_half(bench.rng, unit, index++, bench.rng() % 2 == 0, std::max(1, kSlots - 1));
          if (i % 3 != 0) half.region = last;  // the same region right again
          last = half.region;
          around.push(half);
        }
        around.run();
        if (HasFailure()) FAIL() << to_text(pace) << ", window " << window << ", seed " << bench.seed;
      }
    }
  }
}

TEST(RuQuads, StartsAQuadEveryCycle) {
  for (const uint32_t live : {1u, 2u, 3u}) {
    Bench<Vru_quads> bench;
    Around around(bench, Pace::kAlways, 0);
    bench.reset();
    around.start_window(0);
    const int slots = kConfig.regions() / kConfig.units, count = 200, quads = live == 3 ? 2 : 1;
    if (slots < 2 && live != 3) continue;  // no four different quads
    for (int i = 0; i < count; ++i) {
      Half half = random_half(bench.rng, 0, i, false);
      half.live = live;
      half.half = i % 2;
      half.region = ru_region(kConfig, 0, i / 2 % slots);
      around.push(half);
    }
    around.run();
    ASSERT_EQ(around.issues.size(), size_t(quads * count));
    EXPECT_EQ(around.issues.back() - around.issues.front(), around.issues.size() - 1) << "live " << live;
  }
}

// Of one half the first quad, or both in turn: each waits until it was written.
TEST(RuQuads, AQuadComesAgainAfterFourCycles) {
  for (const uint32_t live : {1u, 3u}) {
    Bench<Vru_quads> bench;
    Around around(bench, Pace::kAlways, 0);
    bench.reset();
    around.start_window(0);
    const int count = 100, quads = live == 3 ? 2 : 1;
    for (int i = 0; i < count; ++i) {
      Half half = random_half(bench.rng, 0, i, false);
      half.live = live;
      half.half = 1;
      half.region = ru_region(kConfig, 0, 0);
      around.push(half);
    }
    around.run();
    ASSERT_EQ(around.issues.size(), size_t(quads * count));
    for (size_t i = quads; i < around.issues.size(); ++i)
      EXPECT_EQ(around.issues[i] - around.issues[i - quads], 4u) << "live " << live << " quad " << i;
  }
}

}  // namespace
}  // namespace pipegs
