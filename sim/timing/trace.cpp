// trace.cpp: see trace.hpp.
#include "sim/timing/trace.hpp"

#include <bit>
#include <stdexcept>

#include "cpp_model/dopu/dopu.hpp"
#include "cpp_model/float/parallel.hpp"
#include "cpp_model/pu/pu_coeff.hpp"
#include "cpp_model/pu/pu_conic.hpp"
#include "cpp_model/pu/pu_covariance.hpp"
#include "cpp_model/pu/pu_cull.hpp"
#include "cpp_model/pu/pu_factors.hpp"
#include "cpp_model/pu/pu_intersect.hpp"
#include "cpp_model/pu/pu_jacobian.hpp"
#include "cpp_model/pu/pu_orient.hpp"
#include "cpp_model/pu/pu_project.hpp"
#include "cpp_model/pu/pu_rows.hpp"
#include "cpp_model/pu/pu_squares.hpp"

namespace pipegs {
namespace {

// A window's part of the trace before the parts are joined.
struct Part {
  TimingWindow window;
  std::vector<TimingChunk> chunks;
  std::vector<uint64_t> mask, key;
  std::vector<uint32_t> slot;
  std::vector<uint8_t> boxes;
  Work work;
};

// A splat whose alphas the blend needs.
struct Splat {
  uint64_t key;
  uint64_t mask;
  RowJob job;
};

std::vector<TimingNode> nodes(const std::vector<Node>& from) {
  std::vector<TimingNode> result;
  result.reserve(from.size());
  for (const Node& node : from) result.push_back({static_cast<uint32_t>(node.first), static_cast<uint32_t>(node.count)});
  return result;
}

void set_bit(std::vector<uint64_t>& bits, uint64_t at) { bits[at / 64] |= uint64_t{1} << (at % 64); }

class WindowTrace {
 public:
  WindowTrace(const GoldenInput& input, int x, int y)
      : packed_(*input.packed), config_(packed_.config), frame_(input.frame), x_(x), y_(y), planes_(dopu_planes(config_, frame_, x, y)) {}

  Part run() {
    part_.window.cells.resize((packed_.cells.size() + 63) / 64);
    part_.window.groups.resize((packed_.groups.size() + 63) / 64);
    walk();
    done();
    part_.work.keys = part_.work.records;
    part_.work.alphas = part_.work.regions * kRegionPixels;
    part_.work.layers = layers_.size();
    part_.work.windows = 1;
    return std::move(part_);
  }

 private:
  void walk() {
    const int axis = dopu_axis(frame_), camera = dopu_layer_camera(config_, frame_, axis);
    for (int step = 0; step < 2 * config_.grid; ++step) {
      const int slab = dopu_layer_step(config_, camera, step);
      if (slab < 0) continue;
      bool any = false;
      for (int n = 0; n < config_.grid * config_.grid; ++n) {
        const auto number = static_cast<uint64_t>(dopu_layer_cell(config_, axis, slab, n));
        const Node& cell = packed_.cells[number];
        if (cell.count == 0 || !dopu_test(config_, frame_, planes_, cell)) continue;
        set_bit(part_.window.cells, number);
        for (uint64_t g = cell.first; g < cell.first + cell.count; ++g) {
          const Node& group = packed_.groups[g];
          if (!dopu_test(config_, frame_, planes_, group)) continue;
          set_bit(part_.window.groups, g);
          for (uint64_t i = group.first; i < group.first + group.count; ++i) {
            if (!dopu_test(config_, frame_, planes_, packed_.chunks[i])) continue;
            if (!any) layers_.emplace_back();
            any = true;
            chunk(i);
          }
        }
      }
    }
  }

  void chunk(uint64_t number) {
    const Chunk chunk = dopu_origin(config_, frame_, packed_.chunks[number], x_, y_);
    TimingChunk sent{static_cast<uint32_t>(number), static_cast<uint32_t>(part_.mask.size()), 0};
    ++part_.work.chunks;
    for (uint64_t i = 0; i < chunk.count; ++i) {
      ++part_.work.fetched;
      const uint64_t slot = chunk.slot + i;
      const std::optional<Visible> visible = pu_cull(config_, frame_, golden_fetched(chunk, packed_.gaussians[slot], slot));
      if (!visible) continue;
      sent.survivors |= uint64_t{1} << i;
      gaussian(*visible);
    }
    part_.chunks.push_back(sent);
  }

