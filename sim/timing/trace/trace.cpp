// SPDX-License-Identifier: Apache-2.0
// trace.cpp: see trace.hpp.
#include "sim/timing/trace/trace.hpp"

#include <algorithm>

#include "cpp_model/eyes.hpp"
#include "cpp_model/dopu/dopu.hpp"
#include "cpp_model/dopu/dopu_walks.hpp"
#include "cpp_model/dopu/nearest/dopu_depth.hpp"
#include "cpp_model/float/parallel.hpp"
#include "cpp_model/pu/pu_parts.hpp"
#include "sim/timing/trace/trace_splat.hpp"

namespace pipegs {
namespace {

// A window's part of the trace before the parts are joined.
struct Part {
  std::vector<TimingWalk> walks;
  TimingWindow window;
  std::vector<TimingChunk> chunks;
  std::vector<uint64_t> mask, key;
  std::vector<uint32_t> slot, pairs, quads_first;  // pairs: of each survivor, how many
  std::vector<uint8_t> boxes, dropped;
  std::vector<uint16_t> most;
  std::vector<uint16_t> part, quads;
};

TimingNode range(const Node& node) { return {static_cast<uint32_t>(node.first), static_cast<uint32_t>(node.count)}; }

std::vector<TimingNode> nodes(const std::vector<Node>& from) {
  std::vector<TimingNode> result;
  result.reserve(from.size());
  for (const Node& node : from) result.push_back(range(node));
  return result;
}

void set_bit(std::vector<uint64_t>& bits, uint64_t at) { bits[at / 64] |= uint64_t{1} << (at % 64); }

class WindowTrace {
 public:
  WindowTrace(const GoldenInput& input, const PuRows& rows, int x, int y)
      : input_(input),
        packed_(*input.packed),
        config_(packed_.config),
        frame_(input.frame),
        rows_(rows),
        x_(x),
        y_(y) {}

  Part run() {
    if (config_.has_watermarks()) {
      layers_.emplace_back();
      const std::vector<uint64_t> walks = dopu_walks(config_, frame_, packed_, x_, y_);
      if (walks.front() != kWholeWalk) {
        begin(kWholeWalk);
        walk().given_up = true;
        ranked();
      }
      for (const uint64_t one : walks) {
        begin(one);
        walk().ends = one == walks.back();
        ranked();
      }
    } else {
      begin(kWholeWalk);
      slabs();
    }
    part_.window = trace_window(input_, rows_, static_cast<uint64_t>(x_), static_cast<uint64_t>(y_), layers_);
    return std::move(part_);
  }

 private:
  TimingWalk& walk() { return part_.walks.back(); }
  void begin(uint64_t walk) {
    planes_.clear();
    const int side = config_.occlusion ? static_cast<int>(walk_square(config_, walk).side) / 8 : 1;
    for (uint64_t n = 0; n < static_cast<uint64_t>(side); ++n)
      planes_.push_back(dopu_planes(config_, frame_, x_, y_, walk, {n, n, n, n}));
    eyes_ = walk_eyes(config_, frame_, walk);
    part_.walks.push_back({.walk = walk, .eyes = static_cast<int>(eyes_.size()), .first_chunk = part_.chunks.size()});
  }
  // Of a node in this bucket; with watermarks, else nothing asks for it.
  bool passes(const Node& node, int parent) const {
    const int step = config_.has_watermarks() ? dopu_depth_edge(config_, frame_, parent) : 0;
    return dopu_test(config_, frame_, planes_[0], node, step);
  }
  // Nothing when it passes for no rectangle at all. Behind the camera a tighter plane may let pass what the walk's does
  // not.
  TimingSides sides(const Node& node, int parent) const {
    if (!config_.occlusion) return passes(node, parent) ? kWholePasses : 0;
    const int step = dopu_depth_edge(config_, frame_, parent);
    TimingSides sides = 0;
    for (size_t n = 0; n < planes_.size(); ++n) {
      const unsigned passed = dopu_test_planes(config_, frame_, planes_[n], node, step);
      if ((passed >> kNear & 1) == 0) return 0;
      for (size_t side = 0; side < 4; ++side) sides |= TimingSides{passed >> (kLeft + side) & 1} << (16 * side + n);
    }
    for (size_t side = 0; side < 4; ++side) {
      if ((sides >> 16 * side & 0xffff) == 0) return 0;
    }
    return sides;
  }
  int bucket(const Node& node, int parent) const { return dopu_depth(config_, frame_, planes_[0], node, parent); }

