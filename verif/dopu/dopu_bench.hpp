// SPDX-License-Identifier: Apache-2.0
// dopu_bench.hpp: what stands around a whole DOPU in its tests: PUs, a packed random scene in memory, the RUs'
// feedback.
#pragma once

#include <cstring>
#include <functional>
#include <vector>

#include "Vpipegs_dopu.h"
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
  uint64_t count[4] = {};

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
    Words bits(sizeof(bench.dut.done_i) / 4 + 2), x(4), y(4);
    for (int u = 0; u < config.units; ++u) {
      for (int r = 0; r < config.regions(); ++r) {
        if (ru_owner(config, r) == u) put_bits(bits.data(), u * config.regions() + r, 1, done);
      }
      put_bits(x.data(), u * config.window_w(), config.window_w(), frame->raster.windows.first_x + window % columns);
      put_bits(y.data(), u * config.window_w(), config.window_w(), frame->raster.windows.first_y + window / columns);
    }
    write_port(bench.dut.done_i, bits.data());
    write_port(bench.dut.done_x_i, x.data());
    write_port(bench.dut.done_y_i, y.data());
  }
  void observe() override {}
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
  }
  void load(ExternalMemory& memory) const { memory.load(memory_image(packed).lines); }
};

using Memory = MemoryEndpoint<QData, VlWide<16>>;

inline void start(Bench<Vpipegs_dopu>& bench, const World& world) {
  write_frame(world.config, bench.dut, world.frame);
  bench.dut.start_i = 1;
  bench.step();
  bench.dut.start_i = 0;
}

inline void no_feedback(Bench<Vpipegs_dopu>& bench) {
  std::memset(&bench.dut.done_i, 0, sizeof(bench.dut.done_i));
  std::memset(&bench.dut.done_x_i, 0, sizeof(bench.dut.done_x_i));
  std::memset(&bench.dut.done_y_i, 0, sizeof(bench.dut.done_y_i));
}

}  // namespace pipegs
