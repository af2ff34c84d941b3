// SPDX-License-Identifier: Apache-2.0
// golden.cpp: see golden.hpp.
#include "cpp_model/golden.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <mutex>
#include <numeric>

#include "cpp_model/aov_image.hpp"
#include "cpp_model/dopu/dopu.hpp"
#include "cpp_model/dopu/nearest/dopu_nearest.hpp"
#include "cpp_model/dopu/dopu_walks.hpp"
#include "cpp_model/eyes.hpp"
#include "cpp_model/float/parallel.hpp"
#include "cpp_model/pu/box/pu_axes.hpp"
#include "cpp_model/pu/box/pu_box.hpp"
#include "cpp_model/pu/conic/pu_coeff.hpp"
#include "cpp_model/pu/color/pu_color.hpp"
#include "cpp_model/pu/project/pu_compensate.hpp"
#include "cpp_model/pu/conic/pu_conic.hpp"
#include "cpp_model/pu/project/pu_covariance.hpp"
#include "cpp_model/pu/front/pu_cull.hpp"
#include "cpp_model/pu/list/pu_expand.hpp"
#include "cpp_model/pu/project/pu_factors.hpp"
#include "cpp_model/pu/conic/pu_intersect.hpp"
#include "cpp_model/pu/pu_parts.hpp"
#include "cpp_model/pu/project/pu_jacobian.hpp"
#include "cpp_model/pu/project/pu_orient.hpp"
#include "cpp_model/pu/project/pu_project.hpp"
#include "cpp_model/pu/front/pu_reach.hpp"
#include "cpp_model/pu/rows/pu_rows.hpp"
#include "cpp_model/pu/project/pu_squares.hpp"
#include "cpp_model/ru/ru_quads.hpp"
#include "cpp_model/ru/ru_resolve.hpp"
#include "cpp_model/su/su.hpp"

