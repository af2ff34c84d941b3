// SPDX-License-Identifier: Apache-2.0
// trace.cpp: see trace.hpp.
#include "sim/timing/trace/trace.hpp"

#include <algorithm>
#include <cstdio>
#include <bit>
#include <cmath>
#include <optional>
#include <string>

#include "cpp_model/dopu/dopu.hpp"
#include "cpp_model/dopu/nearest/dopu_depth.hpp"
#include "cpp_model/float/parallel.hpp"
#include "cpp_model/pu/pu_parts.hpp"
#include "sim/timing/trace/trace_splat.hpp"
#include "sim/timing/knobs.hpp"
#include "cpp_model/pu/front/pu_cull.hpp"
#include "cpp_model/pu/front/pu_reach.hpp"
#include "cpp_model/pu/conic/pu_coeff.hpp"
#include "cpp_model/pu/conic/pu_intersect.hpp"
#include "cpp_model/su/su.hpp"

namespace pipegs {
namespace {

// A window's part of the trace before the parts are joined.
struct Part {
  std::vector<TimingWalk> walks;
  TimingWalk walk;
  std::vector<RegionSet> reach_box;
  TimingWindow window;
  std::vector<TimingChunk> chunks;
  std::vector<uint64_t> mask, key;
  std::vector<uint32_t> slot, pairs, quads_first;  // pairs: of each survivor, how many
  std::vector<uint8_t> boxes, dropped;
  std::vector<uint16_t> part, quads;
};

std::vector<TimingNode> nodes(const std::vector<Node>& from) {
  std::vector<TimingNode> result;
  result.reserve(from.size());
  for (const Node& node : from)
    result.push_back({static_cast<uint32_t>(node.first), static_cast<uint32_t>(node.count)});
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
        y_(y),
        planes_(dopu_planes(config_, frame_, x, y)) {}

  Part run() {
    if (config_.has_watermarks()) {
      layers_.emplace_back();
      plan();
    } else {
      slabs();
      part_.walk.rect = ~RegionSet{};
      part_.walk.chunks = part_.chunks.size();
      part_.walks.push_back(std::move(part_.walk));
    }
    part_.window = trace_window(input_, rows_, static_cast<uint64_t>(x_), static_cast<uint64_t>(y_), layers_);
    return std::move(part_);
  }

 private:
  // Of a node in this bucket; with watermarks, else nothing asks for it.
  bool passes(const Node& node, int parent) const {
    const int step = config_.has_watermarks() ? dopu_depth_edge(config_, frame_, parent) : 0;
    return dopu_test(config_, frame_, planes_, node, step);
  }
  int bucket(const Node& node, int parent) const { return dopu_depth(config_, frame_, planes_, node, parent); }
  // Bucket of the farthest corner of the means' box, never too near.
  uint16_t far(const Node& node, int parent) const {
    const Corners box = dopu_test_corners(config_, frame_, node, dopu_depth_edge(config_, frame_, parent));
    const Plane& near = planes_[kNear];
    const int64_t bound = near.nx * (near.nx >= 0 ? box.means_high[0] : box.means_low[0]) +
                          near.ny * (near.ny >= 0 ? box.means_high[1] : box.means_low[1]) +
                          near.nz * (near.nz >= 0 ? box.means_high[2] : box.means_low[2]) + dopu_depth_slack(config_);
    const int step = dopu_depth_step(config_, bound, box.exponent - kNormalF);
    return static_cast<uint16_t>(std::clamp(step - dopu_depth_near(config_, frame_), 0, (1 << config_.bucket_w()) - 1));
  }
  // Share of a box between the planes: in x times in y, each by the distances of its corners.
  float share(const Node& node, int parent) const {
    const Corners box = dopu_test_corners(config_, frame_, node, dopu_depth_edge(config_, frame_, parent));
    const auto outside = [&](const Plane& p) {
      const double most = double(p.nx * (p.nx >= 0 ? box.high[0] : box.low[0]) + p.ny * (p.ny >= 0 ? box.high[1] : box.low[1]) + p.nz * (p.nz >= 0 ? box.high[2] : box.low[2]));
      const double least = double(p.nx * (p.nx >= 0 ? box.low[0] : box.high[0]) + p.ny * (p.ny >= 0 ? box.low[1] : box.high[1]) + p.nz * (p.nz >= 0 ? box.low[2] : box.high[2]));
      if (least >= 0 || most <= least) return 0.0;
      return std::min(1.0, -least / (most - least));
    };
    const double x = 1 - outside(planes_[kLeft]) - outside(planes_[kRight]), y = 1 - outside(planes_[kTop]) - outside(planes_[kBottom]);
    return static_cast<float>(std::max(x, 1 / 16.0) * std::max(y, 1 / 16.0));
  }
  bool by_part_ = false;
  uint16_t placed(const RegionSet& box, int bucket) const {  // part before depth
    if (!by_part_) return static_cast<uint16_t>(bucket);
    int part = 0;
    while (part < 3 && box.mask[static_cast<size_t>(part)] == 0) ++part;
    return static_cast<uint16_t>(part << (config_.bucket_w() - 2) | bucket >> 2);
  }

  // Slab by slab.
  void slabs() {
    part_.walk.cells.resize((packed_.cells.size() + 63) / 64);
    part_.walk.groups.resize((packed_.groups.size() + 63) / 64);
    const int axis = dopu_axis(frame_), camera = dopu_layer_camera(config_, frame_, axis);
    for (int step = 0; step < 2 * config_.grid; ++step) {
      const int slab = dopu_layer_step(config_, camera, step);
      if (slab < 0) continue;
      if (config_.layered || layers_.empty()) layers_.emplace_back();
      for (int n = 0; n < config_.grid * config_.grid; ++n) {
        const auto number = static_cast<uint64_t>(dopu_layer_cell(config_, axis, slab, n));
        const Node& cell = packed_.cells[number];
        if (cell.count == 0 || !passes(cell, 0)) continue;
        set_bit(part_.walk.cells, number);
        for (uint64_t g = cell.first; g < cell.first + cell.count; ++g) {
          if (!passes(packed_.groups[g], 0)) continue;
          set_bit(part_.walk.groups, g);
          chunks(packed_.groups[g], 0);
        }
      }
    }
  }

  uint64_t count(const Planes& planes) const {  // Gaussians of the chunks that pass
    uint64_t sum = 0;
    for (const Node& cell : packed_.cells) {
      if (cell.count == 0 || !dopu_test(config_, frame_, planes, cell, dopu_depth_edge(config_, frame_, 0))) continue;
      const int cb = dopu_depth(config_, frame_, planes, cell, 0);
      for (uint64_t g = cell.first; g < cell.first + cell.count; ++g) {
        const Node& group = packed_.groups[g];
        if (!dopu_test(config_, frame_, planes, group, dopu_depth_edge(config_, frame_, cb))) continue;
        sum += group.count * static_cast<uint64_t>(config_.chunk);
      }
    }
    return sum;
  }
  struct Square { int x, y; };
  void sub(int side, int sx, int sy, int part, RegionSet rect, char variant = 'W', int place = 0, std::vector<Square> squares = {}) {
    side_ = side, sx_ = sx, sy_ = sy;
    squares_ = squares.empty() ? std::vector<Square>{{sx, sy}} : squares;
    rect_ = rect;
    sub_ = config_;
    sub_.window = side;
    planes_ = dopu_planes(sub_, frame_, sx, sy);
    if (variant == 'H' || variant == 'V') {
      const Planes wide = dopu_planes(config_, frame_, x_, y_);
      for (const PlaneSide s : {kLeft, kRight, kTop, kBottom})
        if ((variant == 'H') == (s == kLeft || s == kRight)) planes_[s] = wide[s];
    }
    again_ = variant != 'W';
    part_.walk = {};
    part_.walk.first_chunk = part_.chunks.size();
    part_.walk.part = part;
    part_.walk.rect = rect;
    part_.walk.last = false;
    part_.walk.variant = variant;
    part_.walk.place = place;
    ranked();
    part_.walk.chunks = part_.chunks.size() - part_.walk.first_chunk;
    part_.walks.push_back(std::move(part_.walk));
  }
  // Every walk that a rule may choose, for windows that are not small.
  void variants() {
    const auto width = static_cast<int>(frame_.raster.width), height = static_cast<int>(frame_.raster.height);
    sub(config_.window, x_, y_, -1, ~RegionSet{});
    if (config_.window != 128 || part_.slot.size() < static_cast<size_t>(x_variants())) return;
    const auto inside = [&](int side, int x, int y) { return x * side < width && y * side < height; };
    const auto mask = [](int p) { RegionSet r; r.mask[static_cast<size_t>(p)] = ~uint64_t{0}; return r; };
    for (const char v : {'H', 'V'}) {
      for (int i = 0; i < 2; ++i) {
        const int a = v == 'H' ? 2 * i : i, b = v == 'H' ? 2 * i + 1 : i + 2;
        RegionSet rect;
        std::vector<Square> squares;
        for (const int p : {a, b}) {
          const Square q{2 * x_ + (p & 1), 2 * y_ + (p >> 1)};
          if (!inside(64, q.x, q.y)) continue;
          squares.push_back(q);
          rect |= mask(p);
        }
        if (!squares.empty()) sub(64, squares[0].x, squares[0].y, a, rect, v, i, squares);
      }
    }
    for (int p = 0; p < 4; ++p) {
      const int px = 2 * x_ + (p & 1), py = 2 * y_ + (p >> 1);
      if (!inside(64, px, py)) continue;
      const size_t before = part_.slot.size();
      sub(64, px, py, p, mask(p), 'F', p);
      if (part_.slot.size() - before < static_cast<size_t>(x_variants())) continue;
      for (int q = 0; q < 4; ++q) {
        const int qx = 2 * px + (q & 1), qy = 2 * py + (q >> 1);
        if (!inside(32, qx, qy)) continue;
        RegionSet rect;
        for (int y = 0; y < 4; ++y)
          rect.mask[static_cast<size_t>(p)] |= uint64_t{0xf} << (8 * (4 * (q >> 1) + y) + 4 * (q & 1));
        sub(32, qx, qy, p, rect, 'S', 4 * p + q);
      }
    }
  }
  void plan() {
    if (x_variants() != 0) {
      variants();
      for (TimingWalk& walk : part_.walks) walk.last = true;
      return;
    }
    const auto width = static_cast<int>(frame_.raster.width), height = static_cast<int>(frame_.raster.height);
    if (x_part() != 0) {
      by_part_ = count(planes_) > static_cast<uint64_t>(x_split());
      sub(config_.window, x_, y_, -1, ~RegionSet{});
      part_.walks.back().by_part = by_part_;
    } else if (config_.window == 128 && count(planes_) > static_cast<uint64_t>(x_split())) {
      for (int p = 0; p < 4; ++p) {
        const int px = 2 * x_ + (p & 1), py = 2 * y_ + (p >> 1);
        if (px * 64 >= width || py * 64 >= height) continue;
        Config c64 = config_;
        c64.window = 64;
        RegionSet whole;
        whole.mask[static_cast<size_t>(p)] = ~uint64_t{0};
        if (count(dopu_planes(c64, frame_, px, py)) > static_cast<uint64_t>(x_split2())) {
          for (int q = 0; q < 4; ++q) {
            const int qx = 2 * px + (q & 1), qy = 2 * py + (q >> 1);
            if (qx * 32 >= width || qy * 32 >= height) continue;
            RegionSet rect;
            for (int y = 0; y < 4; ++y)
              rect.mask[static_cast<size_t>(p)] |= uint64_t{0xf} << (8 * (4 * (q >> 1) + y) + 4 * (q & 1));
            sub(32, qx, qy, p, rect);
          }
        } else {
          sub(64, px, py, p, whole);
        }
      }
    } else {
      sub(config_.window, x_, y_, -1, ~RegionSet{});
    }
    part_.walks.back().last = true;
  }

  // In the order of the tables, with buckets of depth.
  void ranked() {
    for (uint64_t number = 0; number < packed_.cells.size(); ++number) {
      const Node& cell = packed_.cells[number];
      if (cell.count == 0 || !passes(cell, 0)) continue;
      const int cell_bucket = bucket(cell, 0);
      part_.walk.cells_ranked.push_back({static_cast<uint32_t>(number),
                                         static_cast<uint32_t>(part_.walk.groups_ranked.size()),
                                         placed(~RegionSet{}, cell_bucket), ~RegionSet{}, far(cell, 0)});
      for (uint64_t g = cell.first; g < cell.first + cell.count; ++g) {
        const Node& group = packed_.groups[g];
        if (!passes(group, cell_bucket)) continue;
        const int group_bucket = bucket(group, cell_bucket);
        part_.walk.groups_ranked.push_back({static_cast<uint32_t>(g), static_cast<uint32_t>(part_.chunks.size()),
                                            static_cast<uint16_t>(group_bucket), {}, far(group, cell_bucket), share(group, cell_bucket)});
        const size_t at = part_.chunks.size();
        chunks(group, group_bucket);
        for (size_t i = at; i < part_.chunks.size(); ++i) part_.walk.groups_ranked.back().box |= part_.chunks[i].box;
        part_.walk.groups_ranked.back().bucket = placed(part_.walk.groups_ranked.back().box, group_bucket);
        for (size_t i = at; i < part_.chunks.size(); ++i)
          part_.chunks[i].bucket = std::max(placed(part_.chunks[i].box, part_.chunks[i].bucket), part_.walk.groups_ranked.back().bucket);
        part_.walk.groups_ranked.back().box = rectangle(part_.walk.groups_ranked.back().box, x_grow());
      }
    }
  }

  // The rectangle around regions, `grow` larger on each side.
  RegionSet rectangle(const RegionSet& of, int grow) const {
    int x0 = 99, x1 = -1, y0 = 99, y1 = -1;
    for (int r = 0; r < config_.regions(); ++r) {
      if (!of.has(config_, r)) continue;
      x0 = std::min(x0, region_x(config_, r)), x1 = std::max(x1, region_x(config_, r));
      y0 = std::min(y0, region_y(config_, r)), y1 = std::max(y1, region_y(config_, r));
    }
    RegionSet result;
    if (x1 < 0) return result;
    const int most = config_.window / 8 - 1;
    for (int y = std::max(0, y0 - grow); y <= std::min(most, y1 + grow); ++y)
      for (int x = std::max(0, x0 - grow); x <= std::min(most, x1 + grow); ++x) result.add(config_, region_at(config_, x, y));
    return result;
  }
  // Regions that the ball of a Gaussian's largest scale may touch.
  RegionSet ball(const Chunk& chunk, uint64_t slot) const {
    const GaussianRecord& g = packed_.gaussians[slot];
    const Fetched f = golden_fetched(chunk, g, slot);
    const double unit = std::ldexp(1.0, static_cast<int>(f.view_exp)), ou = std::ldexp(1.0, static_cast<int>(f.offset_exp)), rf = std::ldexp(1.0, -config_.rot_f());
    const Rotation& r = frame_.camera.rotation;
    const double ox = double(f.offset_x) * ou, oy = double(f.offset_y) * ou, oz = double(f.offset_z) * ou;
    const double x = double(f.origin_x) * unit + rf * (double(r.w00) * ox + double(r.w01) * oy + double(r.w02) * oz);
    const double y = double(f.origin_y) * unit + rf * (double(r.w10) * ox + double(r.w11) * oy + double(r.w12) * oz);
    const double z = double(f.origin_z) * unit + rf * (double(r.w20) * ox + double(r.w21) * oy + double(r.w22) * oz);
    RegionSet all = ~RegionSet{};
    if (z < double(frame_.lens.near_plane)) return all;
    double s = 0;
    for (const uint64_t e : {g.scale_0, g.scale_1, g.scale_2}) {
      const int ex = static_cast<int>(e >> config_.scale_m_w);
      if (ex == 0) continue;
      s = std::max(s, (1 + double(e & ((1u << config_.scale_m_w) - 1)) / double(1u << config_.scale_m_w)) * std::ldexp(1.0, ex - 8));
    }
    const double op = double(g.opacity) / double(1 << config_.opacity_f);
    const double w = std::sqrt(std::max(0.0, (std::log2(255.0) - op) / std::log2(255.0)));
    const double fx = double(frame_.lens.focal_x) / double(1 << config_.focal_f()), cx = double(frame_.lens.center_x) / double(1 << config_.center_f());
    const double fy = double(frame_.lens.focal_y) / double(1 << config_.focal_f()), cy = double(frame_.lens.center_y) / double(1 << config_.center_f());
    const double reach = double(frame_.lens.reach_x) / 16384.0 * s * w / z + 2;
    const double px = fx * x / z + cx - x_ * config_.window, py = fy * y / z + cy - y_ * config_.window;
    const int x0 = static_cast<int>(std::floor(std::max(-1e6, px - reach) / 8)), x1 = static_cast<int>(std::floor(std::min(1e6, px + reach) / 8));
    const int y0 = static_cast<int>(std::floor(std::max(-1e6, py - reach) / 8)), y1 = static_cast<int>(std::floor(std::min(1e6, py + reach) / 8));
    RegionSet result;
    const int most = config_.window / 8 - 1;
    for (int yy = std::max(0, y0); yy <= std::min(most, y1); ++yy)
      for (int xx = std::max(0, x0); xx <= std::min(most, x1); ++xx) result.add(config_, region_at(config_, xx, yy));
    return result;
  }
  std::optional<GoldenConic> conic_of(const Chunk& chunk, uint64_t slot, bool* late) const {
    std::optional<Visible> visible;
    *late = false;
    for (const Square& square : squares_) {
      Chunk here = chunk;
      here.window_x = static_cast<uint64_t>(square.x), here.window_y = static_cast<uint64_t>(square.y);
      Gap gap;
      std::optional<Visible> one = pu_cull(sub_, frame_, golden_fetched(here, packed_.gaussians[slot], slot), nullptr, &gap);
      if (!one) continue;
      if (config_.tight_cull && !pu_reach(sub_, frame_, *one, gap)) {
        *late = true;
        continue;
      }
      visible = one;
      break;
    }
    if (!visible) return std::nullopt;
    *late = false;
    visible->window_x = static_cast<uint64_t>(x_), visible->window_y = static_cast<uint64_t>(y_);
    return golden_conic(config_, frame_, *visible);
  }
  void chunks(const Node& group, int group_bucket) {
    for (uint64_t i = group.first; i < group.first + group.count; ++i) {
      const Node& node = packed_.chunks[i];
      if (!passes(node, group_bucket)) continue;
      const int own_bucket = config_.has_watermarks() ? bucket(node, group_bucket) : 0;
      const Chunk chunk = dopu_origin(config_, frame_, node, sx_, sy_);
      TimingChunk sent{static_cast<uint32_t>(i), static_cast<uint32_t>(part_.slot.size()), 0,
                       static_cast<uint16_t>(own_bucket), {}, static_cast<uint32_t>(chunk.count),
                       config_.has_watermarks() ? far(node, group_bucket) : uint16_t{0}};
      for (uint64_t k = 0; k < chunk.count; ++k) {
        sent.box |= ball(chunk, chunk.slot + k);
        bool dropped = false;
        const std::optional<GoldenConic> found = config_.has_watermarks() ? conic_of(chunk, chunk.slot + k, &dropped) : trace_conic(input_, chunk, chunk.slot + k, &dropped);
        if (!found && !dropped) continue;
        sent.survivors |= uint64_t{1} << k;
        part_.slot.push_back(static_cast<uint32_t>(chunk.slot + k));
        part_.dropped.push_back(dropped);
        part_.reach_box.emplace_back();
        if (dropped) {
          no_pair();
          continue;
        }
        const std::vector<PuPart> parts = pu_parts(config_, found->conic);
        uint32_t number = 0;
        RegionSet box;
        for (const PuPart& one : parts) {
          if (rect_.mask[one.part] == 0) continue;
          ++number;
          TracePair pair = trace_pair(input_, one.conic, found->payload, one.part);
          if (~rect_.mask[one.part] != 0) {
            pair.splat.mask &= rect_.mask[one.part];
            if (pair.boxes != 0)
              pair.boxes = static_cast<uint8_t>(std::max(1, std::min<int>(pair.boxes, (std::popcount(pair.splat.mask) + 2) / 2)));
          }
          box.mask[one.part] |= pair.splat.mask;
          part_.mask.push_back(pair.splat.mask);
          if (x_part() != 0) {
            const uint64_t low = pair.splat.key >> 2;
            if (by_part_) {
              pair.splat.key = uint64_t{one.part} << 48 | low;
            } else {
              pair.splat.key = low;
            }
            if (by_part_) pair.splat.key |= uint64_t{1} << 62;
          }
          part_.key.push_back(pair.splat.key);
          part_.boxes.push_back(pair.boxes);
          part_.part.push_back(static_cast<uint16_t>(one.part));
          trace_quads(rows_, pair.splat, part_.quads, part_.quads_first);
          if (pair.splat.mask != 0 && !again_) layers_.back().push_back(pair.splat);
        }
        part_.pairs.push_back(number);
        box = rectangle(box, 0);
        part_.reach_box.back() = box;
      }
      sent.box = rectangle(sent.box, x_grow());
      part_.chunks.push_back(sent);
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
  Planes planes_;
  Config sub_ = config_;
  bool again_ = false;
  std::vector<Square> squares_ = {{x_, y_}};
  int side_ = 0, sx_ = x_, sy_ = y_;
  RegionSet rect_ = ~RegionSet{};
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
    for (TimingWalk& walk : part.walks) {
      walk.first_chunk += chunks;
      walk.window = trace.windows.size();
      for (TimingParent& group : walk.groups_ranked) group.first += chunks;
      trace.walks.push_back(std::move(walk));
    }
    trace.reach_box.insert(trace.reach_box.end(), part.reach_box.begin(), part.reach_box.end());
    for (TimingChunk chunk : part.chunks) {
      chunk.first += base;
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
    trace.boxes.insert(trace.boxes.end(), part.boxes.begin(), part.boxes.end());
    for (const uint32_t first : part.quads_first) trace.quads_first.push_back(quads + first);
    trace.quads.insert(trace.quads.end(), part.quads.begin(), part.quads.end());
    trace.windows.push_back(std::move(part.window));
    part = {};
  }
  if (trace.config.parts() > 1) trace.pairs.push_back(static_cast<uint32_t>(trace.mask.size()));
  if (x_stat() != 0) {
    uint64_t boxes = 0, b3 = 0, b4 = 0, regions = 0, records = 0, dropped = 0, hist[6] = {}, gaussians = 0, split = 0, half = 0;
    for (const uint8_t d : trace.dropped) dropped += d;
    for (size_t i = 0; i < trace.mask.size(); ++i) {
      const uint64_t b = trace.boxes[i];
      boxes += b, b3 += std::max<uint64_t>(3, b), b4 += std::max<uint64_t>(4, b), half += std::max<uint64_t>(4, (b + 1) / 2);
      regions += static_cast<uint64_t>(std::popcount(trace.mask[i]));
      records += trace.mask[i] != 0;
      ++hist[b == 0 ? 0 : b <= 2 ? 1 : b <= 4 ? 2 : b <= 8 ? 3 : b <= 16 ? 4 : 5];
    }
    for (const TimingChunk& c : trace.chunks_sent) gaussians += c.gaussians;
    for (const TimingWalk& w : trace.walks) split += !w.last || w.part >= 0;
    fprintf(stderr, "walks %zu (split %zu) chunks %zu fetched %zu survivors %zu dropped by reach %zu pairs %zu records %zu regions %zu boxes/4 %zu max3/4 %zu max4/4 %zu half4/4 %zu hist %zu %zu %zu %zu %zu %zu\n", trace.walks.size(), split, trace.chunks_sent.size(), gaussians, trace.slot.size(), dropped, trace.mask.size(), records, regions, boxes / 4, b3 / 4, b4 / 4, half / 4, hist[0], hist[1], hist[2], hist[3], hist[4], hist[5]);
  }
}

// Groups of the whole windows' walks by the quadrant in which their centre lies: walk, near, far, Gaussians, quadrant
// (left or right, upper or lower by the middle planes), 1: the centre is inside the window.
void dump_centres(const GoldenInput& input, const TimingTrace& trace, const char* name) {
  FILE* out = std::fopen((std::string(name) + ".ctr").c_str(), "wb");
  const PackedScene& packed = *input.packed;
  const Config& c = trace.config;
  const int columns = (static_cast<int>(input.frame.raster.width) + c.window - 1) / c.window;
  Config half = c;
  half.window = c.window / 2;
  for (size_t n = 0; n < trace.walks.size(); ++n) {
    const TimingWalk& walk = trace.walks[n];
    if (walk.variant != 'W') continue;
    const int x = static_cast<int>(walk.window) % columns, y = static_cast<int>(walk.window) / columns;
    const Planes whole = dopu_planes(c, input.frame, x, y), first = dopu_planes(half, input.frame, 2 * x, 2 * y);
    for (const TimingParent& g : walk.groups_ranked) {
      const Corners box = dopu_test_corners(c, input.frame, packed.groups[g.node], dopu_depth_edge(c, input.frame, g.bucket));
      const auto in = [&](const Plane& p) {
        return p.nx * (box.means_low[0] + box.means_high[0]) + p.ny * (box.means_low[1] + box.means_high[1]) +
                   p.nz * (box.means_low[2] + box.means_high[2]) >= 0;
      };
      const bool inside = in(whole[kLeft]) && in(whole[kRight]) && in(whole[kTop]) && in(whole[kBottom]);
      const int q = (in(first[kRight]) ? 0 : 1) + (in(first[kBottom]) ? 0 : 2);
      for (const int v : {static_cast<int>(n), static_cast<int>(g.bucket), static_cast<int>(g.far), static_cast<int>(trace.groups[g.node].count) * c.chunk, q, int{inside}})
        std::fwrite(&v, 4, 1, out);
    }
  }
  std::fclose(out);
}

}  // namespace

Config timing_config(Config config) {
  const Config standard;
  config.units = standard.units;
  config.pixels_per_row = standard.pixels_per_row;
  config.alpha_lines = standard.alpha_lines;
  config.alpha_layers = standard.alpha_layers;
  config.records = standard.records;
  config.fetch_lines = standard.fetch_lines;
  if (!config.has_watermarks()) config.bucket_bits = standard.bucket_bits;
  config.nearest_nodes = standard.nearest_nodes;
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
  const char* cache = knob_text("X_CACHE");
  if (cache != nullptr && load_trace(trace, cache)) {
    if (const char* name = knob_text("X_CENTRES")) dump_centres(input, trace, name);
    run_batch(trace);
    return trace;
  }
  packed.config.has_lists() ? trace_lists(input, threads, trace) : trace_windows(input, threads, trace);
  if (cache != nullptr) save_trace(trace, cache);
  run_batch(trace);
  return trace;
}

}  // namespace pipegs
