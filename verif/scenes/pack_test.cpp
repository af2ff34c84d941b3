// SPDX-License-Identifier: Apache-2.0
// pack_test: cpp_model/pack/pack.cpp, pack_nodes, pack_order, pack_quantize and pack_image against the scene they came
// from.
#include "cpp_model/dopu/nearest/dopu_lod.hpp"
#include "cpp_model/pack/pack.hpp"
#include "cpp_model/pu/front/pu_decode.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <span>

#include "cpp_model/pack/pack_nodes.hpp"
#include "cpp_model/pack/pack_order.hpp"
#include "cpp_model/pack/pack_quantize.hpp"
#include "scenes/input_error.hpp"
#include "verif/dopu/dopu_world.hpp"

namespace pipegs {
namespace {

int64_t world_mean(const Node& chunk, const GaussianRecord& g, int axis) {
  const int64_t center = axis == 0 ? chunk.center_x : axis == 1 ? chunk.center_y : chunk.center_z;
  const int64_t offset = axis == 0 ? g.offset_x : axis == 1 ? g.offset_y : g.offset_z;
  return center + offset * (int64_t{1} << chunk.offset_exp);
}

bool inside(const Node& node, const Node& chunk, const GaussianRecord& g) {
  const int64_t center[3] = {node.center_x, node.center_y, node.center_z};
  const uint64_t half[3] = {node.half_x, node.half_y, node.half_z};
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(world_mean(chunk, g, axis) - center[axis]) > static_cast<int64_t>(half[axis] << node.half_exp))
      return false;
  }
  return true;
}

// Whether the ellipsoid on which alpha is 1/AlphaCut lies in the node's box around ellipsoids.
bool covers(const Config& config, const Node& node, const Node& chunk, const GaussianRecord& g) {
  const std::array<double, 3> extents = ellipsoid_extents(config, g);
  const int64_t center[3] = {node.center_x, node.center_y, node.center_z};
  const uint64_t down[3] = {node.down_x, node.down_y, node.down_z}, up[3] = {node.up_x, node.up_y, node.up_z};
  const double most = std::ldexp(1.0, config.world_w - 1);  // what is wider is cut
  for (int axis = 0; axis < 3; ++axis) {
    const auto from = static_cast<double>(world_mean(chunk, g, axis) - center[axis]);
    const double extent = extents[static_cast<size_t>(axis)], unit = std::ldexp(2.0, static_cast<int>(node.half_exp));
    if (std::min(extent - from, most) > static_cast<double>(down[axis]) * unit) return false;
    if (std::min(extent + from, most) > static_cast<double>(up[axis]) * unit) return false;
  }
  return true;
}