  void gaussian(const Visible& visible) {
    ++part_.work.visible;
    const Projected projected = pu_project(config_, frame_, visible);
    const Factors factors = pu_factors(config_, frame_, pu_jacobian(config_, frame_, pu_orient(config_, frame_, projected)));
    const Covariance covariance = pu_covariance(config_, frame_, pu_squares(config_, frame_, factors));
    const Coeff coeff = pu_coeff(config_, frame_, pu_conic(config_, frame_, covariance));
    const Tiles tiles = pu_intersect(config_, frame_, coeff);
    part_.mask.push_back(tiles.mask);
    part_.key.push_back(tiles.mask != 0 ? tiles.depth << config_.index_w | tiles.index : 0);
    part_.slot.push_back(static_cast<uint32_t>(visible.slot));
    part_.boxes.push_back(static_cast<uint8_t>(pu_intersect_regions(config_, coeff)));
    if (tiles.mask == 0) return;
    ++part_.work.records;
    part_.work.regions += static_cast<uint64_t>(std::popcount(tiles.mask));
    Splat splat{part_.key.back(), tiles.mask, {}};
    splat.job.a = tiles.a, splat.job.b = tiles.b, splat.job.c = tiles.c, splat.job.d = tiles.d, splat.job.e = tiles.e, splat.job.f = tiles.f;
    layers_.back().push_back(splat);
  }

  // Blends T only as far as it says when a region is opaque.
  void done() {
    const BlendConstants constants(config_);
    const PuRows rows(config_);
    const uint32_t black[3] = {0, 0, 0};
    std::vector<RegionState> regions;
    uint64_t done = 0;
    for (int r = 0; r < config_.regions(); ++r) {
      regions.push_back(ru_fresh_region(config_, frame_, static_cast<uint64_t>(x_), static_cast<uint64_t>(y_), r));
      done |= uint64_t{regions.back().all_done()} << r;
    }
    part_.window.outside = done;
    part_.window.done_after.fill(TimingWindow::kNotDone);
    std::array<uint32_t, 64> lines{};
    for (std::vector<Splat>& layer : layers_) {
      std::sort(layer.begin(), layer.end(), [](const Splat& a, const Splat& b) { return a.key < b.key; });
      for (const Splat& splat : layer) {
        for (uint64_t rest = splat.mask & ~done; rest != 0; rest &= rest - 1) {
          const auto r = static_cast<size_t>(std::countr_zero(rest));
          alignas(64) uint16_t codes[kRegionPixels];
          pu_region_line(rows, splat.job, static_cast<int>(r), codes);
          ++lines[r];
          if (!ru_blend_region(constants, regions[r], codes, black)) continue;
          done |= uint64_t{1} << r;
          part_.window.done_after[r] = lines[r];
        }
      }
    }
  }

  const PackedScene& packed_;
  const Config& config_;
  const Frame& frame_;
  const int x_, y_;
  const Planes planes_;
  Part part_;
  std::vector<std::vector<Splat>> layers_;  // those with at least one chunk
};

}  // namespace

Config timing_config(Config config) {
  const Config standard;
  config.units = standard.units;
  config.pixels_per_row = standard.pixels_per_row;
  config.alpha_lines = standard.alpha_lines;
  config.records = standard.records;
  config.fetch_lines = standard.fetch_lines;
  config.late = standard.late;
  config.quadratic = standard.quadratic;
  return config;
}

TimingTrace timing_trace(const GoldenInput& input, unsigned threads) {
  const PackedScene& packed = *input.packed;
  if (packed.config.order != 0) throw std::invalid_argument("timing model: there is no trace of this order yet");
  TimingTrace trace;
  trace.config = packed.config;
  trace.frame = input.frame;
  trace.cells = nodes(packed.cells);
  trace.groups = nodes(packed.groups);
  trace.chunks = nodes(packed.chunks);
  const uint64_t columns = trace.frame.last_x - trace.frame.first_x + 1;
  const uint64_t count = columns * (trace.frame.last_y - trace.frame.first_y + 1);
  std::vector<Part> parts(count);
  parallel_for(count, threads, [&](size_t i) {
    parts[i] = WindowTrace(input, static_cast<int>(trace.frame.first_x + i % columns), static_cast<int>(trace.frame.first_y + i / columns)).run();
  });
  for (Part& part : parts) {
    const auto base = static_cast<uint32_t>(trace.mask.size());
    part.window.first_chunk = trace.chunks_sent.size();
    part.window.chunks = part.chunks.size();
    for (TimingChunk chunk : part.chunks) {
      chunk.first += base;
      trace.chunks_sent.push_back(chunk);
    }
    trace.mask.insert(trace.mask.end(), part.mask.begin(), part.mask.end());
    trace.key.insert(trace.key.end(), part.key.begin(), part.key.end());
    trace.slot.insert(trace.slot.end(), part.slot.begin(), part.slot.end());
    trace.boxes.insert(trace.boxes.end(), part.boxes.begin(), part.boxes.end());
    trace.work += part.work;
    trace.windows.push_back(std::move(part.window));
    part = {};
  }
  return trace;
}

}  // namespace pipegs
