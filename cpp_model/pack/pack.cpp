// SPDX-License-Identifier: Apache-2.0
// pack: see pack.hpp.
#include "cpp_model/pack/pack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "cpp_model/dopu/nearest/dopu_lod.hpp"
#include "cpp_model/fixed.hpp"
#include "cpp_model/float/parallel.hpp"
#include "cpp_model/pack/pack_cells.hpp"
#include "cpp_model/pack/pack_nodes.hpp"
#include "cpp_model/pack/pack_order.hpp"
#include "cpp_model/pack/pack_proxies.hpp"
#include "cpp_model/pack/pack_quantize.hpp"
#include "cpp_model/pu/color/pu_color_fetch.hpp"
#include "cpp_model/pu/front/pu_decode.hpp"
#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

constexpr double kOutlier = 1024;  // a mean this many scene radii away is left out: it would eat everybody's bits
constexpr double kWindowAngle =
    0.2;  // side of a window as the packing order sees it, of the scene's radius; docs/units/dopu.md
constexpr double kProxyGrowth = 1.01;  // of the windows that open a group, for its proxies; docs/units/dopu.md
constexpr size_t kBlock = 16384;       // Gaussians of one piece of parallel work
constexpr size_t kChunkBlock = 1024;   // chunks of one
constexpr size_t kLargeCell = 65536;   // Gaussians of a cell that several threads share

void add(PackCounts& sum, const PackCounts& part) {
  sum.non_finite += part.non_finite;
  sum.zero_quaternion += part.zero_quaternion;
  sum.transparent += part.transparent;
  sum.saturated_scale += part.saturated_scale;
  sum.saturated_base += part.saturated_base;
  sum.saturated_sh += part.saturated_sh;
  sum.flushed_scale += part.flushed_scale;
}

// Runs work(begin, end, counts) over blocks of [0, items) and sums the counts; `size` items in a block.
template <class Work>
void for_blocks(size_t items, size_t size, PackCounts& counts, Work&& work) {
  std::mutex mutex;
  parallel_for((items + size - 1) / size, 0, [&](size_t block) {
    PackCounts mine;
    work(block * size, std::min(items, (block + 1) * size), mine);
    const std::lock_guard lock(mutex);
    add(counts, mine);
  });
}

// Can a Gaussian be drawn? Counts why not.
bool survives(const Config& config, const Scene& scene, size_t index, PackCounts& counts) {
  ActivatedGaussian gaussian;
  const Cull cull = activate(scene, index, gaussian);
  const bool transparent = cull == Cull::kNone && !(gaussian.opacity >= 1.0 / config.alpha_cut);
  counts.non_finite += cull == Cull::kNonFinite;
  counts.zero_quaternion += cull == Cull::kZeroQuaternion;
  counts.transparent += transparent;
  return cull == Cull::kNone && !transparent;
}

// The Gaussians that can be drawn, by rising index.
std::vector<uint32_t> survivors(const Config& config, const Scene& scene, PackCounts& counts) {
  std::vector<char> drawn(scene.gaussians.size());
  for_blocks(drawn.size(), kBlock, counts, [&](size_t begin, size_t end, PackCounts& mine) {
    for (size_t i = begin; i < end; ++i) drawn[i] = survives(config, scene, i, mine);
  });
  std::vector<uint32_t> kept;
  kept.reserve(drawn.size());
  for (size_t i = 0; i < drawn.size(); ++i) {
    if (drawn[i]) kept.push_back(static_cast<uint32_t>(i));
  }
  return kept;
}

SceneBox robust_box(const Scene& scene, const std::vector<uint32_t>& kept) {
  SceneBox box;
  if (kept.empty()) return box;
  parallel_for(3, 0, [&](size_t a) {
    const int axis = static_cast<int>(a);
    std::vector<float> values;
    values.reserve(kept.size());
    for (const uint32_t index : kept) values.push_back(scene.gaussians[index].mean[axis]);
    const auto percentile = [&](double at) {
      const auto middle = values.begin() + static_cast<std::ptrdiff_t>(at * static_cast<double>(kept.size() - 1));
      std::nth_element(values.begin(), middle, values.end());
      return static_cast<double>(*middle);
    };
    box.low[axis] = percentile(0.02);
    box.high[axis] = percentile(0.98);
  });
  return box;
}

