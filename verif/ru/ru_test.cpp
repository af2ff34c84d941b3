// SPDX-License-Identifier: Apache-2.0
// ru_test: rtl/ru/pipegs_ru.sv, whole frames, against cpp_model/ru/ru.hpp; its clock only ticks when the RU asks for
// it.
#include "cpp_model/pu/rows/pu_rows.hpp"
#include "cpp_model/ru/ru.hpp"
#include "verif/ru/alpha_lines.hpp"
#include "verif/ru/pixel_words.hpp"
#include "verif/ru/region_ports.hpp"
#include "verif/ru/written_pixels.hpp"
#include "verif/ru/live/random_splat.hpp"
#include "verif/support/config.hpp"
#include "Vpipegs_ru.h"
#include "verif/support/frame_ports.hpp"

namespace pipegs {
namespace {

const Config kConfig = test_config();
const BlendConstants kBlend(kConfig);
const PuRows kRows(kConfig);
const bool kLate = !kConfig.caches_alphas();
using LinePort = std::remove_reference_t<decltype(Vpipegs_ru::rsp_data_i)>;

struct Paces {
  Pace in = Pace::kAlways, stores = Pace::kAlways, memory = Pace::kAlways;
  ExternalMemoryOptions options = {.latency = 20};
};

// The other RU of the pair, in raster order: its rows come, or it takes ours, at some pace.
class OtherRu : public Endpoint {
 public:
  OtherRu(Bench<Vpipegs_ru>& bench, Pace pace) : bench_(bench), pace_(pace) {
    auto& dut = bench.dut;
    dut.pair_valid_i = dut.pair_taken_i = dut.pair_at_end_i = 0;
    bench.add(*this);
  }
  void drive() override {
    auto& dut = bench_.dut;
    if (!waits_) {
      waits_ = goes(pace_, bench_.rng);
      for (uint32_t& word : row_) word = static_cast<uint32_t>(bench_.rng());
    }
    dut.pair_valid_i = waits_;
    write_port(dut.pair_row_i, row_.data());
    dut.pair_at_end_i = goes(pace_, bench_.rng);
    const auto slots = static_cast<uint64_t>(kConfig.regions() / kConfig.units);
    std::vector<uint32_t> wanted(port_words<decltype(dut.pair_wanted_i)>() + 1);
    put_bits(wanted.data(), static_cast<int>(bench_.rng() % slots), 1, bench_.rng() % 2);
    write_port(dut.pair_wanted_i, wanted.data());
    dut.pair_taken_i = 0;
    dut.eval();
    dut.pair_taken_i = odd() && joined && dut.pair_valid_o && waits_;
  }
  void observe() override {
    auto& dut = bench_.dut;
    if (!joined) return;
    if (kConfig.quads && dut.active_o && dut.window_done_o) {
      ASSERT_TRUE(dut.pair_at_end_i && dut.pair_at_end_o) << "a window ends alone, cycle " << bench_.cycle;
    }
    if (!odd() && dut.pair_taken_o) {
      ASSERT_TRUE(waits_ && dut.pair_valid_o) << "a line leaves without one of its halves, cycle " << bench_.cycle;
      waits_ = false;
    }
    if (dut.pair_taken_i) {
      std::array<uint32_t, 8> row;
      read_port(dut.pair_row_o, row.data());
      rows.insert(row);
      waits_ = false;
    }
  }
  bool joined = false;
  std::multiset<std::array<uint32_t, 8>> rows;  // that an odd RU gave us

 private:
  bool odd() const { return bench_.dut.unit_i % 2 != 0; }