// Everything a packed scene promises, for any configuration.
void check(const Config& config, const Scene& scene, const PackedScene& packed) {
  std::vector<int> seen(scene.gaussians.size());
  const auto aligned = static_cast<uint64_t>(std::max(2, config.gaussians_per_line()));
  uint64_t next_group = 0, next_chunk = 0, next_slot = 0;
  for (size_t c = 0; c < packed.cells.size(); ++c) {
    const Node& cell = packed.cells[c];
    if (cell.count != 0) { ASSERT_EQ(cell.first, next_group); }
    for (uint64_t g = cell.first; g < cell.first + cell.count; ++g, ++next_group) {
      const Node& group = packed.groups.at(g);
      ASSERT_EQ(group.first, next_chunk);
      ASSERT_TRUE(group.count >= 1 && group.count <= static_cast<uint64_t>(config.group));
      const uint64_t proxies = config.lod ? dopu_lod_chunks(config, group.count) : 0;
      std::set<uint32_t> own;  // the Gaussians of the group
      for (uint64_t k = group.first; k < group.first + group.count + proxies; ++k, ++next_chunk) {
        const Node& chunk = packed.chunks.at(k);
        const bool is_proxy = k >= group.first + group.count;
        ASSERT_EQ(chunk.first, next_slot) << "chunks lie one behind the other";
        ASSERT_EQ(chunk.first % aligned, 0u) << "a chunk begins a line";
        ASSERT_TRUE(chunk.count >= 1 && chunk.count <= static_cast<uint64_t>(config.chunk));
        next_slot = chunk.first + (chunk.count + aligned - 1) / aligned * aligned;
        for (uint64_t slot = chunk.first; slot < chunk.first + chunk.count; ++slot) {
          const GaussianRecord record = packed.gaussians[slot];
          const uint32_t index = packed.slot_to_index.at(slot);
          ASSERT_EQ(packed.scene_index(record.index), index);
          if (is_proxy) {
            ASSERT_EQ(own.count(index), 1u) << "a proxy has the number of one of the group's, that no other has";
            own.erase(index);
          } else {
            ++seen.at(index);
            own.insert(index);
          }
          ActivatedGaussian exact;
          ASSERT_EQ(activate(scene, index, exact), Cull::kNone);
          const int below = config.coded() ? config.pos_w - Config::offset_code_w() : 0,
                    unit = static_cast<int>(chunk.offset_exp) + below;
          for (int axis = 0; axis < 3 && !is_proxy; ++axis) {
            const double error =
                std::ldexp(static_cast<double>(world_mean(chunk, record, axis)), packed.scene_exponent) -
                exact.mean[axis];
            ASSERT_LE(std::abs(error),
                      std::ldexp(0.5001, unit + packed.scene_exponent) + std::ldexp(0.5, packed.scene_exponent));
          }
          const bool is_used = !is_proxy || group.error != dopu_lod_never(config);
          for (const Node* node : {&chunk, &group, &cell}) {
            if (node != &chunk && !is_used) continue;
            ASSERT_TRUE(inside(*node, chunk, record)) << "slot " << slot;
            ASSERT_GE(scale_value(config, node->scale_max), effective_scale(config, record));
            if (config.tight_boxes) { ASSERT_TRUE(covers(config, *node, chunk, record)) << "slot " << slot; }
          }
        }
      }
    }
  }
  uint64_t packed_count = 0;
  for (const int times : seen) {
    ASSERT_LE(times, 1);
    packed_count += static_cast<uint64_t>(times);
  }
  const PackCounts& n = packed.counts;
  EXPECT_EQ(packed_count, n.packed);
  EXPECT_EQ(n.proxies != 0, config.lod && n.packed != 0);
  EXPECT_EQ(n.packed + n.non_finite + n.zero_quaternion + n.transparent + n.out_of_range, scene.gaussians.size());
  const MemoryImage image = memory_image(packed);
  for (size_t i = 0; i < packed.chunks.size(); ++i) {
    ASSERT_EQ(unpack<Node>(config, image.lines.at(packed.layout.chunks + i / 2).data() + i % 2 * 8), packed.chunks[i]);
  }
  for (size_t i = 0; i < packed.cells.size(); ++i) {  // a count may be longer than its field
    const Node cell = unpack<Node>(config, image.lines.at(packed.layout.cells + i / 2).data() + i % 2 * 8);
    ASSERT_EQ(cell.error << config.count_w() | cell.count, packed.cells[i].count);
  }
  const size_t per_line = static_cast<size_t>(config.gaussians_per_line());
  const auto in_memory = [&](size_t slot) {
    return image.lines.at(packed.layout.gaussians + slot / per_line).data() + slot % per_line * (16 / per_line);
  };
  for (const Node& chunk : packed.chunks) {
    for (size_t slot = chunk.first; slot < chunk.first + chunk.count; ++slot) {
      const uint64_t scale_exp = chunk.scale_max >> config.scale_m_w;
      const GaussianRecord found =
          config.coded() ? pu_decode(config, unpack<GaussianCode>(config, in_memory(slot)), scale_exp, slot)
                         : unpack<GaussianRecord>(config, in_memory(slot));
      ASSERT_EQ(found, packed.gaussians[slot]) << "slot " << slot;
    }
  }
}

TEST(Pack, KeepsItsPromisesInEveryConfiguration) {
  std::mt19937_64 rng(1);
  for (const char* assignment : {"units=4", "grid=1", "grid=2", "grid=8", "chunk=8", "chunk=64", "group=1",
                                 "world_w=32", "world_w=44", "pos_w=12", "pos_w=24", "scale_m_w=6", "scale_m_w=16",
                                 "index_w=16", "sh_degree=1", "tight_boxes=1", "record=48", "lod=1"}) {
    SCOPED_TRACE(assignment);
    Config config;
    config_set(config, assignment);
    config.late = config.tight_boxes | config.lod;
    config.order = 2 * config.late;
    for (const size_t count : {0, 1, 2, 31, 33, 1000, 5000}) {
      const Scene scene = random_scene(rng, count, static_cast<int>(rng() % 4));
      check(config, scene, pack_scene(config, scene, 10));
    }
  }
}