namespace pipegs {
namespace {

RowJob row_job(const Tiles& t, uint64_t index) {
  RowJob job;
  job.a = t.a, job.b = t.b, job.c = t.c, job.d = t.d, job.e = t.e, job.f = t.f;
  job.mask = t.mask;
  job.index = index;
  return job;
}

ColorJob color_job(const Payload& p, uint64_t mask) {
  ColorJob job;
  job.depth = p.depth, job.index = p.index, job.slot = p.slot, job.mask = mask;
  job.dir_x = p.dir_x, job.dir_y = p.dir_y, job.dir_z = p.dir_z;
  job.base_r = p.base_r, job.base_g = p.base_g, job.base_b = p.base_b;
  return job;
}

// What the SU takes; where the alphas lie depends on timing and stays zero.
Splat golden_splat(const Config& config, const Colored& colored, uint64_t part, const Tiles& t) {
  Splat splat{.kind = colored.kind,
              .depth = colored.depth,
              .part = part,
              .index = colored.index,
              .mask = t.mask,
              .address = 0,
              .ext = 0,
              .red = colored.red,
              .green = colored.green,
              .blue = colored.blue};
  if (!config.caches_alphas()) splat.a = t.a, splat.b = t.b, splat.c = t.c, splat.d = t.d, splat.e = t.e, splat.f = t.f;
  return splat;
}

// One Gaussian up to its conic, in the view of an eye; nothing when the cull drops it.
std::optional<GoldenConic> project(const GoldenInput& input, const Fetched& fetched, int eye, Work& work,
                                   Saturations& saturations, Called& called) {
  const Config& config = input.packed->config;
  const Frame& frame = input.frame;
  Gap gap;
  const std::optional<Visible> visible =
      pu_cull(config, frame, fetched, eye == 0 ? &called.near : nullptr, &gap, {}, nullptr, eye);
  if (!visible || (config.tight_cull && !pu_reach(config, frame, *visible, gap))) return std::nullopt;
  ++work.visible;
  ProjectCounts counts;
  const GoldenConic conic = golden_conic(config, frame, *visible, &counts);
  saturations.mean += counts.saturated;
  called.guard += counts.clamped;
  return conic;
}

// The regions of a Gaussian in the part (or window of a list) that its mean is relative to; counts what has some.
Tiles intersect(const GoldenInput& input, const Conic& conic, GoldenWindow& window) {
  const Coeff coeff = pu_coeff(input.packed->config, input.frame, conic);
  window.saturations.dead += coeff.dead;
  const Tiles tiles = pu_intersect(input.packed->config, input.frame, coeff);
  window.work.records += tiles.mask != 0;
  window.work.regions += static_cast<uint64_t>(std::popcount(tiles.mask));
  return tiles;
}

Colored color(const GoldenInput& input, const ColorJob& job, Saturations& saturations) {
  const Config& config = input.packed->config;
  ColorCounts counts;
  const uint32_t* line =
      color_degree(config, input.frame) == 0
          ? nullptr
          : input.packed->colors[color_line(config, input.frame, job.slot) - input.frame.tables.colors].data();
  const Colored colored = pu_color(config, input.frame, job, line, &counts);
  saturations.color += counts.saturated;
  return colored;
}

// One Gaussian through the PU, in the view of an eye; appends to the layer what survives.
void preprocess(const GoldenInput& input, const Fetched& fetched, int eye, GoldenWindow& window, GoldenLayer& layer) {
  const std::optional<GoldenConic> found = project(input, fetched, eye, window.work, window.saturations, window.called);
  if (!found) return;
  const auto& [conic, payload] = *found;
  std::optional<Colored> colored;  // once for all parts
  for (const PuPart& one : pu_parts(input.packed->config, conic, fetched.walk, payload.eye)) {
    const Tiles tiles = intersect(input, one.conic, window);
    if (tiles.mask == 0) continue;
    if (!colored) colored = color(input, color_job(payload, tiles.mask), window.saturations);
    layer.splats.push_back(
        {golden_splat(input.packed->config, *colored, one.part, tiles), row_job(tiles, payload.index)});
  }
}

// The list of a window: its candidates with at least one region.
void read_list(const GoldenInput& input, GoldenWindow& window) {
  const Config& config = input.packed->config;
  const Frame& frame = input.frame;
  const GoldenLists& lists = golden_lists(input);
  const auto x = static_cast<int64_t>(window.x - frame.raster.windows.first_x),
             y = static_cast<int64_t>(window.y - frame.raster.windows.first_y);
  GoldenLayer list;
  for (const uint32_t number : lists.windows[pu_expand_number(frame, x, y)]) {
    const GoldenLists::Entry& entry = lists.gaussians[number];
    const Tiles tiles = intersect(input, pu_expand(config, entry.conic, x, y), window);
    if (tiles.mask == 0) continue;
    list.splats.push_back({golden_splat(config, entry.colored, 0, tiles), row_job(tiles, entry.colored.index)});
  }
  if (!list.splats.empty()) window.layers.push_back(std::move(list));
}

void blend(const GoldenInput& input, GoldenWindow& window) {
  const Config& config = input.packed->config;
  const BlendConstants constants(config, input.frame.raster.rest);
  const PuRows rows(config);
  BlendCounts counts;
  RegionSet done;
  for (int r = 0; r < config.regions(); ++r) {
    window.regions.push_back(ru_fresh_region(config, input.frame, window.x, window.y, r));
    done.add(config, r, window.regions.back().all_done());
    if (config.has_aovs()) window.aovs.push_back(ru_fresh_region_aovs(config));
  }
  window.depth.assign(window.regions.size() * kRegionPixels, 0);
  window.blended.assign(window.regions.size() * kRegionPixels, 0);
  for (const GoldenLayer& layer : window.layers) {
    for (const GoldenSplat& splat : layer.splats) {
      const uint32_t color[3] = {static_cast<uint32_t>(splat.splat.red), static_cast<uint32_t>(splat.splat.green),
                                 static_cast<uint32_t>(splat.splat.blue)};
      const double depth = key_depth(*input.packed, splat.splat.depth) / constants.one;
      const uint32_t linear =
          config.has_depths() ? ru_linear(config, splat.splat.depth, input.frame.raster.aovs.range) : 0;
      for (uint64_t rest = splat.splat.mask & ~done.mask[splat.splat.part]; rest != 0; rest &= rest - 1) {
        const int bit = std::countr_zero(rest), r = region_number(config, splat.splat.part, bit);
        RegionState& region = window.regions[r];
        ++window.work.open_regions;
        alignas(64) uint16_t codes[kRegionPixels];
        pu_region_line(rows, splat.job, bit, codes);
        if (config.quads)
          window.work.quads += static_cast<uint64_t>(std::popcount(ru_live_quads(codes, ru_stopped_quads(region))));
        const RegionState before = region;
        if (ru_blend_region(constants, region, codes, color, &counts)) done.add(config, r);
        if (config.has_aovs())
          ru_add_region_aovs(config, constants, window.aovs[static_cast<size_t>(r)], before, region, codes, linear,
                             splat.splat.index);
        double* sum = &window.depth[static_cast<size_t>(r) * kRegionPixels];
        uint32_t* number = &window.blended[static_cast<size_t>(r) * kRegionPixels];
        for (int i = 0; i < kRegionPixels; ++i) {
          sum[i] += static_cast<double>(before.t[i] - region.t[i]) * depth;
          number[i] += codes[i] != 0 && region.done[i] == 0;
        }
      }
    }
  }
  window.work.blended = counts.blended;
  window.saturations.accumulated = counts.saturated;
  window.called.stopped = counts.stopped;
}

}  // namespace

Work& Work::operator+=(const Work& o) {
  fetched += o.fetched, visible += o.visible, records += o.records, regions += o.regions;
  open_regions += o.open_regions, quads += o.quads, alphas += o.alphas;
  blended += o.blended, keys += o.keys, chunks += o.chunks, layers += o.layers, windows += o.windows;
  return *this;
}

Saturations& Saturations::operator+=(const Saturations& o) {
  mean += o.mean, color += o.color, accumulated += o.accumulated, dead += o.dead;
  return *this;
}

Called& Called::operator+=(const Called& o) {
  near += o.near, guard += o.guard, stopped += o.stopped, ties += o.ties, layers = std::max(layers, o.layers),
                                                                          bucket = std::max(bucket, o.bucket);
  return *this;
}

GoldenConic golden_conic(const Config& config, const Frame& frame, const Visible& visible, ProjectCounts* counts) {
  const auto [projected, center, payload] = pu_project(config, frame, visible, counts);
  const Factors factors = pu_factors(config, frame, pu_jacobian(config, frame, pu_orient(config, frame, projected)));
  Covariance covariance = pu_covariance(config, frame, pu_squares(config, frame, factors), center);
  if (config.oriented()) covariance = pu_box(config, frame, pu_axes(config, frame, covariance));
  return {pu_conic(config, frame, config.antialias ? pu_compensate(config, frame, covariance) : covariance), payload};
}

Fetched golden_fetched(const Chunk& chunk, const GaussianRecord& g, uint64_t slot) {
  return {.kind = kData,
          .window_x = chunk.window_x,
          .window_y = chunk.window_y,
          .walk = chunk.walk,
          .origin_x = chunk.origin_x,
          .origin_y = chunk.origin_y,
          .origin_z = chunk.origin_z,
          .view_exp = chunk.view_exp,
          .offset_exp = chunk.offset_exp,
          .offset_x = g.offset_x,
          .offset_y = g.offset_y,
          .offset_z = g.offset_z,
          .qw = g.qw,
          .qx = g.qx,
          .qy = g.qy,
          .qz = g.qz,
          .scale_0 = g.scale_0,
          .scale_1 = g.scale_1,
          .scale_2 = g.scale_2,
          .opacity = g.opacity,
          .base_r = g.base_r,
          .base_g = g.base_g,
          .base_b = g.base_b,
          .index = g.index,
          .slot = slot};
}

const GoldenLists& golden_lists(const GoldenInput& input, unsigned threads) {
  static std::mutex making;
  const std::lock_guard lock(making);
  if (input.lists) return *input.lists;
  const PackedScene& packed = *input.packed;
  const Frame& frame = input.frame;
  std::vector<Chunk> chunks;
  dopu_window(packed.config, frame, packed, static_cast<int>(frame.raster.windows.first_x),
              static_cast<int>(frame.raster.windows.first_y),
              [&](int, const Chunk& chunk, uint64_t) { chunks.push_back(chunk); });
  // A part of the chunks for each item; the parts are joined in order, so the result does not depend on the threads.
  constexpr size_t kChunksOfPart = 64;
  std::vector<GoldenLists> parts((chunks.size() + kChunksOfPart - 1) / kChunksOfPart);
  parallel_for(parts.size(), threads, [&](size_t i) {
    GoldenLists& part = parts[i];
    for (size_t k = i * kChunksOfPart; k < std::min(chunks.size(), (i + 1) * kChunksOfPart); ++k) {
      ++part.work.chunks;
      for (uint64_t slot = chunks[k].slot; slot < chunks[k].slot + chunks[k].count; ++slot) {
        ++part.work.fetched;
        const std::optional<GoldenConic> found = project(input, golden_fetched(chunks[k], packed.gaussians[slot], slot),
                                                         0, part.work, part.saturations, part.called);
        if (!found || !pu_expand_box(packed.config, frame, found->conic)) continue;
        part.gaussians.push_back({found->conic, color(input, pu_expand_job(found->payload), part.saturations)});
      }
    }
  });
  auto lists = std::make_shared<GoldenLists>();
  lists->windows.resize((frame.raster.windows.last_x - frame.raster.windows.first_x + 1) *
                        (frame.raster.windows.last_y - frame.raster.windows.first_y + 1));
  for (const GoldenLists& part : parts) {
    lists->work += part.work;
    lists->saturations += part.saturations;
    lists->called += part.called;
    for (const GoldenLists::Entry& entry : part.gaussians) {
      const PuExpandBox box = *pu_expand_box(packed.config, frame, entry.conic);
      for (int64_t y = box.first_y; y <= box.last_y; ++y) {
        for (int64_t x = box.first_x; x <= box.last_x; ++x) {
          if (!pu_expand_keeps(packed.config, entry.conic, box, x, y)) continue;
          lists->windows[pu_expand_number(frame, x, y)].push_back(static_cast<uint32_t>(lists->gaussians.size()));
        }
      }
      lists->gaussians.push_back(entry);
    }
  }
  input.lists = lists;
  return *lists;
}

GoldenWindow golden_window(const GoldenInput& input, uint64_t window_x, uint64_t window_y) {
  const PackedScene& packed = *input.packed;
  GoldenWindow window;
  window.x = window_x;
  window.y = window_y;
  const bool layers = packed.config.has_layers();
  // The layer of a chunk, or its bucket of depth: sorted as a whole then.
  const auto chunk_of = [&](int ordinal, const Chunk& chunk, uint64_t) {
    if (!layers) ordinal = 0;
    if (window.layers.empty() || window.layers.back().ordinal != ordinal) window.layers.push_back({ordinal, {}});
    ++window.work.chunks;
    const std::vector<int> eyes = walk_eyes(packed.config, input.frame, chunk.walk);
    for (uint64_t slot = chunk.slot; slot < chunk.slot + chunk.count; ++slot) {
      const Fetched fetched = golden_fetched(chunk, packed.gaussians[slot], slot);
      ++window.work.fetched;
      for (const int eye : eyes) preprocess(input, fetched, eye, window, window.layers.back());
    }
  };
  const int x = static_cast<int>(window_x), y = static_cast<int>(window_y);
  if (packed.config.has_lists()) read_list(input, window);
  else if (!packed.config.has_watermarks()) dopu_window(packed.config, input.frame, packed, x, y, chunk_of);
  else window.walks = dopu_walks(packed.config, input.frame, packed, x, y);
  for (const uint64_t walk : window.walks) dopu_nearest(packed.config, input.frame, packed, x, y, walk, chunk_of);
  std::array<size_t, kParts> turns = {};  // of a part: its walk
  for (size_t part = 0; part < turns.size() && window.in_parts(); ++part) {
    while (turns[part] + 1 < window.walks.size() && !walk_has(packed.config, window.walks[turns[part]], part))
      ++turns[part];
  }
  const auto turn = [&](const GoldenSplat& one) { return turns[one.splat.part]; };
  const int octave = su_octave(packed.config, input.frame);
  for (GoldenLayer& layer : window.layers) {
    std::sort(layer.splats.begin(), layer.splats.end(), [&](const GoldenSplat& a, const GoldenSplat& b) {
      return turn(a) != turn(b) ? turn(a) < turn(b) : splat_before(a.splat, b.splat);
    });
    window.called.layers += !layer.splats.empty();
    uint64_t bucket = 0;  // keys of the bucket so far
    for (size_t i = 0; i < layer.splats.size(); ++i) {
      const uint64_t depth = layer.splats[i].splat.depth, before = i > 0 ? layer.splats[i - 1].splat.depth : ~depth;
      window.called.ties += depth == before && layer.splats[i].splat.index != layer.splats[i - 1].splat.index;
      const auto bucket_of = [&](uint64_t key) { return su_bucket(packed.config, key, octave); };
      bucket = i > 0 && bucket_of(depth) == bucket_of(before) ? bucket + 1 : 1;
      window.called.bucket = std::max(window.called.bucket, bucket);
    }
  }
  window.work.keys = window.work.records;
  window.work.alphas = window.work.regions * kRegionPixels;
  window.work.layers = window.layers.size();
  window.work.windows = 1;
  blend(input, window);
  return window;
}

void golden_codes(const Config& config, const RowJob& job, int bit, uint16_t codes[kRegionPixels]) {
  pu_region_line(PuRows(config), job, bit, codes);
}

}  // namespace pipegs