  Bench<Vpipegs_ru>& bench_;
  Pace pace_;
  bool waits_ = false;
  std::array<uint32_t, 8> row_;
};

class RuBench : public Bench<Vpipegs_ru> {
 public:
  explicit RuBench(const Paces& paces, int unit, uint64_t seed = test_seed())
      : Bench(seed),
        unit(unit),
        memory(paces.options),
        in(*this, kConfig, dut.in_valid_i, dut.in_ready_o, dut.in_i, paces.in),
        stores(*this, kConfig, paces.stores),
        port(*this, memory, dut.mem_valid_o, dut.mem_ready_i, &dut.mem_write_o, dut.mem_address_o, &dut.mem_data_o,
             dut.rsp_valid_i, dut.rsp_data_i, paces.memory),
        other(*this, paces.memory) {
    port.halves = &dut.mem_halves_o;
    dut.unit_i = unit;
    dut.restart_i = 0;
    reset();
  }

  void start(const Frame& new_frame, bool raster = false) {
    frame = new_frame;
    picture = random_picture(kConfig, frame, rng, raster);
    write_port(dut.picture_i, picture_words(kConfig, picture).data());
    frame.raster.aovs = random_aovs(kConfig, frame, picture, rng);
    random_eyes(kConfig, picture, rng, frame);
    write_aovs(kConfig, dut, frame, picture);
    other.joined = ru_joined(kConfig, picture);
    write_frame(kConfig, dut, frame);
    dut.restart_i = 1;
    cycle_once();
    dut.restart_i = 0;
    if (kConfig.quads) cycle_once();  // it finds out what lies outside
    state = tapped = ru_start(kConfig, frame, unit);
    ends = ends_seen = windows = windows_seen = 0;
    EXPECT_TRUE(read_regions(kConfig, dut.done_o) == state.done) << "regions outside the image are done from the start";
  }

  // A splat whose lines lie in a store or in memory, or which has coefficients instead; the golden RU takes it at once,
  // the module when it comes to it.
  void send(uint64_t kind, uint64_t mask = 0, bool ext = false, int strength = 0) {
    send_to(rng() % kConfig.parts(), kind, mask, ext, strength);
  }
  void send_region(int region, int strength) {
    send_to(region_part(kConfig, region), kData, uint64_t{1} << region_bit(kConfig, region), false, strength);
  }
  void send_to(uint64_t part, uint64_t kind, uint64_t mask, bool ext, int strength) {
    Sorted splat = random_record<Sorted>(kConfig, rng);
    splat.kind = kind;
    splat.part = part;
    splat.index = next_index++;
    splat.mask = mask;
    splat.unit %= kConfig.units;
    if (kLate) {
      give_coefficients(kConfig, rng, strength, splat);
    } else {
      splat.ext = ext;
      if (ext) next_address ^= rng() % 2 << ru_number_w(kConfig);
      splat.address = next_address;
    }
    colors[splat.index] = splat;
    for (uint64_t rest = kind == kData ? mask : 0; rest != 0; rest &= rest - 1) {
      const int bit = std::countr_zero(rest), region = region_number(kConfig, part, bit);
      if (kLate) {
        pu_region_line(kRows, job_of(splat), bit, codes[{splat.index, region}].data());
        continue;
      }
      const uint64_t line = next_address++;
      const Codes one = codes[{splat.index, region}] = random_codes(kConfig, rng, strength);
      if (!ext) {
        if (ru_owner(kConfig, region) == unit) stores.lines[{static_cast<int>(splat.unit), line}] = one;
        continue;
      }
      const uint64_t other_area = uint64_t{1} << ru_number_w(kConfig);
      store_line(kConfig, memory, ru_overflow_line(kConfig, wide_overflow(frame), splat.unit, line), one);
      store_line(kConfig, memory, ru_overflow_line(kConfig, wide_overflow(frame), splat.unit, line ^ other_area),
                 random_codes(kConfig, rng, 1));
    }
    in.push(splat);
    ru_take(
        kConfig, kBlend, frame, picture, state, splat,
        [&](const Sorted& s, int region) {
          return codes.at({s.index, region}).data();
        },
        [&](uint64_t address, int halves, const MemoryLine& pixels) {
          if (other.joined && unit % 2 != 0) {
            std::array<uint32_t, 8> row;
            std::copy_n(pixels.begin() + (halves == 2 ? 8 : 0), 8, row.begin());
            rows.insert(row);
            return;
          }
          ++requests;
          const bool outside = other.joined && !WrittenPixels::wide(frame, picture, address);  // the right half
          theirs += other.joined && (halves == 2 || !outside);
          if (outside && halves == 2) return;
          for (size_t i = 0; i < 16; ++i) {
            if ((halves >> i / 8 & 1) != 0) lines[{address, i / 8}][i % 8] = pixels[i];
          }
        });
    ends += kind != kData;
    windows += kind == kWindowEnd;
  }

