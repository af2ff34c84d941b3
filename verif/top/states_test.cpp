// SPDX-License-Identifier: Apache-2.0
// states_test: a machine whose units say that they do something else than they do is caught, in any of its cycles.
//
// Idea    What the default machine shows in a small frame is kept, and shown to StateCheck again with a fault in it:
//         one state stands for another in all cycles of a unit, or in one cycle. Faults of the RTL itself are in
//         verif/mutation/table.sh, with the test machine_live.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <random>

#include "cpp_model/areas/frame_areas.hpp"
#include "sim/compare/frame_watch.hpp"
#include "sim/compare/sequence_check.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/compare/state_check.hpp"
#include "verif/frame/machines.hpp"
#include "verif/frame/scenes.hpp"
#include "verif/support/draws.hpp"

namespace pipegs {
namespace {

constexpr const char* kStates[] = {"busy", "starved", "blocked", "memory"};
constexpr const char* kUnits[] = {"DOPU", "PU 0", "SU 0", "RU 0"};

struct ChunkBeat {  // DOPU -> PU
  int unit, kind;
  std::vector<uint32_t> words;
};

struct Shown {  // in a cycle
  uint64_t number;
  std::vector<uint8_t> states, border;
  std::vector<ChunkBeat> chunks;
  std::vector<std::function<void(RtlTaps&)>> rest;
};

class Recorder final : public RtlTaps {
 public:
  explicit Recorder(const Config& config) : config_(config) {}
  bool wants_cycles() const override { return true; }
  void on_cycle(uint64_t number, const uint8_t* states) override {
    shown.push_back({number, {states, states + 1 + 3 * config_.units}, {}, {}, {}});
  }
  void on_border(const uint8_t* border) override { shown.back().border.assign(border, border + kRtlBorders); }
  void on_chunk(int unit, int kind, const uint32_t* chunk) override {
    if (!shown.empty()) shown.back().chunks.push_back({unit, kind, copy(chunk, record_width<Chunk>(config_))});
  }
  void on_layer_done(int unit, bool window_done) override {
    then([=](RtlTaps& taps) { taps.on_layer_done(unit, window_done); });
  }
  void on_request(int tag, bool write, uint64_t line, int lines) override {
    then([=](RtlTaps& taps) { taps.on_request(tag, write, line, lines); });
  }
  void on_splat(int unit, const uint32_t* splat) override {
    then([=, kept = copy(splat, record_width<Splat>(config_))](RtlTaps& taps) { taps.on_splat(unit, kept.data()); });
  }
  void on_sorted(const uint32_t* sorted) override {
    then([kept = copy(sorted, record_width<Sorted>(config_))](RtlTaps& taps) { taps.on_sorted(kept.data()); });
  }
  void on_alphas(int lane, uint64_t x, uint64_t y, uint32_t index, int region, int quarter,
                 const uint32_t* line) override {
    then([=, kept = copy(line, config_.tap_line_w())](RtlTaps& taps) {
      taps.on_alphas(lane, x, y, index, region, quarter, kept.data());
    });
  }
  void on_pixels(int lane, int region, int quarter, const uint32_t* word) override {
    then([=, kept = copy(word, config_.tap_word_w())](RtlTaps& taps) {
      taps.on_pixels(lane, region, quarter, kept.data());
    });
  }
  std::vector<Shown> shown;

 private:
  void then(std::function<void(RtlTaps&)> call) {
    if (!shown.empty()) shown.back().rest.push_back(std::move(call));
  }
  static std::vector<uint32_t> copy(const uint32_t* words, int bits) { return {words, words + (bits + 31) / 32}; }

