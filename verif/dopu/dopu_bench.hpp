// SPDX-License-Identifier: Apache-2.0
// dopu_bench.hpp: what stands around a whole DOPU in its tests: PUs, a packed random scene in memory, the RUs'
// feedback.
#pragma once

#include <cstring>
#include <functional>
#include <tuple>
#include <vector>

#include "Vpipegs_dopu.h"
#include "cpp_model/dopu/dopu.hpp"
#include "cpp_model/ru/ru_walk.hpp"
#include "verif/dopu/dopu_world.hpp"
#include "verif/support/config.hpp"
#include "verif/support/frame_ports.hpp"
#include "verif/support/gated_bench.hpp"

namespace pipegs {

// The PUs: takes chunks at a pace, checks the stream rules of each, keeps the data in order and each unit's ends. A PU
// that is ready has room; lazy ones say that they have room, and are ready only for what was shown.
class Units : public Endpoint {
 public:
  Units(Bench<Vpipegs_dopu>& bench, const Config& config, Pace pace)
      : pace(pace), ends(static_cast<size_t>(config.units)), bench_(bench), config_(config) {
    bench.add(*this);
  }
  void drive() override {
    for (int u = 0; u < config_.units; ++u) {
      // Like a PU's input, ready stays until a beat is taken: it is never withdrawn.
      if (pace == Pace::kLazy && (shown_ >> u & 1) == 0) continue;
      if (rare != 0 ? bench_.rng() % rare == 0 : goes(pace, bench_.rng)) ready_ |= uint64_t{1} << u;
    }
    bench_.dut.chunk_ready_i = static_cast<CData>(ready_);
    const uint64_t all = (uint64_t{1} << config_.units) - 1;
    bench_.dut.chunk_room_i = static_cast<CData>(pace == Pace::kLazy ? all : ready_);
  }
  void observe() override {
    const uint64_t valid = bench_.dut.chunk_valid_o, now = valid & ready_;
    if (valid == 0) {
      EXPECT_EQ(shown_, 0u) << "a shown chunk was withdrawn, cycle " << bench_.cycle;
      return;
    }
    const Chunk chunk = read_record<Chunk>(config_, bench_.dut.chunk_o);
    if (shown_ != 0) {
      EXPECT_EQ(valid, shown_) << "valid changed, cycle " << bench_.cycle;
      EXPECT_EQ(chunk, last_) << "the chunk changed, cycle " << bench_.cycle;
    }
    EXPECT_TRUE(chunk.kind != kData || (valid & (valid - 1)) == 0)
        << "a chunk went to several units, cycle " << bench_.cycle;
    shown_ = valid & ~now;
    last_ = chunk;
    for (int u = 0; u < config_.units; ++u) {
      if (((now >> u) & 1) == 0) continue;
      ready_ &= ~(uint64_t{1} << u);
      ++count[u];
      taken(u, chunk);
      if (chunk.kind == kData) {
        beats.push_back(chunk);
        cycles.push_back(bench_.cycle);
      } else {
        auto& mine = ends[static_cast<size_t>(u)];
        mine.push_back({beats.size(), chunk.kind});
        if (chunk.kind == kWindowEnd) window_end();
      }
    }
  }
  std::function<void()> window_end = [] {};
  std::function<void(int, const Chunk&)> taken = [](int, const Chunk&) {};  // every beat, as a unit takes it
  Pace pace;
  uint64_t rare = 0;         // a unit becomes ready in one cycle out of so many
  std::vector<Chunk> beats;  // all units together, in order
  std::vector<uint64_t> cycles;
  std::vector<std::vector<std::pair<size_t, uint64_t>>> ends;  // of each unit: chunks sent before it, kind
  uint64_t count[kMostUnits] = {};