  // One cycle; the clock rises only when the module asks for it.
  void cycle_once() {
    dut.clk_i = 0;
    for (Endpoint* endpoint : endpoints_) endpoint->drive();
    dut.eval();
    for (Endpoint* endpoint : endpoints_) endpoint->observe();
    observe_taps();
    if (dut.mem_valid_o && !dut.mem_write_o) { EXPECT_EQ(dut.mem_halves_o, 3) << "a read is of the whole line"; }
    active_cycles += dut.active_o;
    perf[dut.perf_o] += dut.active_o;
    if (dut.active_o) {
      dut.clk_i = 1;
      dut.eval();
    }
    ++cycle;
  }

  void observe_taps() {
    const RegionSet done = dut.active_o ? read_regions(kConfig, dut.done_o) : RegionSet{};
    for (int region = 0; region < kConfig.regions(); ++region) {
      if (!done.has(kConfig, region)) continue;
      ASSERT_TRUE(ru_owner(kConfig, region) == unit && tapped.regions[ru_slot(kConfig, region)].all_done())
          << "region " << region << " is not done, cycle " << cycle;
    }
    for (int lane = 0; lane < kConfig.tap_lanes(); ++lane) {
      if (dut.tap_line_valid_o >> lane & 1) ASSERT_NO_FATAL_FAILURE(observe_line(lane));
      if (dut.tap_word_valid_o >> lane & 1) ASSERT_NO_FATAL_FAILURE(observe_word(lane));
    }
    if (dut.active_o && dut.layer_done_o) ++ends_seen;
    if (dut.active_o && dut.window_done_o) {
      ++windows_seen;
      tapped.window_x == frame.raster.windows.last_x
          ? (tapped.window_x = frame.raster.windows.first_x, ++tapped.window_y)
          : ++tapped.window_x;
      ru_start_window(kConfig, frame, tapped);
    }
  }

  // Alphas are consumed: of a region, or of a quad.
  void observe_line(int lane) {
    const uint64_t index = field(dut.tap_line_index_o, lane, kConfig.shown_index_w());
    const int region = static_cast<int>(field(dut.tap_line_region_o, lane, kConfig.region_w()));
    const int row = static_cast<int>(field(dut.tap_line_quarter_o, lane, 2));
    const Codes& one = codes.at({index, region});
    const int count = kConfig.quads ? kQuadPixels : kRegionPixels;
    for (int i = 0; i < count; ++i) {
      const uint64_t found = field(dut.tap_line_o, lane * count + i, kConfig.alpha_w);
      ASSERT_EQ(found, one[kConfig.quads ? ru_word_pixel(kConfig, lane, row, i) : i])
          << "alpha " << i << " of " << index << " region " << region << " lane " << lane << " cycle " << cycle;
    }
    const Sorted& splat = colors.at(index);
    const uint32_t color[3] = {static_cast<uint32_t>(splat.red), static_cast<uint32_t>(splat.green),
                               static_cast<uint32_t>(splat.blue)};
    const int slot = ru_slot(kConfig, region);
    RegionState& state_of = tapped.regions[slot];
    if (kConfig.quads) {
      const int quad = ru_quad(lane, row);
      ASSERT_TRUE(ru_live_quads(one.data(), 0) >> quad & 1) << "no pixel of the quad is visible, cycle " << cycle;
      RegionAovs* const aovs = kConfig.has_aovs() ? &tapped.aovs[slot] : nullptr;
      const RegionState earlier = state_of;
      ru_blend_quad(kBlend, state_of, quad, one.data(), color);
      if (aovs != nullptr) {
        Codes of_quad{};
        for (int i = 0; i < kQuadPixels; ++i) of_quad[ru_quad_pixel(quad, i)] = one[ru_quad_pixel(quad, i)];
        ru_add_region_aovs(kConfig, kBlend, *aovs, earlier, state_of, of_quad.data(),
                           ru_linear(kConfig, splat.depth, frame.raster.aovs.range), index);
      }
      expected_words[lane].push_back({region, row, pixel_word(kConfig, state_of, row, lane, aovs)});
    } else {
      ru_blend_region(kBlend, state_of, one.data(), color);
      for (int q = 0; q < 4; ++q) expected_words[lane].push_back({region, q, pixel_word(kConfig, state_of, q)});
    }
    if (lane == 0) line_cycles.push_back(cycle);
  }