  const Config& config_;
};

class States : public testing::Test {
 protected:
  static const SimulateOptions& options() {
    static const SimulateOptions options = machine(kFast);
    return options;
  }
  // A frame in which some units wait for their memory and some are blocked.
  static const Recorder& run() {
    static Recorder recorder(options().config);
    if (recorder.shown.empty()) {
      SimulateOptions with = options();
      with.taps = &recorder;
      simulate_golden(random_scene(3, 3000, 1), test_camera(150, 140, 150), with, simulation_);
      simulate_rtl(with, simulation_);
      EXPECT_EQ(simulation_.mismatches, 0u) << simulation_.first_mismatch->what;
    }
    return recorder;
  }
  // What is said of the frame, of which `alter` changes the states of cycles.
  using Alter = std::function<void(size_t cycle, uint8_t* states)>;
  static std::vector<StateCheck::Wrong> check(const Alter& alter, const RtlResult* counters = nullptr) {
    std::vector<StateCheck::Wrong> lines;
    StateCheck check(options().config, false, [&](const StateCheck::Wrong& wrong) { lines.push_back(wrong); });
    show(check, alter);
    if (counters != nullptr) check.finish(*counters);
    return lines;
  }
  // Of each chunk those that come in its place.
  using Chunks = std::function<std::vector<Chunk>(const Chunk&)>;
  static void show(RtlTaps& taps, const Alter& alter, const Chunks& chunks = {}) {
    for (size_t i = 0; i < run().shown.size(); ++i) {
      const Shown& one = run().shown[i];
      std::vector<uint8_t> states = one.states;
      if (alter) alter(i, states.data());
      taps.cycle = static_cast<int64_t>(one.number);
      taps.on_cycle(one.number, states.data());
      taps.on_border(one.border.data());
      for (const ChunkBeat& beat : one.chunks) {
        const Chunk chunk = unpack<Chunk>(options().config, beat.words.data());
        for (const Chunk& other : chunks&& beat.kind == kData ? chunks(chunk) : std::vector{chunk}) {
          std::vector<uint32_t> words(beat.words.size());
          pack(options().config, other, words.data());
          taps.on_chunk(beat.unit, beat.kind, words.data());
        }
      }
      for (const auto& rest : one.rest) rest(taps);
    }
  }
  // The first unit of each kind: where its state stands.
  static std::array<size_t, 4> first_units() {
    const auto units = static_cast<size_t>(options().config.units);
    return {0, 1, 1 + units, 1 + 2 * units};
  }
  static inline Simulation simulation_;
};

TEST_F(States, AMachineWithoutAFaultAgrees) {
  run();
  EXPECT_EQ(check({}, &simulation_.rtl).size(), 0u);
}

TEST_F(States, OneStateForAnotherIsSeen) {
  for (size_t kind = 0; kind < 4; ++kind) {
    const size_t unit = first_units()[kind];
    for (int from = 0; from < 4; ++from) {
      for (int to = 0; to < 4; ++to) {
        uint64_t changed = 0;
        const std::vector<StateCheck::Wrong> lines = check([&](size_t, uint8_t* states) {
          if (states[unit] != from || to == from) return;
          states[unit] = static_cast<uint8_t>(to);
          ++changed;
        });
        if (changed == 0) continue;  // the unit is never so
        // While a DOPU or an RU waits, it may do what does not show.
        if (kind % 3 == 0 && from != kStarved && to == kBusy) continue;
        EXPECT_FALSE(lines.empty()) << kUnits[kind] << ": " << kStates[from] << " became " << kStates[to];
        if (lines.empty()) continue;
        EXPECT_EQ(lines[0].unit, kUnits[kind]);
        EXPECT_EQ(lines[0].found, kStates[to]);
      }
    }
  }
}

// Of those that are another one in a single cycle. What a unit does with nothing at its borders stays open; of the DOPU
// that is more than half, as most nodes that it tests lead to no chunk.
TEST_F(States, ManySingleStatesAreSeen) {
  std::mt19937_64 rng(1);
  const size_t cycles = run().shown.size();
  for (size_t kind = 0; kind < 4; ++kind) {
    std::map<int64_t, int> places;  // cycle, what is added to the state
    for (int i = 0; i < 300; ++i) {
      const int64_t cycle = draw_integer(rng, 20, static_cast<int64_t>(cycles) - 20);
      places[cycle] = static_cast<int>(draw_integer(rng, 1, 3));
    }
    const std::vector<StateCheck::Wrong> lines = check([&](size_t cycle, uint8_t* states) {
      uint8_t& state = states[first_units()[kind]];
      const auto place = places.find(static_cast<int64_t>(cycle));
      if (place != places.end()) state = static_cast<uint8_t>((state + place->second) % 4);
    });
    const auto seen = std::count_if(lines.begin(), lines.end(), [&](const StateCheck::Wrong& wrong) {
      return wrong.unit == kUnits[kind] && places.count(wrong.cycle) != 0;
    });
    fmt::print("{}: {} of {} single states are seen\n", kUnits[kind], seen, places.size());
    const int64_t percent = kind == 0 ? 40 : 50;
    EXPECT_GE(seen, static_cast<int64_t>(places.size()) * percent / 100) << kUnits[kind];
  }
}

TEST_F(States, CountersOfOtherStatesAreSeen) {
  run();
  RtlResult wrong = simulation_.rtl;
  --wrong.su[1].starved, ++wrong.su[1].busy;
  const std::vector<StateCheck::Wrong> lines = check({}, &wrong);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].unit, "SU 1");
}