// Side of a window where it looks into the box, scene units.
double window_side(const SceneBox& box) {
  double diagonal = 0;
  for (int axis = 0; axis < 3; ++axis) diagonal += (box.high[axis] - box.low[axis]) * (box.high[axis] - box.low[axis]);
  return kWindowAngle * std::sqrt(diagonal) / 2;
}

// What a slot holds: a Gaussian of the scene, or of the proxies behind them.
struct Source {
  const Scene& scene;
  const Proxies& proxies;

  struct Of {
    const Scene& scene;
    uint32_t index;   // there
    uint32_t number;  // of the scene's Gaussian that it is, or that weighs most in it
  };
  Of at(uint32_t index) const {
    const auto proxy = static_cast<int64_t>(index) - static_cast<int64_t>(scene.gaussians.size());
    if (proxy < 0) return {scene, index, index};
    return {proxies.scene, static_cast<uint32_t>(proxy), proxies.heaviest[static_cast<size_t>(proxy)]};
  }
};

WorldPoint world_point(const Scene& scene, uint32_t index, int scene_exponent) {
  WorldPoint point;
  for (int axis = 0; axis < 3; ++axis) {
    const double mean = scene.gaussians[index].mean[axis];
    point[static_cast<size_t>(axis)] = std::llround(std::ldexp(mean, -scene_exponent));
  }
  return point;
}

size_t cell_of(const PackedScene& packed, const WorldPoint& point) {
  int cell = 0;
  for (int axis = 2; axis >= 0; --axis) {
    const int64_t world = point[static_cast<size_t>(axis)];
    cell = cell * packed.config.grid + cell_coordinate(packed.config, packed.grid, axis, world);
  }
  return static_cast<size_t>(cell);
}

OrderItem order_item(const PackedScene& packed, const Scene& scene, uint32_t index) {
  ActivatedGaussian gaussian;
  activate(scene, index, gaussian);
  PackCounts counted_later;
  const GaussianRecord record = quantize_reach(packed.config, gaussian, packed.scene_exponent, counted_later);
  OrderItem item;
  for (int axis = 0; axis < 3; ++axis) item.value[axis] = scene.gaussians[index].mean[axis];
  item.value[3] = static_cast<float>(std::ldexp(effective_scale(packed.config, record), packed.scene_exponent));
  if (packed.config.tight_boxes) {
    const std::array<double, 3> extents = ellipsoid_extents(packed.config, record);
    for (size_t axis = 0; axis < 3; ++axis)
      item.extent[axis] = static_cast<float>(std::ldexp(extents[axis], packed.scene_exponent));
  }
  item.index = index;
  return item;
}

// What is ordered, cell by cell.
struct CellItems {
  std::vector<OrderItem> items;
  std::vector<size_t> first;  // by cell, and one more at the end
  std::span<OrderItem> cell(size_t n) { return std::span(items).subspan(first[n], first[n + 1] - first[n]); }
};

// A counting sort by cell: by rising index within each.
CellItems cell_items(const Scene& scene, const std::vector<uint32_t>& kept, const PackedScene& packed) {
  const size_t cells = static_cast<size_t>(packed.config.grid * packed.config.grid * packed.config.grid),
               blocks = (kept.size() + kBlock - 1) / kBlock;
  std::vector<size_t> place(blocks * cells);  // of a block's next Gaussian in a cell; first how many there are
  const auto in_block = [&](size_t block, auto&& work) {
    for (size_t i = block * kBlock; i < std::min(kept.size(), (block + 1) * kBlock); ++i) {
      work(kept[i], place[block * cells + cell_of(packed, world_point(scene, kept[i], packed.scene_exponent))]);
    }
  };
  parallel_for(blocks, 0, [&](size_t block) { in_block(block, [](uint32_t, size_t& number) { ++number; }); });
  CellItems result;
  size_t sum = 0;
  for (size_t cell = 0; cell < cells; ++cell) {
    result.first.push_back(sum);
    for (size_t block = 0; block < blocks; ++block) sum += std::exchange(place[block * cells + cell], sum);
  }
  result.first.push_back(sum);
  result.items.resize(sum);
  parallel_for(blocks, 0, [&](size_t block) {
    in_block(block, [&](uint32_t index, size_t& at) { result.items[at++] = order_item(packed, scene, index); });
  });
  return result;
}