// A machine with the exact order and these keys.
Config machine_with(std::initializer_list<const char*> settings) {
  Config config;
  config.late = 1;
  config.order = 2;
  for (const char* setting : settings) config_set(config, setting);
  return config;
}

// Records of both sizes, with and without proxies.
std::vector<Config> record_machines() {
  return {Config{}, machine_with({"record=48"}), machine_with({"lod=1"}),
          machine_with({"record=48", "lod=1", "tight_boxes=1"})};
}

TEST(Pack, ProxiesThatWouldWidenTheirGroupMuchAreNotUsed) {
  for (const char* boxes : {"tight_boxes=0", "tight_boxes=1"}) {
    SCOPED_TRACE(boxes);
    std::mt19937_64 rng(1);
    const Config config = machine_with({"lod=1", boxes});
    const Scene scene = random_scene(rng, 5000, 1);
    const PackedScene packed = pack_scene(config, scene, 10);
    check(config, scene, packed);
    glm::vec3 low(INFINITY), high(-INFINITY);
    for (const Gaussian& gaussian : scene.gaussians)
      low = glm::min(low, gaussian.mean), high = glm::max(high, gaussian.mean);
    // A tenth of the scene's diagonal: no less than what the packer takes, for which the bound holds all the more.
    const double window = std::ldexp(glm::distance(low, high) / 10, -packed.scene_exponent);
    size_t never = 0, widened = 0;
    for (const Node& group : packed.groups) {
      const auto first = packed.chunks.begin() + static_cast<std::ptrdiff_t>(group.first);
      const Node own = make_parent(config, std::span(first, group.count));
      const double area = hull_area(config, group, 0), own_area = hull_area(config, own, 0);
      if (group.error == dopu_lod_never(config)) {
        EXPECT_EQ(area, own_area);
        ++never;
      }
      widened += area > own_area;
      EXPECT_LE(hull_area(config, group, window), 1.01 * hull_area(config, own, window));
    }
    EXPECT_GT(never, 0u);
    if (config.tight_boxes) { EXPECT_GT(widened, 0u); }
  }
}

TEST(Pack, LeavesOutWhatCannotBeDrawnAndCountsIt) {
  std::mt19937_64 rng(2);
  Scene scene = random_scene(rng, 200);
  for (Gaussian& g : scene.gaussians) g.opacity_logit = 3;
  scene.gaussians[0].mean.x = std::numeric_limits<float>::quiet_NaN();
  scene.gaussians[1].mean.y = std::numeric_limits<float>::infinity();
  scene.gaussians[2].rotation = glm::vec4(0);
  scene.gaussians[3].opacity_logit = -6;  // 0.0025 < 1/255
  scene.gaussians[4].mean.z = 1e30f;
  scene.gaussians[5].log_scale = glm::vec3(-std::numeric_limits<float>::infinity());  // a point is legal
  scene.gaussians[6].opacity_logit = std::numeric_limits<float>::infinity();          // opaque
  scene.gaussians[7].sh_dc = glm::vec3(1e9f);                                         // clipped
  scene.gaussians[8].log_scale.x = 80;                                                // clipped
  for (const Config& config : record_machines()) {
    SCOPED_TRACE(config_difference(config));
    const PackedScene packed = pack_scene(config, scene, 1);
    EXPECT_EQ(packed.counts.non_finite, 2u);
    EXPECT_EQ(packed.counts.zero_quaternion, 1u);
    EXPECT_EQ(packed.counts.transparent, 1u);
    EXPECT_EQ(packed.counts.out_of_range, 1u);
    EXPECT_GE(packed.counts.saturated_base, 3u);
    EXPECT_GE(packed.counts.saturated_scale, 1u);
    if (config == Config{}) {
      EXPECT_EQ(packed.counts.saturated_base, 3u);
      EXPECT_EQ(packed.counts.saturated_scale, 1u);
    }
    check(config, scene, packed);
  }
}