 private:
  Bench<Vpipegs_dopu>& bench_;
  Config config_;
  uint64_t ready_ = 0, shown_ = 0;
  Chunk last_;
};

// The RUs: all of them finish a window once it has sent `after` chunks, and move on with its end.
struct Feedback : Endpoint {
  Bench<Vpipegs_dopu>& bench;
  Units& units;
  const Config& config;
  const Frame* frame = nullptr;
  size_t after = 10, window = 0, ends = 0, seen = 0;
  uint64_t parts = ~uint64_t{0};  // of the window, that are done then
  std::function<void()> next_window = [] {};
  Feedback(Bench<Vpipegs_dopu>& b, Units& u, const Config& c) : bench(b), units(u), config(c) {
    b.add(*this);
    u.window_end = [this] { ++ends; };
  }
  void drive() override {
    if (frame == nullptr) return;
    if (ends == (window + 1) * static_cast<size_t>(config.units)) {
      ++window;
      seen = units.beats.size();
      next_window();
    }
    const uint64_t columns = frame->raster.windows.last_x - frame->raster.windows.first_x + 1;
    const bool done = units.beats.size() >= seen + after;
    const Said say{window, seen, parts, done};
    if (say == said_) return;
    said_ = say;
    Words bits(sizeof(bench.dut.done_i) / 4 + 2), x(4), y(4);
    for (int u = 0; u < config.units; ++u) {
      for (int r = 0; r < config.regions(); ++r) {
        const bool now = done && (parts >> region_part(config, r) & 1) != 0;
        if (ru_owner(config, r) == u) put_bits(bits.data(), u * config.regions() + r, 1, now);
      }
      put_bits(x.data(), u * config.window_w(), config.window_w(), frame->raster.windows.first_x + window % columns);
      put_bits(y.data(), u * config.window_w(), config.window_w(), frame->raster.windows.first_y + window / columns);
    }
    write_port(bench.dut.done_i, bits.data());
    write_port(bench.dut.done_x_i, x.data());
    write_port(bench.dut.done_y_i, y.data());
  }
  void observe() override {}

 private:
  using Said = std::tuple<size_t, size_t, uint64_t, bool>;  // window, seen, parts, done
  Said said_{~size_t{0}, 0, 0, false};
};

struct World {
  Config config = test_config();
  PackedScene packed;
  Frame frame;
  World(const Scene& scene, const Camera& camera, bool part = false) { set(scene, camera, part); }
  template <class Rng>
  World(Rng& rng, size_t gaussians, int width, int height, bool part = false) {
    const Scene scene = random_scene(rng, gaussians);
    set(scene, random_camera(rng, width, height), part);
  }
  void set(const Scene& scene, const Camera& camera, bool part) {
    packed = pack_scene(config, scene, camera_bound(camera));
    std::optional<WindowRange> windows;
    if (part) windows = WindowRange{1, 0, 1, 1};
    frame = frame_setup(config, packed, camera, windows);
    spread_eyes(config, packed, frame);
  }
  void load(ExternalMemory& memory) const { memory.load(memory_image(packed).lines); }
};

using Memory = MemoryEndpoint<QData, VlWide<16>>;

// A DOPU between a memory and its PUs, out of reset.
template <class BenchT = Bench<Vpipegs_dopu>>
struct Dopu {
  const Config config = test_config();
  BenchT bench;
  ExternalMemory memory;
  Units units;
  Memory port;