// Brings the Gaussians of each cell into the order of its chunks: the largest cells first, so that no thread is left
// with one at the end.
void order_cells(const Config& config, float window, CellItems& cells) {
  // sqrt(2 ln 255) = 3.33 standard deviations at AlphaCut 255, a little more off the image's centre.
  const float reach =
      static_cast<float>((config.tight_boxes ? 1.2 : 4) * std::sqrt(std::log(config.alpha_cut) / std::log(255)));
  const size_t chunk = static_cast<size_t>(config.chunk), group = chunk * static_cast<size_t>(config.group);
  std::vector<std::span<OrderItem>> all;
  for (size_t cell = 0; cell + 1 < cells.first.size(); ++cell) all.push_back(cells.cell(cell));
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  parallel_for(all.size(), 0,
               [&](size_t i) { pack_order(all[i], chunk, group, window, reach, all[i].size() > kLargeCell ? 0 : 1); });
}

// Cuts the cells into chunks: of these only where they begin and how many they hold. Slots are given to Gaussians, and
// behind those of a group to its proxies, whose number is the result.
size_t cut_chunks(CellItems& cells, PackedScene& packed) {
  const Config& config = packed.config;
  const size_t chunk = static_cast<size_t>(config.chunk), group = chunk * static_cast<size_t>(config.group),
               most = (cells.items.size() / chunk + cells.first.size()) * (config.lod ? 5 : 4) / 4,
               aligned = static_cast<size_t>(std::max(2, config.gaussians_per_line()));  // a chunk begins a line
  packed.chunks.reserve(most);
  packed.slot_to_index.reserve((cells.items.size() + most * (aligned - 1)) * (config.lod ? 5 : 4) / 4);
  const auto cut = [&](size_t count, auto&& index) {  // a chunk of so many: index(0), index(1) ...
    packed.chunks.push_back({.first = packed.slot_to_index.size(), .count = count});
    for (size_t i = 0; i < count; ++i) packed.slot_to_index.push_back(index(i));
    while (packed.slot_to_index.size() % aligned != 0) packed.slot_to_index.push_back(kPadding);
  };
  size_t proxies = 0;  // cut so far
  for (size_t n = 0; n + 1 < cells.first.size(); ++n) {
    const std::span<const OrderItem> items = cells.cell(n);
    Node cell{.first = packed.groups.size()};
    for (size_t begin = 0; begin < items.size(); begin += group) {
      const std::span<const OrderItem> own = items.subspan(begin, std::min(group, items.size() - begin));
      Node& node = packed.groups.emplace_back(Node{.first = packed.chunks.size()});
      size_t few = 0;  // its proxies
      for (size_t at = 0; at < own.size(); at += chunk, ++node.count) {
        const size_t count = std::min(chunk, own.size() - at);
        cut(count, [&](size_t i) { return own[at + i].index; });
        few += chunk_proxies(count);
      }
      if (!config.lod) continue;
      for (const size_t end = proxies + few; proxies < end;) {
        const size_t count = std::min(chunk, end - proxies);
        cut(count, [&](size_t i) { return static_cast<uint32_t>(packed.scene_gaussians + proxies + i); });
        proxies += count;
      }
    }
    cell.count = packed.groups.size() - cell.first;
    packed.cells.push_back(cell.count == 0 ? Node{} : cell);
  }
  return proxies;
}

// The proxies of all groups, and when they will do.
void fill_proxies(const Scene& scene, PackedScene& packed, Proxies& proxies) {
  parallel_for(packed.groups.size(), 0, [&](size_t g) {
    Node& group = packed.groups[g];
    std::vector<std::vector<uint32_t>> chunks;
    for (uint64_t i = group.first; i < group.first + group.count; ++i) {
      const auto first = packed.slot_to_index.begin() + static_cast<std::ptrdiff_t>(packed.chunks[i].first);
      chunks.emplace_back(first, first + static_cast<std::ptrdiff_t>(packed.chunks[i].count));
    }
    const size_t first = packed.slot_to_index[packed.chunks[group.first + group.count].first];
    group.error =
        make_proxies(packed.config, scene, chunks, packed.scene_exponent, first - packed.scene_gaussians, proxies);
  });
}