  // Slab by slab.
  void slabs() {
    walk().cells.resize((packed_.cells.size() + 63) / 64);
    walk().groups.resize((packed_.groups.size() + 63) / 64);
    const int axis = dopu_axis(frame_), camera = dopu_layer_camera(config_, frame_, axis);
    for (int step = 0; step < 2 * config_.grid; ++step) {
      const int slab = dopu_layer_step(config_, camera, step);
      if (slab < 0) continue;
      if (config_.layered || layers_.empty()) layers_.emplace_back();
      for (int n = 0; n < config_.slab_cells(); ++n) {
        const auto number = static_cast<uint64_t>(dopu_layer_cell(config_, axis, slab, n));
        const Node& cell = packed_.cells[number];
        if (cell.count == 0 || !passes(cell, 0)) continue;
        set_bit(walk().cells, number);
        for (uint64_t g = cell.first; g < cell.first + cell.count; ++g) {
          if (!passes(packed_.groups[g], 0)) continue;
          set_bit(walk().groups, g);
          chunks(packed_.groups[g], 0);
        }
      }
    }
  }

  // In the order of the tables, with buckets of depth.
  void ranked() {
    for (uint64_t number = 0; number < packed_.cells.size(); ++number) {
      const Node& cell = packed_.cells[number];
      const TimingSides cell_sides = cell.count == 0 ? 0 : sides(cell, 0);
      if (cell_sides == 0) continue;
      const int cell_bucket = bucket(cell, 0);
      walk().cells_ranked.push_back({static_cast<uint32_t>(number), static_cast<uint32_t>(walk().groups_ranked.size()),
                                     static_cast<uint16_t>(cell_bucket), cell_sides, 0, range(cell)});
      for (uint64_t g = cell.first; g < cell.first + cell.count; ++g) {
        const Node& group = packed_.groups[g];
        const TimingSides group_sides = sides(group, cell_bucket);
        if (group_sides == 0) continue;
        const int group_bucket = bucket(group, cell_bucket);
        const int far = dopu_depth_far(config_, frame_, planes_[0], group, cell_bucket);
        const Node opened = dopu_lod(config_, frame_, group, group_bucket);
        walk().groups_ranked.push_back({static_cast<uint32_t>(g), static_cast<uint32_t>(part_.chunks.size()),
                                        static_cast<uint16_t>(group_bucket), group_sides, static_cast<uint16_t>(far),
                                        range(opened)});
        if (!walk().given_up) chunks(opened, group_bucket);
      }
    }
  }

  void chunks(const Node& group, int group_bucket) {
    for (uint64_t i = group.first; i < group.first + group.count; ++i) {
      const Node& node = packed_.chunks[i];
      const TimingSides own_sides = sides(node, group_bucket);
      if (own_sides == 0) continue;
      const int own_bucket = config_.has_watermarks() ? bucket(node, group_bucket) : 0;
      Chunk chunk = dopu_origin(config_, frame_, node, x_, y_);
      chunk.walk = walk().walk;
      TimingChunk sent{static_cast<uint32_t>(i),          static_cast<uint32_t>(part_.slot.size()),      0,
                       static_cast<uint16_t>(own_bucket), static_cast<uint32_t>(part_.walks.size() - 1), own_sides};
      for (uint64_t seen = 0; seen < chunk.count * eyes_.size(); ++seen) {
        const uint64_t slot = chunk.slot + seen / eyes_.size();
        bool dropped = false;
        Closed most;
        const std::optional<GoldenConic> found =
            trace_conic(input_, chunk, slot, &dropped, &most, eyes_[seen % eyes_.size()]);
        if (!found && !dropped) continue;
        sent.survivors |= uint64_t{1} << seen;
        part_.slot.push_back(static_cast<uint32_t>(slot));
        part_.dropped.push_back(dropped);
        if (config_.occlusion) part_.most.push_back(pack_most(most));
        if (dropped) {
          no_pair();
          continue;
        }
        const std::vector<PuPart> parts = pu_parts(config_, found->conic, chunk.walk, found->payload.eye);
        part_.pairs.push_back(static_cast<uint32_t>(parts.size()));
        for (const PuPart& one : parts) {
          const TracePair pair = trace_pair(input_, one.conic, found->payload, one.part);
          part_.mask.push_back(pair.splat.mask);
          part_.key.push_back(pair.splat.key);
          part_.boxes.push_back(pair.boxes);
          part_.part.push_back(static_cast<uint16_t>(one.part));
          trace_quads(rows_, pair.splat, part_.quads, part_.quads_first);
          if (pair.splat.mask != 0) layers_.back().push_back(pair.splat);
        }
      }
      part_.chunks.push_back(sent);
      ++walk().chunks;
    }
  }

  // Of a survivor that pu_reach drops. Without parts its pair has its number.
  void no_pair() {
    part_.pairs.push_back(0);
    if (config_.parts() > 1) return;
    part_.mask.push_back(0);
    part_.key.push_back(0);
    part_.boxes.push_back(0);
    part_.part.push_back(0);
    trace_quads(rows_, {}, part_.quads, part_.quads_first);
  }