// A chunk that is missing, comes twice, is another one or has another centre, though every splat is right.
TEST_F(States, ChunksThatAreWrongAreHeard) {
  run();
  const ExternalMemory memory({}, options().config.bus_w);
  const GoldenInput& input = simulation_.input;
  const SequenceCheck::Expected frame = {&input, &simulation_.golden,
                                         frame_areas(options().config, *input.packed, input.frame)};
  const auto with = [](const Chunk& chunk, auto field, int64_t step) {
    Chunk other = chunk;
    other.*field += static_cast<std::remove_reference_t<decltype(other.*field)>>(step);
    return std::vector{other};
  };
  const std::pair<const char*, Chunks> faults[] = {
      {"its chunk", [](const Chunk&) { return std::vector<Chunk>{}; }},
      {"its chunk once",
       [](const Chunk& chunk) {
         return std::vector{chunk, chunk};
       }},
      {"none", [&](const Chunk& chunk) { return with(chunk, &Chunk::slot, 1); }},
      {"origin_y", [&](const Chunk& chunk) { return with(chunk, &Chunk::origin_y, 1); }},
      {"count", [&](const Chunk& chunk) { return with(chunk, &Chunk::count, -1); }},
      {"window_x", [&](const Chunk& chunk) { return with(chunk, &Chunk::window_x, 1); }},
      {"watermark", [&](const Chunk& chunk) { return with(chunk, &Chunk::watermark, 1); }}};
  for (const auto& [expected, fault] : faults) {
    SCOPED_TRACE(expected);
    SequenceCheck check({frame}, memory, nullptr);
    int number = 0;
    show(check, {},
         [&, &fault = fault](const Chunk& chunk) { return ++number == 5 ? fault(chunk) : std::vector{chunk}; });
    ASSERT_GE(check.frame(0).mismatches(), 1u);
    const Mismatch& first = *check.frame(0).first();
    EXPECT_EQ(first.tap, Tap::kChunk);
    EXPECT_EQ(first.field.empty() ? first.expected : first.field, expected);
  }
}

// In what `pipegs sim` compares, a request that leaves the areas of its port is a mismatch, though no pixel shows it.
TEST_F(States, RequestsOutsideOfTheirAreasAreHeard) {
  const Config& config = options().config;
  run();
  const GoldenInput& input = simulation_.input;
  const Tables& at = input.frame.tables;
  const Areas areas = frame_areas(config, *input.packed, input.frame);
  const ExternalMemory memory({}, config.bus_w);
  const int units = config.units, geometry = config.write_ports(), color = geometry + units, nodes = color + units;
  const uint64_t share = areas.overflow >> 2;  // of each of four units
  ASSERT_EQ(units, 4);
  struct Request {
    int tag;
    bool write;
    uint64_t line;
    int lines;
    const char* expected;  // null: it is allowed
  };
  const std::string geometry_lines = fmt::format("{} to {}", at.gaussians, at.gaussians + areas.gaussians - 1);
  for (const Request& one : {Request{geometry, false, at.gaussians, 8, nullptr},
                             {geometry + 3, false, at.gaussians + areas.gaussians - 1, 1, nullptr},
                             {geometry, false, at.gaussians + areas.gaussians - 1, 2, geometry_lines.c_str()},
                             {geometry, false, at.colors, 1, geometry_lines.c_str()},
                             {geometry, true, at.gaussians, 1, "no write"},
                             {color, false, at.colors, 1, nullptr},
                             {color, false, at.gaussians, 1, ""},
                             {nodes, false, at.chunks, 8, nullptr},
                             {nodes, false, at.gaussians, 1, ""},
                             {units + 1, true, at.overflow + share, 1, nullptr},
                             {units + 1, true, at.overflow + 2 * share, 1, ""},  // of SU 2
                             {units + 1, false, at.overflow, 1, ""},
                             {2 * units, true, at.pixels, 1, nullptr},
                             {2 * units, true, at.pixels + areas.pixels, 1, ""},
                             {2 * units, false, at.pixels, 1, "no read"},
                             {0, true, at.overflow, 1, "no write"}}) {  // no alphas go to memory
    SCOPED_TRACE(fmt::format("port {} {} line {}", one.tag, one.write ? "writes" : "reads", one.line));
    SequenceCheck check({{&input, &simulation_.golden, areas}}, memory, nullptr);
    check.on_request(one.tag, one.write, one.line, one.lines);
    ASSERT_EQ(check.frame(0).mismatches(), one.expected == nullptr ? 0u : 1u);
    if (one.expected == nullptr) continue;
    const Mismatch& first = *check.frame(0).first();
    EXPECT_EQ(first.tap, Tap::kRequest);
    if (*one.expected != 0) EXPECT_EQ(first.expected, one.expected);
  }
}