// One chunk's node and its records.
void fill_chunk(const Source& source, PackedScene& packed, Node& chunk, PackCounts& counts) {
  const Config& config = packed.config;
  const size_t first = chunk.first;
  std::vector<WorldPoint> means(chunk.count);
  std::vector<ActivatedGaussian> gaussians(chunk.count);
  std::vector<GaussianRecord> records(chunk.count);
  const auto of = [&](size_t i) { return source.at(packed.slot_to_index[first + i]); };
  for (size_t i = 0; i < means.size(); ++i) {
    activate(of(i).scene, of(i).index, gaussians[i]);
    means[i] = world_point(of(i).scene, of(i).index, packed.scene_exponent);
  }
  std::vector<GaussianCode> codes(config.coded() ? chunk.count : 0);
  const uint64_t scale_exp = config.coded() ? chunk_scale_exp(config, gaussians, packed.scene_exponent) : 0;
  for (size_t i = 0; i < means.size(); ++i) {
    if (config.coded()) {
      codes[i] = encode(config, of(i).scene, gaussians[i], of(i).index, packed.scene_exponent, scale_exp, counts);
      records[i] = pu_decode(config, codes[i], scale_exp, first + i);
    } else {
      records[i] = quantize(config, of(i).scene, gaussians[i], of(i).index, packed.scene_exponent, counts);
      records[i].index = of(i).number;
    }
  }
  chunk = make_chunk(config, means, records, scale_exp);
  chunk.first = first;
  for (size_t i = 0; i < records.size(); ++i) packed.gaussians.set(first + i, records[i]);
  for (size_t i = 0; i < codes.size(); ++i) {
    set_offsets(config, records[i], codes[i]);
    packed.codes.set(first + i, codes[i]);
  }
}

// Gives slots and chunks to the Gaussians that are kept; frees what only the order needs. The number of proxies.
size_t order_and_cut(const Scene& scene, std::vector<uint32_t> kept, double window, PackedScene& packed) {
  CellItems cells = cell_items(scene, kept, packed);
  kept = {};
  order_cells(packed.config, static_cast<float>(window), cells);
  return cut_chunks(cells, packed);
}

// The node above the first `count` of its children, and what it knows already.
Node parent_of(const Config& config, const Node& node, const std::vector<Node>& children, uint64_t count) {
  const auto first = children.begin() + static_cast<std::ptrdiff_t>(node.first);
  Node parent = make_parent(config, std::span(first, count));
  parent.first = node.first, parent.count = node.count, parent.error = node.error;
  return parent;
}

// All that may be drawn for a group is in its box. If proxies widen it so that many more windows (world units) open it,
// they are not used.
Node group_of(const Config& config, const Node& group, const std::vector<Node>& chunks, double window) {
  Node own = parent_of(config, group, chunks, group.count);
  if (!config.lod || group.error == dopu_lod_never(config)) return own;
  const Node both = parent_of(config, group, chunks, group.count + dopu_lod_chunks(config, group.count));
  if (hull_area(config, both, window) <= kProxyGrowth * hull_area(config, own, window)) return both;
  own.error = dopu_lod_never(config);
  return own;
}

void fill_nodes(const Source& source, double window, PackedScene& packed) {
  const Config& config = packed.config;
  packed.gaussians.resize(packed.slot_to_index.size());
  if (config.coded()) packed.codes.resize(packed.slot_to_index.size());
  for_blocks(packed.chunks.size(), kChunkBlock, packed.counts, [&](size_t begin, size_t end, PackCounts& counts) {
    for (size_t i = begin; i < end; ++i) fill_chunk(source, packed, packed.chunks[i], counts);
  });
  const double side = std::ldexp(window, -packed.scene_exponent);
  for (Node& group : packed.groups) group = group_of(config, group, packed.chunks, side);
  if (config.has_watermarks())
    packed.cells = cell_table(packed.cells, packed.groups, static_cast<size_t>(config.table_cells()));
  for (Node& cell : packed.cells) {
    if (cell.count != 0) cell = parent_of(config, cell, packed.groups, cell.count);
  }
}