  // Pixels are written back.
  void observe_word(int lane) {
    Words all(port_words<decltype(dut.tap_word_o)>() + 2), found(pixel_word_width(kConfig) / 32 + 2);
    read_port(dut.tap_word_o, all.data());
    copy_bits(all.data(), lane * pixel_word_width(kConfig), found.data(), 0, pixel_word_width(kConfig));
    ASSERT_FALSE(expected_words[lane].empty());
    const ExpectedWord& expected = expected_words[lane].front();
    ASSERT_EQ(field(dut.tap_word_region_o, lane, kConfig.region_w()), expected.region) << "cycle " << cycle;
    ASSERT_EQ(field(dut.tap_word_quarter_o, lane, 2), expected.part) << "cycle " << cycle;
    ASSERT_EQ(pixel_difference(kConfig, expected.word, found), "")
        << "region " << expected.region << " part " << expected.part << " lane " << lane << " cycle " << cycle
        << " seed " << seed;
    expected_words[lane].pop_front();
  }

  // Entry i of a port that is an array of fields.
  template <class Port>
  static uint64_t field(const Port& port, int i, int width) {
    Words words(port_words<Port>() + 2);
    read_port(port, words.data());
    return get_bits(words.data(), i * width, width);
  }

  uint64_t wanted_aovs() const {
    uint64_t wanted = 0;
    for (const Aov aov : kAovs) wanted |= uint64_t{wants_aov(kConfig, frame, aov)} << static_cast<int>(aov);
    return wanted;
  }

  // Runs until the RU is idle and compares the frame in memory.
  void finish() {
    for (const uint64_t limit = cycle + 2000000; !in.empty() || !dut.idle_o;) {
      ASSERT_LT(cycle, limit) << "nothing more came, seed " << seed;
      cycle_once();
      if (testing::Test::HasFailure()) return;
    }
    EXPECT_TRUE(stores.lines.empty()) << "lines of this RU's regions are neither read nor free";
    EXPECT_EQ(ends_seen, ends);
    EXPECT_EQ(windows_seen, windows);
    EXPECT_EQ(dut.done_x_o, state.window_x);
    EXPECT_EQ(dut.done_y_o, state.window_y);
    const ExternalMemory::Traffic& traffic = memory.traffic()[0];
    EXPECT_EQ(traffic.lines_written - before.lines_written, requests)
        << "lines outside the image were written, or some twice";
    EXPECT_EQ(traffic.halves_written - before.halves_written, lines.size() + theirs) << "other halves were written";
    EXPECT_TRUE(other.rows == rows) << "rows for the other RU, seed " << seed;
    before = traffic;
    requests = theirs = 0;
    rows.clear();
    other.rows.clear();
    for (const auto& [place, pixels] : lines) {
      const MemoryLine& line = memory.line(place.first);
      for (size_t i = 0; i < pixels.size(); ++i) {
        ASSERT_EQ(line[8 * place.second + i], pixels[i])
            << "line " << place.first << " half " << place.second << " word " << i << " seed " << seed;
      }
    }
    lines.clear();
  }