// The codes of a chunk's scales reach 16 octaves down from the largest: what is below becomes larger, and is counted.
TEST(Pack, ScalesFarBelowTheLargestOfTheirChunkAreCounted) {
  std::mt19937_64 rng(5);
  Scene scene = random_scene(rng, 8, 0);
  for (Gaussian& gaussian : scene.gaussians) gaussian.log_scale = glm::vec3(-8), gaussian.opacity_logit = 2;
  scene.gaussians[3].log_scale.x = 3.5f;  // 16.6 octaves
  const Config config = machine_with({"record=48", "grid=1"});
  EXPECT_EQ(pack_scene(config, scene, 1).counts.saturated_scale, 3u * 7 + 2);
  scene.gaussians[3].log_scale.x = 0;
  EXPECT_EQ(pack_scene(config, scene, 1).counts.saturated_scale, 0u);
}

TEST(Pack, SlotsBeyondTheIndexOfACodeAreRefused) {
  std::mt19937_64 rng(6);
  Scene scene = random_scene(rng, 0, 0);
  Scene few = random_scene(rng, 100, 0);
  for (Gaussian& gaussian : few.gaussians) gaussian.opacity_logit = 2;
  for (int i = 0; i < 60000; ++i) scene.gaussians.push_back(few.gaussians[static_cast<size_t>(i % 100)]);
  for (const char* lod : {"lod=0", "lod=1"}) {
    const Config config = machine_with({"record=48", "index_w=16", lod});
    if (config.lod) {
      EXPECT_THROW(pack_scene(config, scene, 1), InputError) << "proxies have slots, too";
    } else {
      EXPECT_LE(pack_scene(config, scene, 1).gaussians.size(), 65536u);
    }
  }
}

TEST(Pack, AnEmptySceneOneOfOneAndOneWhereAllLieInOnePoint) {
  for (const Config& config : record_machines()) {
    SCOPED_TRACE(config_difference(config));
    Scene scene;
    EXPECT_EQ(pack_scene(config, scene, 0).chunks.size(), 0u);
    std::mt19937_64 rng(3);
    for (const size_t count : {1, 1000}) {
      scene = random_scene(rng, count);
      for (Gaussian& g : scene.gaussians) g.mean = glm::vec3(1, 2, 3);
      check(config, scene, pack_scene(config, scene, 0));
    }
  }
}

// The order by its definition: every cut of every part tried, without threads and without copies.
void order_slowly(std::span<OrderItem> items, size_t chunk, size_t group, float window, float reach) {
  if (items.size() <= chunk) return;
  const size_t step = items.size() > group ? group : chunk, count = items.size();
  std::vector<OrderItem> best;
  size_t best_at = 0;
  float least = std::numeric_limits<float>::infinity();
  for (int d = 0; d < 4; ++d) {
    std::vector<OrderItem> sorted(items.begin(), items.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](const OrderItem& a, const OrderItem& b) { return a.value[d] < b.value[d]; });
    const auto cost = [&](size_t begin, size_t end) {
      float low[3], high[3], scale = 0;
      for (int axis = 0; axis < 3; ++axis) low[axis] = high[axis] = sorted[begin].value[axis];
      for (size_t i = begin; i < end; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
          low[axis] = std::min(low[axis], sorted[i].value[axis]);
          high[axis] = std::max(high[axis], sorted[i].value[axis]);
        }
        scale = std::max(scale, sorted[i].value[3]);
      }
      const float grown = 2 * reach * scale + window;
      const float x = high[0] - low[0] + grown, y = high[1] - low[1] + grown, z = high[2] - low[2] + grown;
      return (x * y + y * z + z * x) * static_cast<float>(end - begin);
    };
    for (size_t at = (count - 1) / step * step; at > 0; at -= step) {
      const bool even = count <= 32 * step || (at * 32 >= count && (count - at) * 32 >= count);
      const float sum = even ? cost(0, at) + cost(at, count) : least;
      if (sum < least) least = sum, best_at = at, best = sorted;
    }
  }
  // Each part keeps the order of the items that came in: the cut only says which go left.
  const auto index = [](const OrderItem& a, const OrderItem& b) { return a.index < b.index; };
  std::sort(best.begin(), best.begin() + static_cast<std::ptrdiff_t>(best_at), index);
  std::sort(best.begin() + static_cast<std::ptrdiff_t>(best_at), best.end(), index);
  std::copy(best.begin(), best.end(), items.begin());
  order_slowly(items.first(best_at), chunk, group, window, reach);
  order_slowly(items.subspan(best_at), chunk, group, window, reach);
}