void pack_colors(const Source& source, PackedScene& packed) {
  if (packed.sh_degree == 0) return;
  const size_t per_line = static_cast<size_t>(color_slots_per_line(packed.config, packed.sh_degree)),
               slots = packed.slot_to_index.size();
  packed.colors.assign((slots + per_line - 1) / per_line, MemoryLine{});
  for_blocks(slots, kBlock, packed.counts, [&](size_t begin, size_t end, PackCounts& counts) {
    for (size_t slot = begin; slot < end; ++slot) {
      if (packed.slot_to_index[slot] == kPadding) continue;
      const Source::Of of = source.at(packed.slot_to_index[slot]);
      quantize_colors(packed.config, of.scene, packed.sh_degree, of.index, packed.colors[slot / per_line].data(),
                      color_place(packed.config, packed.sh_degree, slot), counts);
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
  // The index of a code is its slot.
  if (config.coded() && packed.gaussians.size() > uint64_t{1} << config.index_w) {
    throw InputError(fmt::format("scene '{}': {} slots, at most {} fit the {}-bit index", scene.name,
                                 packed.gaussians.size(), uint64_t{1} << config.index_w, config.index_w));
  }
  for (const Node& cell : packed.cells) {
    if (cell.count >> config.children_w() != 0) {
      throw InputError(fmt::format("scene '{}': {} groups in one cell, fewer than {} fit", scene.name, cell.count,
                                   uint64_t{1} << config.children_w()));
    }
  }
}

}  // namespace

std::vector<Node> PackedScene::own_chunks() const {
  std::vector<Node> own;
  for (const Node& group : groups) {
    const auto first = chunks.begin() + static_cast<std::ptrdiff_t>(group.first);
    own.insert(own.end(), first, first + static_cast<std::ptrdiff_t>(group.count));
  }
  return own;
}

PackedScene pack_scene(const Config& config, const Scene& scene, double coordinate_bound) {
  PackedScene packed;
  packed.config = config;
  packed.antialiased = scene.antialiased;
  packed.sh_degree = std::min(scene.sh_degree, config.sh_degree);
  packed.scene_gaussians = scene.gaussians.size();
  check_sizes(config, scene, packed);
  if (!std::isfinite(coordinate_bound))
    throw std::invalid_argument("pack_scene: the cameras' coordinates are not finite");

  std::vector<uint32_t> kept = survivors(config, scene, packed.counts);
  const SceneBox box = robust_box(scene, kept);
  double radius = std::max(std::abs(coordinate_bound), 1e-6);
  for (int axis = 0; axis < 3; ++axis) radius = std::max({radius, std::abs(box.low[axis]), std::abs(box.high[axis])});
  double bound = radius;
  packed.counts.out_of_range = std::erase_if(kept, [&](uint32_t index) {
    const glm::dvec3 size = glm::abs(glm::dvec3(scene.gaussians[index].mean));
    const double widest = std::max({size.x, size.y, size.z});
    if (widest > kOutlier * radius) return true;
    bound = std::max(bound, widest);
    return false;
  });
  packed.counts.packed = kept.size();
  // |coordinate| <= 2^(WorldW - 3) world units: WorldW - 2 signed bits, and one more value.
  int exponent;
  std::frexp(bound, &exponent);
  packed.scene_exponent = exponent - (config.world_w - 3);
  packed.grid = make_grid(config, box, packed.scene_exponent);
  const double window = window_side(box);
  Proxies proxies;
  const Source source{scene, proxies};
  packed.counts.proxies = order_and_cut(scene, std::move(kept), window, packed);
  if (config.lod) {
    proxies.resize(scene, packed.counts.proxies);
    fill_proxies(scene, packed, proxies);
  }
  fill_nodes(source, window, packed);
  check_sizes(config, scene, packed);
  pack_colors(source, packed);
  for (uint32_t& index : packed.slot_to_index) {
    if (index != kPadding) index = source.at(index).number;
  }
  packed.layout = make_layout(packed);
  return packed;
}

}  // namespace pipegs