// What `pipegs sim` compares: in it a state that cannot be is a mismatch as any other, and so are counters.
TEST_F(States, TheComparisonOfFramesHearsThem) {
  run();
  const ExternalMemory memory({}, options().config.bus_w);
  const GoldenInput& input = simulation_.input;
  const SequenceCheck::Expected frame = {&input, &simulation_.golden,
                                         frame_areas(options().config, *input.packed, input.frame)};
  SequenceCheck good({frame}, memory, nullptr), wrong({frame}, memory, nullptr), sums({frame}, memory, nullptr);
  show(good, {});
  good.finish(simulation_.rtl);
  EXPECT_EQ(good.frame(0).mismatches(), 0u) << good.frame(0).first()->line();

  const size_t su = first_units()[2];
  show(wrong, [&](size_t cycle, uint8_t* states) {
    if (cycle >= 500 && states[su] == kBusy) states[su] = kBlocked;
  });
  EXPECT_GT(wrong.frame(0).mismatches(), 10u);
  ASSERT_TRUE(wrong.frame(0).first().has_value());
  const Mismatch& first = *wrong.frame(0).first();
  EXPECT_EQ(first.tap, Tap::kState);
  EXPECT_GE(first.cycle, 500);
  EXPECT_EQ(first.what, "state of SU 0: expected busy, found blocked");

  RtlResult counters = simulation_.rtl;
  --counters.ru[1].busy;
  show(sums, {});
  sums.finish(counters);
  ASSERT_EQ(sums.frame(0).mismatches(), 1u);
  EXPECT_EQ(sums.frame(0).first()->who, "RU 1");
}

// All at one depth, more than the pools hold: SUs spill, and the DOPU has read more nodes than it can send.
TEST(StatesWhileSpilling, ADopuThatMakesAChunkIsBusy) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 14000; ++i)
    gaussians.push_back(gaussian_at(
        {0.0054f * static_cast<float>(i % 118 - 59), 0.0054f * static_cast<float>(i / 118 - 59), 2}, 0.02f, 0.99));
  const SimulateOptions options = machine(kExact);
  Simulation simulation;
  simulate_golden(scene_of(gaussians), test_camera(64, 64), options, simulation);
  simulate_rtl(options, simulation);
  EXPECT_GT(simulation.rtl.overflow_lines, 0u) << "no SU spills";
  EXPECT_EQ(simulation.mismatches, 0u) << simulation.first_mismatch->what;
}

// Splats at one depth whose lines of alphas do not fit, and many more beside the window: while the DOPU looks through
// these, a PU has nothing but the line that waits for a slow memory.
TEST(StatesWhileSpilling, APuWithNothingButALineThatLeavesWaitsForMemory) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 500; ++i) {
    const float step = 1e-4f * static_cast<float>(i);
    gaussians.push_back(gaussian_at({0.1f * step, 0, 2 + step}, 0.8f, 0.02));
  }
  for (int i = 0; i < 20000; ++i) {
    const float x = static_cast<float>(i % 141), y = static_cast<float>(i / 141 - 70);
    gaussians.push_back(gaussian_at({3 + 0.01f * x, 0.02f * y, 2}, 0.01f, 0.5));
  }
  SimulateOptions options = machine(kHalf);
  options.memory.bytes_per_cycle = 4, options.memory.queue = 1;
  Recorder recorder(options.config);
  options.taps = &recorder;
  Simulation simulation;
  simulate_golden(scene_of(std::move(gaussians)), test_camera(64, 64), options, simulation);
  simulate_rtl(options, simulation);
  EXPECT_EQ(simulation.mismatches, 0u) << simulation.first_mismatch->what;
  EXPECT_TRUE(std::any_of(recorder.shown.begin(), recorder.shown.end(), [](const Shown& one) {
    return ((one.border[kPuBusy] & 1) == 0 && one.states[1] == kMemory) ||
           ((one.border[kPuBusy] & 2) == 0 && one.states[2] == kMemory);
  })) << "no line waits alone";
}

}  // namespace
}  // namespace pipegs