  int unit;
  Frame frame;
  RuState state, tapped;  // after all beats sent; after the lines that the module consumed
  ExternalMemory memory;
  RecordSource<Sorted, decltype(dut.in_i)> in;
  AlphaStores<Vpipegs_ru> stores;
  MemoryEndpoint<QData, LinePort> port;
  OtherRu other;
  std::map<std::pair<uint64_t, int>, Codes> codes;
  std::map<uint64_t, Sorted> colors;
  Picture picture;
  std::map<std::pair<uint64_t, size_t>, std::array<uint32_t, 8>> lines;  // by line and half
  uint64_t requests = 0, theirs = 0;            // that write them, and rows of the other RU among them
  std::multiset<std::array<uint32_t, 8>> rows;  // for the other RU
  ExternalMemory::Traffic before;
  struct ExpectedWord {
    int region, part;  // a quarter of the region, or a row of its quads
    Words word;
  };
  std::vector<std::deque<ExpectedWord>> expected_words{static_cast<size_t>(kConfig.tap_lanes())};
  std::vector<uint64_t> line_cycles;  // of the first lane of taps
  uint64_t next_index = 0, next_address = 0, ends = 0, ends_seen = 0, windows = 0, windows_seen = 0;
  uint64_t active_cycles = 0, perf[4] = {};
};

Frame random_frame(std::mt19937_64& rng, uint64_t width, uint64_t height) {
  Frame frame;
  frame.raster.width = width;
  frame.raster.height = height;
  frame.raster.windows.last_x = ru_windows_x(kConfig, frame) - 1;
  frame.raster.windows.last_y = ru_windows_y(kConfig, frame) - 1;
  frame.tables.pixels = 1000 + rng() % 1000;
  frame.tables.overflow = uint64_t{1} << 30;
  return frame;
}

uint64_t random_mask(std::mt19937_64& rng) {
  const uint64_t all = ~uint64_t{0} >> (64 - kConfig.mask_w());
  switch (rng() % 4) {
    case 0: return uint64_t{1} << rng() % kConfig.mask_w();
    case 1: return rng() & all;
    case 2: return rng() & rng() & rng() & all;
    default: return uint64_t{0x303} << rng() % kConfig.mask_w() & all;
  }
}

void send_frame(RuBench& bench, int splats, int ext_percent) {
  const uint64_t windows = (bench.frame.raster.windows.last_x - bench.frame.raster.windows.first_x + 1) *
                           (bench.frame.raster.windows.last_y - bench.frame.raster.windows.first_y + 1);
  for (uint64_t window = 0; window < windows; ++window) {
    const int layers = 1 + bench.rng() % 3;
    const int strength = bench.rng() % 3;
    for (int layer = 0; layer < layers; ++layer) {
      const int count = bench.rng() % 5 == 0 ? 0 : bench.rng() % splats;
      for (int i = 0; i < count; ++i) {
        bench.send(kData, random_mask(bench.rng), static_cast<int>(bench.rng() % 100) < ext_percent, strength);
      }
      bench.send(layer + 1 < layers ? kLayerEnd : kWindowEnd);
    }
  }
}

TEST(Ru, FramesEqualTheModelAtEveryPace) {
  for (const Pace in_pace : kPaces) {
    for (const Pace other_pace : kPaces) {
      Paces paces{in_pace, other_pace, other_pace, {.latency = 40, .jitter = 30}};
      RuBench bench(paces, 0);
      bench.unit = bench.dut.unit_i = bench.rng() % kConfig.units;
      const uint64_t sizes[][2] = {{17, 33}, {2ull * kConfig.window + 7, kConfig.window + 9ull}, {24, 40}, {1, 1}};
      for (const auto& size : sizes) {  // frames follow each other on the same module
        bench.start(random_frame(bench.rng, size[0], size[1]), bench.rng() % 2 != 0);
        send_frame(bench, 60, 30);
        ASSERT_NO_FATAL_FAILURE(bench.finish());
        if (HasFailure()) return;
      }
    }
  }
}

TEST(Ru, EveryUnitRendersItsOwnRegions) {
  for (int unit = 0; unit < kConfig.units; ++unit) {
    RuBench bench({}, unit, test_seed() + unit);
    bench.start(random_frame(bench.rng, kConfig.window + 30ull, 2ull * kConfig.window));
    send_frame(bench, 100, 10);
    ASSERT_NO_FATAL_FAILURE(bench.finish());
  }
}

TEST(Ru, EmptyWindowsAreWrittenBlack) {
  for (const bool raster : {false, true}) {
    RuBench bench({}, 0);
    bench.start(random_frame(bench.rng, 4ull * kConfig.window, 3ull * kConfig.window), raster);
    for (int i = 0; i < 12; ++i) bench.send(kWindowEnd);
    ASSERT_NO_FATAL_FAILURE(bench.finish());
  }
}

TEST(Ru, PartOfAFrameIsRendered) {
  for (const bool raster : {false, true}) {
    RuBench bench({}, kConfig.units - 1);
    Frame frame = random_frame(bench.rng, 5ull * kConfig.window, 5ull * kConfig.window);
    frame.raster.windows.first_x = 1;
    frame.raster.windows.last_x = 2;
    frame.raster.windows.first_y = 2;
    frame.raster.windows.last_y = 3;
    bench.start(frame, raster);
    send_frame(bench, 30, 20);
    ASSERT_NO_FATAL_FAILURE(bench.finish());
  }
}

TEST(Ru, AFullWindowClosesAllRegions) {
  if (!kConfig.early_stop) GTEST_SKIP() << "no pixel stops";
  RuBench bench({}, 0);
  const uint64_t side = kConfig.window, all = ~uint64_t{0} >> (64 - kConfig.mask_w());
  const auto send = [&](int i) { bench.send_to(static_cast<uint64_t>(i % kConfig.parts()), kData, all, false, 2); };
  RegionSet own;
  for (int part = 0; part < kConfig.parts(); ++part) own.mask[static_cast<size_t>(part)] = ru_own_mask(kConfig, 0);
  bench.start(random_frame(bench.rng, side, side));
  for (int i = 0; i < 60 * kConfig.parts(); ++i) send(i);
  const auto closed = [&] { return read_regions(kConfig, bench.dut.done_o) == own; };
  for (int i = 0; i < 200000 && !closed(); ++i) bench.cycle_once();
  EXPECT_TRUE(closed());
  while (!bench.in.empty() && !HasFailure()) bench.cycle_once();
  EXPECT_TRUE(bench.state.done == own);
  const int splats = 300;
  const uint64_t start = bench.cycle;
  for (int i = 0; i < splats; ++i) send(i);
  while (!bench.in.empty() && !HasFailure()) bench.cycle_once();
  // Where alphas are cached each line of it is freed.
  const int steps = kConfig.has_stores() ? kConfig.regions() / kConfig.units : 1;
  EXPECT_LE(bench.cycle - start, static_cast<uint64_t>(splats * steps) + 64) << "a done splat takes too long";
  bench.send(kWindowEnd);
  ASSERT_NO_FATAL_FAILURE(bench.finish());
}

// Lines of a region, or quads of it that the first group blends.
const int kLinesPerRegion = kConfig.quads ? 4 : 1;

const uint64_t kAllEyes = kConfig.eyes > 1 ? 3 : 0;  // the field is absent where there is one

// Splats of one region each, in turn: the lanes never wait.
TEST(Ru, ARegionTakesFourCycles) {
  RuBench bench({}, 0);
  Frame frame = random_frame(bench.rng, kConfig.window, kConfig.window);
  frame.raster.eyes = kAllEyes;
  bench.start(frame);
  const int slots = kConfig.regions() / kConfig.units, count = 400;
  for (int i = 0; i < count; ++i) bench.send_region(ru_region(kConfig, 0, i % slots), -1);
  bench.send(kWindowEnd);
  ASSERT_NO_FATAL_FAILURE(bench.finish());
  ASSERT_EQ(bench.line_cycles.size(), size_t(count * kLinesPerRegion));
  EXPECT_EQ(bench.line_cycles.back() - bench.line_cycles.front(), 4u * count - 4 / kLinesPerRegion);
}

// The pixels of a window are written while the next one is blended. With quads each region is handed over before: four
// turns of the lanes, and in the first round no more than two words in five cycles, in six where a word is two
// lines, and a line more for each AOV.
TEST(Ru, WritingAWindowHidesBehindTheNextOne) {
  RuBench bench({.options = {.latency = 20, .bytes_per_cycle = 64}}, 0);
  Frame frame = random_frame(bench.rng, 8ull * kConfig.window, kConfig.window);
  frame.raster.eyes = kAllEyes;
  bench.start(frame);
  const int slots = kConfig.regions() / kConfig.units, rounds = 4;
  for (int window = 0; window < 8; ++window) {
    for (int i = 0; i < rounds * slots; ++i) bench.send_region(ru_region(kConfig, 0, i % slots), -1);
    bench.send(kWindowEnd);
  }
  ASSERT_NO_FATAL_FAILURE(bench.finish());
  const double per_region =
      kLinesPerRegion * double(bench.line_cycles.back() - bench.line_cycles.front()) / (bench.line_cycles.size() - 1);
  std::printf("cycles per region over 8 windows: %.3f; busy %llu starved %llu blocked %llu memory %llu\n", per_region,
              (unsigned long long)bench.perf[0], (unsigned long long)bench.perf[1], (unsigned long long)bench.perf[2],
              (unsigned long long)bench.perf[3]);
  const double aovs = std::popcount(bench.wanted_aovs());  // each takes a turn more for every word
  const double handed = kConfig.quads ? (kConfig.pixel_w == 32 ? 6.0 + 4 * aovs : 8.0) / rounds : 0;
  const double start = (kConfig.quads ? 16.0 : 8.0) / (rounds * slots);
  EXPECT_LT(per_region, 4.0 + handed + start) << "a window's end empties the RU";
}

TEST(Ru, PixelFieldsLieWhereTheDriverReadsThem) {
  Config config;                                                                     // the default widths
  EXPECT_EQ(ru_resolve(config, {1u << 18, {0, 0, 0}, false}), 0x8000000000000000u);  // T = 1, black
  EXPECT_EQ(ru_resolve(config, {7, {1, 2, 3}, true}), 0x0000000300020001u);          // T below 2^-15 is cut
  EXPECT_EQ(ru_rgba8(config, 0x8000000000000000u), 0xff000000u);                     // R, G, B are 0, A is 255
  EXPECT_EQ(ru_rgba8(config, 0x0000ffff20004000u), 0xffff80ffu);                     // 1, a half, almost 4
}

TEST(Ru, SleepsWhenItHasNothingToDo) {
  RuBench bench({}, 0);
  bench.start(random_frame(bench.rng, kConfig.window, kConfig.window));
  bench.send(kWindowEnd);
  ASSERT_NO_FATAL_FAILURE(bench.finish());
  const uint64_t before = bench.active_cycles;
  for (int i = 0; i < 50; ++i) bench.cycle_once();
  EXPECT_EQ(bench.active_cycles, before);
}

}  // namespace
}  // namespace pipegs