  explicit Dopu(const ExternalMemoryOptions& options, Pace pace = Pace::kAlways, Pace memory_pace = Pace::kAlways)
      : memory(options),
        units(bench, config, pace),
        port(bench, memory, bench.dut.mem_valid_o, bench.dut.mem_ready_i, nullptr, bench.dut.mem_address_o, nullptr,
             bench.dut.rsp_valid_i, bench.dut.rsp_data_i, memory_pace, &bench.dut.mem_lines_o) {
    bench.dut.start_i = 0;
    no_feedback();
    bench.reset();
  }
  void no_feedback() {
    std::memset(&bench.dut.done_i, 0, sizeof(bench.dut.done_i));
    std::memset(&bench.dut.done_x_i, 0, sizeof(bench.dut.done_x_i));
    std::memset(&bench.dut.done_y_i, 0, sizeof(bench.dut.done_y_i));
  }
  // One frame to its end, or to the first failure; the cycles behind its start.
  uint64_t frame(const World& world, bool gated = false) {
    world.load(memory);
    write_frame(config, bench.dut, world.frame);
    const auto done = [&] { return !bench.dut.busy_o || testing::Test::HasFatalFailure(); };
    bench.dut.start_i = 1;
    const uint64_t before = bench.cycle;
    if constexpr (requires { bench.gated; }) {
      if (gated) {
        bench.gated_step();
        bench.dut.start_i = 0;
        EXPECT_TRUE(bench.run_gated_until(done, 5000000));
        return bench.cycle - before;
      }
    }
    bench.step();
    bench.dut.start_i = 0;
    EXPECT_TRUE(bench.run_until(done, 5000000));
    return bench.cycle - before;
  }
};

// What may stand around a DOPU: all must send the same.
struct Around {
  const char* name;
  Pace pace, memory_pace;
  ExternalMemoryOptions memory;
};
inline const Around kAround[] = {
    {"a prompt memory", Pace::kAlways, Pace::kAlways, {.latency = 10, .bytes_per_cycle = 64}},
    {"a slow memory", Pace::kAlways, Pace::kCoin, {.latency = 150, .bytes_per_cycle = 12.8, .jitter = 40}},
    {"back pressure", Pace::kQuarter, Pace::kAlways, {.latency = 60, .jitter = 20}},
    {"lazy units", Pace::kLazy, Pace::kLazy, {.latency = 60, .jitter = 20}},
    {"coins", Pace::kCoin, Pace::kQuarter, {.latency = 60, .jitter = 20}}};

// Frames one after another: nothing may be left of the frame before. Sees each world before and after its frame. Where
// windows have walks some go by parts, in other frames none is counted, or all go by parts.
template <class Before, class After>
void six_frames(Dopu<>& dopu, Before&& before, After&& after) {
  const size_t gaussians[] = {3000, 0, 1, 20000, 500, 60};
  for (int frame = 0; frame < 6; ++frame) {
    SCOPED_TRACE(frame);
    const Scene scene = random_scene(dopu.bench.rng, gaussians[frame]);
    // Of a window of 128 pixels that the picture cuts one has no pixels in its lower parts, one in its right ones.
    Camera camera = frame % 2 == 0 ? random_camera(dopu.bench.rng, 200, 150) : random_camera(dopu.bench.rng, 180, 200);
    // One looks along all axes alike, from below the grid; one from beyond it.
    if (frame == 0) camera = look_at("diagonal", 0, 200, 150, glm::dvec3(-90), glm::dvec3(0), 40);
    if (frame == 5) camera = look_at("far", 0, 200, 150, glm::dvec3(300, 400, 500), glm::dvec3(0), 40);
    World world(scene, camera, frame == 4);
    const uint64_t most[] = {500, 60000, 1, 4000, 0, 1};
    if (world.config.has_walks()) world.frame.walk_most = most[frame];
    before(world);
    dopu.frame(world);
    after(world);
    if (testing::Test::HasFatalFailure()) return;
  }
}

// The work of the walk through all windows of a frame, or with lists of its one walk.
inline DopuCounts dopu_counts(const World& world) {
  DopuCounts sum;
  const bool once = world.config.has_lists();
  for (uint64_t y = 0; y <= (once ? 0 : world.frame.raster.windows.last_y); ++y) {
    for (uint64_t x = 0; x <= (once ? 0 : world.frame.raster.windows.last_x); ++x) {
      const DopuCounts part = dopu_window(world.config, world.frame, world.packed, static_cast<int>(x),
                                          static_cast<int>(y), [](int, const Chunk&, uint64_t) {});
      sum.cell_tests += part.cell_tests, sum.group_tests += part.group_tests, sum.chunk_tests += part.chunk_tests,
          sum.chunks += part.chunks;
    }
  }
  return sum;
}

}  // namespace pipegs