  const GoldenInput& input_;
  const PackedScene& packed_;
  const Config& config_;
  const Frame& frame_;
  const PuRows& rows_;
  const int x_, y_;
  std::vector<int> eyes_;       // of the present walk
  std::vector<Planes> planes_;  // of the present walk; with Occlusion also with 1, 2 ... regions of each side closed
  Part part_;
  std::vector<std::vector<TraceSplat>> layers_;
};

void trace_windows(const GoldenInput& input, unsigned threads, TimingTrace& trace) {
  const uint64_t columns = trace.frame.raster.windows.last_x - trace.frame.raster.windows.first_x + 1;
  const uint64_t count = columns * (trace.frame.raster.windows.last_y - trace.frame.raster.windows.first_y + 1);
  const PuRows rows(input.packed->config);
  std::vector<Part> parts(count);
  parallel_for(count, threads, [&](size_t i) {
    parts[i] = WindowTrace(input, rows, static_cast<int>(trace.frame.raster.windows.first_x + i % columns),
                           static_cast<int>(trace.frame.raster.windows.first_y + i / columns))
                   .run();
  });
  for (Part& part : parts) {
    const auto base = static_cast<uint32_t>(trace.slot.size()),
               chunks = static_cast<uint32_t>(trace.chunks_sent.size()),
               quads = static_cast<uint32_t>(trace.quads.size());
    const auto walks = static_cast<uint32_t>(trace.walks.size());
    for (TimingWalk& walk : part.walks) {
      walk.window = trace.windows.size();
      walk.first_chunk += chunks;
      for (TimingParent& group : walk.groups_ranked) group.first += chunks;
      trace.walks.push_back(std::move(walk));
    }
    for (TimingChunk chunk : part.chunks) {
      chunk.first += base;
      chunk.walk += walks;
      trace.chunks_sent.push_back(chunk);
    }
    if (trace.config.parts() > 1) {
      auto pair = static_cast<uint32_t>(trace.mask.size());
      for (size_t i = 0; i < part.pairs.size(); ++i) {
        trace.pairs.push_back(pair);
        trace.survivor.insert(trace.survivor.end(), part.pairs[i], base + static_cast<uint32_t>(i));
        pair += part.pairs[i];
      }
      trace.number.insert(trace.number.end(), part.part.begin(), part.part.end());
    }
    trace.mask.insert(trace.mask.end(), part.mask.begin(), part.mask.end());
    trace.key.insert(trace.key.end(), part.key.begin(), part.key.end());
    trace.slot.insert(trace.slot.end(), part.slot.begin(), part.slot.end());
    trace.dropped.insert(trace.dropped.end(), part.dropped.begin(), part.dropped.end());
    trace.most.insert(trace.most.end(), part.most.begin(), part.most.end());
    trace.boxes.insert(trace.boxes.end(), part.boxes.begin(), part.boxes.end());
    for (const uint32_t first : part.quads_first) trace.quads_first.push_back(quads + first);
    trace.quads.insert(trace.quads.end(), part.quads.begin(), part.quads.end());
    trace.windows.push_back(std::move(part.window));
    part = {};
  }
  if (trace.config.parts() > 1) trace.pairs.push_back(static_cast<uint32_t>(trace.mask.size()));
}

}  // namespace

Config timing_config(Config config) {
  const Config standard;
  config.units = standard.units;
  config.pixels_per_row = standard.pixels_per_row;
  config.pace = standard.pace;
  config.alpha_lines = standard.alpha_lines;
  config.alpha_layers = standard.alpha_layers;
  config.records = standard.records;
  config.fetch_lines = standard.fetch_lines;
  if (!config.has_watermarks()) config.bucket_bits = standard.bucket_bits;
  if (!config.has_watermarks()) config.nearest_nodes = standard.nearest_nodes;  // see table_cells, dopu_load
  config.mark_chunks = standard.mark_chunks;
  config.late = standard.late;
  config.quadratic = standard.quadratic;
  config.taps = standard.taps;
  return config;
}

TimingTrace timing_trace(const GoldenInput& input, unsigned threads) {
  const PackedScene& packed = *input.packed;
  TimingTrace trace;
  trace.config = packed.config;
  trace.frame = input.frame;
  trace.picture = input.picture;
  trace.slots = packed.gaussians.size();
  trace.cells = nodes(packed.cells);
  trace.groups = nodes(packed.groups);
  trace.chunks = nodes(packed.chunks);
  packed.config.has_lists() ? trace_lists(input, threads, trace) : trace_windows(input, threads, trace);
  return trace;
}

}  // namespace pipegs
