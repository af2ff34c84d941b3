// SPDX-License-Identifier: Apache-2.0
// su_lanes_test: several SUs behind a merge, fed as pu_deal feeds them: they never wait for each other for ever.
//
// A lane gets its splats in a way that is meant to hurt: all in one lane, the near ones in one and the far ones in
// another, a lane that gets nothing. An end goes to all lanes before anything later. The pools are tiny. The bench
// models what stands between: a short queue before each SU, and the merge (su_merge has its own test).
#include <algorithm>
#include <deque>

#include "Vpipegs_su.h"
#include "cpp_model/su/su.hpp"
#include "verif/su/su_windows.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "verif/support/frame_ports.hpp"

namespace pipegs {
namespace {

const Config kConfig = test_config();
constexpr int kOctave = 20;  // random depths lie before, in and behind its 16 octaves of buckets

Splat random_splat(std::mt19937_64& rng) { return random_record<Splat>(kConfig, rng); }

struct Lane {
  Lane(VerilatedContext* context, const ExternalMemoryOptions& options, int number) : dut(context), memory(options) {
    Frame frame;
    frame.tables.overflow = 1 << 20;
    write_frame(kConfig, dut, frame);
    dut.unit_i = number;
    dut.octave_i = kOctave;
    dut.in_valid_i = dut.out_ready_i = dut.mem_ready_i = dut.rsp_valid_i = 0;
  }
  Vpipegs_su dut;
  ExternalMemory memory;
  std::deque<Splat> queue;
  bool up = false;
};

struct LanesBench : BenchBase {
  LanesBench(uint64_t seed, int count) : BenchBase(seed) {
    for (int k = 0; k < count; ++k) {
      ExternalMemoryOptions options;
      options.latency = 1 + static_cast<int>(rng() % 60);
      options.queue = 1 + static_cast<int>(rng() % 16);
      options.seed = seed;
      lanes.push_back(std::make_unique<Lane>(&context, options, k));
    }
    for (const auto& lane : lanes) {
      lane->dut.rst_ni = 0;
      for (int i = 0; i < 3; ++i) {
        lane->dut.clk_i = 0, lane->dut.eval();
        lane->dut.clk_i = 1, lane->dut.eval();
      }
      lane->dut.rst_ni = 1;
    }
    for (Pace* pace : {&source, &sink, &port}) *pace = kPaces[rng() % 3];
    depth = 1 + rng() % 5;
  }

