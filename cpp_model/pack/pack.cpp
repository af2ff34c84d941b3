// SPDX-License-Identifier: Apache-2.0
// pack: see pack.hpp.
#include "cpp_model/pack/pack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>

#include "cpp_model/fixed.hpp"
#include "cpp_model/float/parallel.hpp"
#include "cpp_model/pack/pack_nodes.hpp"
#include "cpp_model/pack/pack_order.hpp"
#include "cpp_model/pack/pack_quantize.hpp"
#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

constexpr double kOutlier = 1024;  // a mean this many scene radii away is left out: it would eat everybody's bits
constexpr double kWindowAngle =
    0.2;  // side of a window as the packing order sees it, of the scene's radius; docs/units/dopu.md
constexpr size_t kBlock = 16384;  // Gaussians of one piece of parallel work

struct Survivor {
  ActivatedGaussian gaussian;
  uint32_t index;
};

void add(PackCounts& sum, const PackCounts& part) {
  sum.saturated_scale += part.saturated_scale;
  sum.saturated_base += part.saturated_base;
  sum.saturated_sh += part.saturated_sh;
  sum.flushed_scale += part.flushed_scale;
}

// Runs work(begin, end, counts) over blocks of [0, items) and sums the counts.
template <class Work>
void for_blocks(size_t items, PackCounts& counts, Work&& work) {
  std::mutex mutex;
  parallel_for((items + kBlock - 1) / kBlock, 0, [&](size_t block) {
    PackCounts mine;
    work(block * kBlock, std::min(items, (block + 1) * kBlock), mine);
    const std::lock_guard lock(mutex);
    add(counts, mine);
  });
}

std::vector<Survivor> survivors(const Config& config, const Scene& scene, PackCounts& counts) {
  const size_t n = scene.gaussians.size();
  std::vector<ActivatedGaussian> activated(n);
  std::vector<Cull> cull(n);
  for_blocks(n, counts, [&](size_t begin, size_t end, PackCounts&) {
    for (size_t i = begin; i < end; ++i) cull[i] = activate(scene, i, activated[i]);
  });
  std::vector<Survivor> kept;
  kept.reserve(n);
  for (size_t i = 0; i < n; ++i) {
    if (cull[i] == Cull::kNonFinite) ++counts.non_finite;
    else if (cull[i] == Cull::kZeroQuaternion) ++counts.zero_quaternion;
    else if (!(activated[i].opacity >= 1.0 / config.alpha_cut)) ++counts.transparent;
    else kept.push_back({activated[i], static_cast<uint32_t>(i)});
  }
  return kept;
}

double percentile(const std::vector<Survivor>& all, int axis, double at) {
  std::vector<double> values(all.size());
  for (size_t i = 0; i < all.size(); ++i) values[i] = all[i].gaussian.mean[axis];
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(at * static_cast<double>(all.size() - 1));
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

SceneBox robust_box(const std::vector<Survivor>& all) {
  SceneBox box;
  if (all.empty()) return box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = percentile(all, axis, 0.02);
    box.high[axis] = percentile(all, axis, 0.98);
  }
  return box;
}

// One cell's chunks and slots, before they get their place in the tables.
struct CellPart {
  std::vector<OrderItem> items;
  std::vector<Node> chunks;
  std::vector<GaussianRecord> gaussians;
  std::vector<uint32_t> slots;  // survivor of each slot, or kPadding
};