// Chunks as sets: within one the order is free.
std::vector<uint32_t> chunk_sets(const std::vector<OrderItem>& items, size_t chunk) {
  std::vector<uint32_t> indices;
  for (const OrderItem& item : items) indices.push_back(item.index);
  for (size_t i = 0; i < indices.size(); i += chunk) {
    std::sort(indices.begin() + static_cast<std::ptrdiff_t>(i),
              indices.begin() + static_cast<std::ptrdiff_t>(std::min(indices.size(), i + chunk)));
  }
  return indices;
}

std::vector<OrderItem> order_items(std::mt19937_64& rng, size_t count) {
  std::vector<OrderItem> items(count);
  for (size_t i = 0; i < count; ++i) {
    for (float& value : items[i].value) value = static_cast<float>(rng() % 4000) - 2000;  // with ties
    items[i].value[3] = std::exp2(static_cast<float>(rng() % 100) / 10 - 3);
    items[i].index = static_cast<uint32_t>(7 * i);
  }
  return items;
}

TEST(PackOrder, CutsWhereItsDefinitionSays) {
  std::mt19937_64 rng(6);
  for (const size_t count : {17, 100, 513, 1500, 3001}) {
    const std::vector<OrderItem> items = order_items(rng, count);
    std::vector<OrderItem> fast = items, slow = items;
    pack_order(fast, 16, 128, 5, 4, 1);
    order_slowly(slow, 16, 128, 5, 4);
    EXPECT_EQ(chunk_sets(fast, 16), chunk_sets(slow, 16)) << count << " items";
  }
}

TEST(PackOrder, IsTheSameOnAnyNumberOfThreads) {
  std::mt19937_64 rng(7);
  const std::vector<OrderItem> items = order_items(rng, 200000);  // more than are copied at a time
  const auto ordered = [&](unsigned threads) {
    std::vector<OrderItem> order = items;
    pack_order(order, 16, 512, 5, 4, threads);
    std::vector<uint32_t> indices;
    for (const OrderItem& item : order) indices.push_back(item.index);
    return indices;
  };
  const std::vector<uint32_t> one = ordered(1);
  EXPECT_EQ(one, ordered(2));
  EXPECT_EQ(one, ordered(5));
  std::vector<uint32_t> all = one;
  std::sort(all.begin(), all.end());
  for (size_t i = 0; i < all.size(); ++i) ASSERT_EQ(all[i], 7 * i);
}

TEST(NarrowTable, GivesBackWhatItTakesAndRefusesTheRest) {
  std::mt19937_64 rng(8);
  const Config config;
  NarrowTable<GaussianRecord> table;
  table.resize(100);
  std::vector<GaussianRecord> records;
  for (size_t i = 0; i < table.size(); ++i) {
    EXPECT_EQ(table[i], GaussianRecord{});
    records.push_back(random_record<GaussianRecord>(config, rng));
    table.set(i, records.back());
  }
  for (size_t i = 0; i < table.size(); ++i) EXPECT_EQ(table[i], records[i]);
  EXPECT_THROW(table.set(0, {.index = uint64_t{1} << 31}), std::logic_error);
  EXPECT_THROW(table.set(0, {.qw = -(int64_t{1} << 31) - 1}), std::logic_error);
}

TEST(PackQuantize, ScalesRoundAsTold) {
  std::mt19937_64 rng(4);
  for (const int mantissa_w : {6, 12, 16}) {
    Config config;
    config.scale_m_w = mantissa_w;
    for (int i = 0; i < 20000; ++i) {
      const double scale =
          std::ldexp(1 + std::ldexp(static_cast<double>(rng() >> 12), -52), static_cast<int>(rng() % 60) - 6);
      const double nearest = scale_value(config, encode_scale(config, scale, false)),
                   above = scale_value(config, encode_scale(config, scale, true));
      ASSERT_LE(std::abs(nearest / scale - 1), std::ldexp(0.5001, -mantissa_w));
      ASSERT_GE(above, scale);
      ASSERT_LE(above / scale - 1, std::ldexp(1.0001, -mantissa_w));
    }
    EXPECT_EQ(encode_scale(config, 0, true), 0u);
    EXPECT_GE(scale_value(config, encode_scale(config, 1e-9, true)), 1e-9);
  }
}