  // A beat leaves the dealer when the queues that get it have room: a splat for its lane, an end for each in its time.
  void deal() {
    while (!beats.empty()) {
      const Splat& beat = beats.front();
      if (beat.kind == kData) {
        Lane& lane = *lanes[target.front()];
        if (lane.queue.size() >= depth) return;
        lane.queue.push_back(beat);
      } else {
        if (waiting == 0) waiting = (1u << lanes.size()) - 1;
        for (size_t k = 0; k < lanes.size(); ++k) {
          if ((waiting >> k & 1) == 0 || lanes[k]->queue.size() >= depth) continue;
          lanes[k]->queue.push_back(beat);
          waiting &= ~(1u << k);
        }
        if (waiting != 0) return;
      }
      beats.pop_front();
      target.pop_front();
    }
  }
  void step() {
    deal();
    for (const auto& lane : lanes) {
      Vpipegs_su& dut = lane->dut;
      dut.clk_i = 0;
      if (!lane->up && !lane->queue.empty() && goes(source, rng)) lane->up = true;
      dut.in_valid_i = lane->up;
      if (lane->up) write_record(kConfig, dut.in_i, lane->queue.front());
      lane->memory.step();
      dut.mem_ready_i = lane->memory.ready() && goes(port, rng);
      const ExternalMemory::Answer* answer = lane->memory.answer();
      dut.rsp_valid_i = answer != nullptr;
      if (answer != nullptr) write_port(dut.rsp_data_i, answer->data.data());
      dut.out_ready_i = 0;
      dut.eval();
    }
    merge(goes(sink, rng));
    for (size_t k = 0; k < lanes.size(); ++k) {
      Lane& lane = *lanes[k];
      Vpipegs_su& dut = lane.dut;
      dut.eval();
      if (lane.up && dut.in_ready_o) {
        lane.queue.pop_front();
        lane.up = false;
        moved = cycle;
      }
      if (dut.mem_valid_o && dut.mem_ready_i) {
        Words words(17);
        read_port(dut.mem_data_o, words.data());
        lane.memory.request(dut.mem_write_o, static_cast<uint64_t>(dut.mem_address_o), 0, words.data());
        overflowed += dut.overflow_o;
      }
      if (dut.active_o) {
        dut.clk_i = 1;
        dut.eval();
      } else {
        ++asleep;
      }
    }
    ++cycle;
  }
  // What su_merge does: the nearest head of all goes; ends go together.
  void merge(bool ready) {
    size_t nearest = lanes.size(), ends = 0;
    Splat best;
    for (size_t k = 0; k < lanes.size(); ++k) {
      if (!lanes[k]->dut.out_valid_o) return;
      const Splat head = read_record<Splat>(kConfig, lanes[k]->dut.out_o);
      if (head.kind != kData) {
        if (++ends == 1 && nearest == lanes.size()) best = head;
      } else if (nearest == lanes.size() || splat_before(head, best)) {
        best = head;
        nearest = k;
      }
    }
    if (!ready) return;
    moved = cycle;
    for (size_t k = 0; k < lanes.size(); ++k) lanes[k]->dut.out_ready_i = ends == lanes.size() || k == nearest;
    if (ends < lanes.size() || !kConfig.has_watermarks() || best.kind == kWindowEnd) merged.push_back(best);
  }
  void run() {
    while (merged.size() < expected.size()) {
      // A set that spilled sends nothing while it is sorted: these pools hold a line of each run, so a key may take as
      // long as the memory.
      ASSERT_LT(cycle, moved + 200000) << "nothing moves: " << merged.size() << " of " << expected.size()
                                       << " beats, seed " << seed;
      step();
    }
    for (size_t i = 0; i < merged.size(); ++i) {
      ASSERT_EQ(first_difference(kConfig, expected[i], merged[i]), "")
          << "beat " << i << " of " << expected.size() << ", seed " << seed;
    }
  }
  // Queues a window; who gets a splat is decided by `rule`.
  void window(size_t count, int marks, int rule) {
    const int units = static_cast<int>(lanes.size());
    const std::vector<Splat> all = su_window(kConfig, count, marks, !kConfig.has_watermarks(), rng, random_splat);
    std::vector<uint64_t> depths;
    for (const Splat& beat : all)
      if (beat.kind == kData) depths.push_back(beat.depth);
    std::sort(depths.begin(), depths.end());
    int chosen = static_cast<int>(rng() % units);
    std::vector<Splat> open;
    for (const Splat& beat : all) {
      int lane = chosen;
      switch (rule) {
        case 0: lane = static_cast<int>(rng() % units); break;  // evenly
        case 1: break;                                          // all in one lane
        case 2:
          if (beat.kind != kData) chosen = static_cast<int>(rng() % units);
          break;  // between two marks in one lane
        case 3:
          lane = beat.kind != kData || beat.depth < depths[depths.size() / 2] ? 0 : units - 1;
          break;                                                // near ones here, far ones there
        case 4: lane = rng() % 20 == 0 ? 0 : units - 1; break;  // hardly any in one
        default:
          if (rng() % 30 == 0) chosen = static_cast<int>(rng() % units);
          break;  // in runs
      }
      beats.push_back(beat);
      target.push_back(lane);
      if (beat.kind == kData) {
        open.push_back(beat);
      } else if (!kConfig.has_watermarks() || beat.kind != kLayerEnd) {
        su_sort(open);
        expected.insert(expected.end(), open.begin(), open.end());
        open.clear();
        if (beat.kind == kPartEnd) continue;
        expected.emplace_back();
        expected.back().kind = beat.kind;
      }
    }
  }

  std::vector<std::unique_ptr<Lane>> lanes;
  std::deque<Splat> beats;
  std::deque<int> target;  // lane of each beat
  std::vector<Splat> expected, merged;
  Pace source, sink, port;
  size_t depth;          // of the queue before an SU
  unsigned waiting = 0;  // lanes that have still to take the end
  uint64_t moved = 0, overflowed = 0, asleep = 0;
};

TEST(SuLanes, NeverWaitForEachOtherForEver) {
  uint64_t overflowed = 0, asleep = 0;
  for (uint64_t n = 0; n < 200; ++n) {
    LanesBench bench(test_seed() * 1000 + n, kConfig.units);
    const size_t most = static_cast<size_t>(kConfig.records) * (1 + n % 4) * (1 + n % 3);
    for (int i = 0; i < 5; ++i) {
      bench.window(bench.rng() % most,
                   bench.rng() % 3 ? static_cast<int>(bench.rng() % (Config::window_marks() + 1)) : 0,
                   static_cast<int>(n + static_cast<uint64_t>(i) / 3) % 6);
    }
    bench.run();
    overflowed += bench.overflowed;
    asleep += bench.asleep;
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(overflowed, 10000u) << "spilling was meant to be tested too";
  EXPECT_GT(asleep, 10000u);
}

}  // namespace
}  // namespace pipegs