void build_cell(const Config& config, const std::vector<WorldPoint>& world, const std::vector<GaussianRecord>& records,
                float window, CellPart& cell) {
  const size_t chunk = static_cast<size_t>(config.chunk);
  // sqrt(2 ln 255) = 3.33 standard deviations at AlphaCut 255, a little more off the image's centre.
  const double reach = 4 * std::sqrt(std::log(config.alpha_cut) / std::log(255));
  pack_order(cell.items, chunk, chunk * static_cast<size_t>(config.group), window, static_cast<float>(reach));
  std::vector<WorldPoint> means;
  for (size_t begin = 0; begin < cell.items.size(); begin += chunk) {
    const size_t count = std::min(chunk, cell.items.size() - begin), slot = cell.slots.size();
    means.clear();
    for (size_t i = begin; i < begin + count; ++i) {
      cell.slots.push_back(cell.items[i].index);
      means.push_back(world[cell.items[i].index]);
      cell.gaussians.push_back(records[cell.items[i].index]);
    }
    cell.chunks.push_back(make_chunk(config, means, std::span(cell.gaussians).subspan(slot)));
    cell.chunks.back().first = slot;
    if (cell.slots.size() % 2 != 0) {  // chunks start at even slots
      cell.slots.push_back(kPadding);
      cell.gaussians.push_back({});
    }
  }
}

// Appends the cells' groups, chunks and Gaussians to the tables, in the order of the cells.
void join_cells(const std::vector<Survivor>& all, std::vector<CellPart>& parts, PackedScene& packed) {
  const size_t group = static_cast<size_t>(packed.config.group);
  for (CellPart& part : parts) {
    const uint64_t first_group = packed.groups.size(), first_chunk = packed.chunks.size(),
                   first_slot = packed.gaussians.size();
    for (size_t i = 0; i < part.chunks.size(); i += group) {
      const auto chunks = std::span<const Node>(part.chunks).subspan(i, std::min(group, part.chunks.size() - i));
      packed.groups.push_back(make_parent(packed.config, chunks, first_chunk + i));
    }
    const auto groups = std::span<const Node>(packed.groups).subspan(first_group);
    packed.cells.push_back(groups.empty() ? Node{} : make_parent(packed.config, groups, first_group));
    for (Node& chunk : part.chunks) {
      chunk.first += first_slot;
      packed.chunks.push_back(chunk);
    }
    packed.gaussians.insert(packed.gaussians.end(), part.gaussians.begin(), part.gaussians.end());
    for (const uint32_t survivor : part.slots) {
      packed.slot_to_index.push_back(survivor == kPadding ? kPadding : all[survivor].index);
    }
    part = {};
  }
}

void pack_colors(const Scene& scene, PackedScene& packed) {
  if (packed.sh_degree == 0) return;
  const size_t per_line = static_cast<size_t>(color_slots_per_line(packed.sh_degree)),
               slots = packed.slot_to_index.size();
  packed.colors.assign((slots + per_line - 1) / per_line, MemoryLine{});
  for_blocks(slots, packed.counts, [&](size_t begin, size_t end, PackCounts& counts) {
    for (size_t slot = begin; slot < end; ++slot) {
      if (packed.slot_to_index[slot] == kPadding) continue;
      quantize_colors(packed.config, scene, packed.sh_degree, packed.slot_to_index[slot],
                      packed.colors[slot / per_line].data(), static_cast<int>(slot % per_line) * 128, counts);
    }
  });
}

MemoryLayout make_layout(const PackedScene& packed) {
  const auto lines = [](size_t items, int per_line) {
    return (items + static_cast<size_t>(per_line) - 1) / static_cast<size_t>(per_line);
  };
  MemoryLayout layout;
  layout.groups = layout.cells + lines(packed.cells.size(), 2);
  layout.chunks = layout.groups + lines(packed.groups.size(), 2);
  layout.gaussians = layout.chunks + lines(packed.chunks.size(), 2);
  layout.colors = layout.gaussians + lines(packed.gaussians.size(), packed.config.gaussians_per_line());
  layout.pixels = layout.colors + packed.colors.size();
  return layout;
}

void check_sizes(const Config& config, const Scene& scene, const PackedScene& packed) {
  if (scene.gaussians.size() > uint64_t{1} << config.index_w) {
    throw InputError(fmt::format("scene '{}': {} Gaussians, at most {} fit the {}-bit index", scene.name,
                                 scene.gaussians.size(), uint64_t{1} << config.index_w, config.index_w));
  }
  if (packed.gaussians.size() >= uint64_t{1} << config.slot_w()) {
    throw InputError(fmt::format("scene '{}': {} slots, fewer than {} fit", scene.name, packed.gaussians.size(),
                                 uint64_t{1} << config.slot_w()));
  }
  for (const Node& cell : packed.cells) {
    if (cell.count >> config.count_w() != 0) {
      throw InputError(fmt::format("scene '{}': {} groups in one cell, fewer than {} fit", scene.name, cell.count,
                                   uint64_t{1} << config.count_w()));
    }
  }
}

}  // namespace