TEST(PackQuantize, ColoursComeBackWithinHalfAUnitOfTheirExponent) {
  std::mt19937_64 rng(5);
  const Config config;
  for (const int degree : {1, 2, 3}) {
    const Scene scene = random_scene(rng, 500, degree);
    const PackedScene packed = pack_scene(config, scene, 1);
    const size_t per_line = degree == 1 ? 4 : 1;
    for (size_t slot = 0; slot < packed.slot_to_index.size(); ++slot) {
      if (packed.slot_to_index[slot] == kPadding) continue;
      const uint32_t* line = packed.colors[slot / per_line].data();
      const int at = static_cast<int>(slot % per_line) * 128;
      const int exponent = static_cast<int>(get_bits(line, at, config.sh_e_w));
      const float* exact = sh_rest_of(scene, packed.slot_to_index[slot]);
      for (int i = 0; i < 3 * sh_rest_count(degree); ++i) {
        int64_t m = static_cast<int64_t>(get_bits(line, at + config.sh_e_w + i * config.sh_m_w, config.sh_m_w));
        if (m >> (config.sh_m_w - 1)) m -= int64_t{1} << config.sh_m_w;
        const double unit = std::ldexp(1.0, exponent - 26 - config.sh_m_w), limit = 16 - unit;
        const double wanted = std::clamp(static_cast<double>(exact[i]), -16.0, limit);
        ASSERT_LE(std::abs(static_cast<double>(m) * unit - wanted),
                  0.5001 * std::max(unit, std::ldexp(1.0, 5 - config.sh_m_w) * (std::abs(exact[i]) > 15.9)));
      }
    }
  }
}

// The layout of sh_code.hpp, written down once more.
TEST(PackQuantize, CodesOfColoursComeBackWithinHalfAUnitOfTheirBand) {
  std::mt19937_64 rng(6);
  Config config;
  config.record = 48;
  int lower = 0;  // bands that lie below their Gaussian's exponent
  for (const int degree : {1, 2, 3}) {
    Scene scene = random_scene(rng, 500, degree);
    for (size_t i = 0; i < scene.sh_rest.size(); ++i) {  // higher bands are smaller, as in trained scenes
      const size_t function = i / 3 % static_cast<size_t>(sh_rest_count(degree));
      if (rng() % 4 != 0) scene.sh_rest[i] *= function < 3 ? 1 : function < 8 ? 0.2f : 0.05f;
    }
    const PackedScene packed = pack_scene(config, scene, 1);
    const size_t per_line = degree == 1 ? 8 : 2;
    for (size_t slot = 0; slot < packed.slot_to_index.size(); ++slot) {
      if (packed.slot_to_index[slot] == kPadding) continue;
      const uint32_t* line = packed.colors[slot / per_line].data();
      const int at = static_cast<int>(slot % per_line * (512 / per_line));
      const int exponent = static_cast<int>(get_bits(line, at, 5));
      const float* exact = sh_rest_of(scene, packed.slot_to_index[slot]);
      for (int i = 0; i < 3 * sh_rest_count(degree); ++i) {
        const int band = i < 9 ? 1 : i < 24 ? 2 : 3, width = band == 1 ? 6 : 5;
        const int place = (degree == 1 ? 5 : 14) + (band == 1 ? 6 * i : 54 + 5 * (i - 9));
        const int drop = degree == 1 ? 0 : static_cast<int>(get_bits(line, at + 5 + 3 * (band - 1), 3));
        auto m = static_cast<int64_t>(get_bits(line, at + place, width));
        if (m >> (width - 1)) m -= int64_t{1} << width;
        const double unit = std::ldexp(1.0, exponent - drop - 26 - width), limit = 16 - unit;
        const double wanted = std::clamp(static_cast<double>(exact[i]), -16.0, limit);
        ASSERT_LE(std::abs(static_cast<double>(m) * unit - wanted), 0.5001 * unit) << "coefficient " << i;
        lower += drop > 0;
        ASSERT_LE(drop, 11 - width);
      }
    }
  }
  EXPECT_GT(lower, 1000);
}

}  // namespace
}  // namespace pipegs