PackedScene pack_scene(const Config& config, const Scene& scene, double coordinate_bound) {
  PackedScene packed;
  packed.config = config;
  packed.antialiased = scene.antialiased;
  packed.sh_degree = std::min(scene.sh_degree, config.sh_degree);
  packed.scene_gaussians = scene.gaussians.size();
  check_sizes(config, scene, packed);
  if (!std::isfinite(coordinate_bound))
    throw std::invalid_argument("pack_scene: the cameras' coordinates are not finite");

  std::vector<Survivor> all = survivors(config, scene, packed.counts);
  const SceneBox box = robust_box(all);
  double radius = std::max(std::abs(coordinate_bound), 1e-6);
  for (int axis = 0; axis < 3; ++axis) radius = std::max({radius, std::abs(box.low[axis]), std::abs(box.high[axis])});
  double bound = radius;
  packed.counts.out_of_range = std::erase_if(all, [&](const Survivor& survivor) {
    const glm::dvec3 size = glm::abs(survivor.gaussian.mean);
    const double widest = std::max({size.x, size.y, size.z});
    if (widest > kOutlier * radius) return true;
    bound = std::max(bound, widest);
    return false;
  });
  packed.counts.packed = all.size();
  // |coordinate| <= 2^(WorldW - 3) world units: WorldW - 2 signed bits, and one more value.
  int exponent;
  std::frexp(bound, &exponent);
  packed.scene_exponent = exponent - (config.world_w - 3);
  packed.grid = make_grid(config, box, packed.scene_exponent);

  std::vector<WorldPoint> world(all.size());
  std::vector<GaussianRecord> records(all.size());
  std::vector<uint16_t> cell_of(all.size());
  for_blocks(all.size(), packed.counts, [&](size_t begin, size_t end, PackCounts& counts) {
    for (size_t i = begin; i < end; ++i) {
      int cell = 0;
      for (int axis = 2; axis >= 0; --axis) {
        const double position = std::ldexp(all[i].gaussian.mean[axis], -packed.scene_exponent);
        world[i][static_cast<size_t>(axis)] = std::llround(position);
        cell = cell * config.grid + cell_coordinate(config, packed.grid, axis, world[i][static_cast<size_t>(axis)]);
      }
      cell_of[i] = static_cast<uint16_t>(cell);
      records[i] = quantize(config, scene, all[i].gaussian, all[i].index, packed.scene_exponent, counts);
    }
  });

  std::vector<CellPart> parts(static_cast<size_t>(config.grid * config.grid * config.grid));
  for (size_t i = 0; i < all.size(); ++i) {
    OrderItem item;
    for (int axis = 0; axis < 3; ++axis) item.value[axis] = static_cast<float>(all[i].gaussian.mean[axis]);
    item.value[3] = static_cast<float>(std::ldexp(effective_scale(config, records[i]), packed.scene_exponent));
    item.index = static_cast<uint32_t>(i);
    parts[cell_of[i]].items.push_back(item);
  }
  double diagonal = 0;
  for (int axis = 0; axis < 3; ++axis) diagonal += (box.high[axis] - box.low[axis]) * (box.high[axis] - box.low[axis]);
  const float window = static_cast<float>(kWindowAngle * std::sqrt(diagonal) / 2);
  parallel_for(parts.size(), 0, [&](size_t cell) { build_cell(config, world, records, window, parts[cell]); });
  join_cells(all, parts, packed);
  check_sizes(config, scene, packed);
  pack_colors(scene, packed);
  packed.layout = make_layout(packed);
  return packed;
}

}  // namespace pipegs
