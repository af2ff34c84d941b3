// SPDX-License-Identifier: Apache-2.0
// static_cost.cpp: see static_cost.hpp.
#include "sim/design/static_cost.hpp"

#include "cpp_model/records.hpp"

namespace pipegs {
namespace {

constexpr int kRows = 8;    // Row Units of a unit, Table 2
constexpr int kLanes = 16;  // of an RU: the paper's Rendering Units, Table 2

int power_of_two(int n) { return 1 << clog2(n); }

void add_buffers(const Config& c, StaticCost& cost) {
  const auto add = [&](const char* buffer, const char* purpose, int width, int depth, int count, int ports = 2) {
    cost.buffers.push_back({buffer, purpose, width, depth, count, ports});
  };
  const int units = c.units, splat = record_width<Splat>(c), memory = c.memory_w();
  if (c.has_stores()) {
    add("alpha store u_lines", "alphas", c.line_w(), c.alpha_lines, units);
    add("alpha store u_slots", "alphas", c.alpha_slot_w(), c.alpha_addresses(), units);
    add("alpha store u_pool.u_back", "alphas", c.alpha_slot_w(), c.alpha_lines, units);
  }
  const int halves = c.quads ? 1 : 2;  // of the pixels: lanes of living quads hand them over region by region
  add("RU u_pixels", "pixels", c.tap_word_w(), c.regions() / units * 4, halves * units * c.tap_lanes());

  add("SU u_records", "records", splat - c.key_w() - c.kind_w(), c.records, units, 1);
  add("SU u_keys", "records", c.key_w(), c.records, units);
  const int low = (c.bucket_w() + 1) / 2;  // a bucket is {word, bit}
  add("SU u_buckets.u_table", "sorter", 3 * c.record_w() + 1, 2 << c.bucket_w(), units, 1);
  add("SU u_buckets.u_words", "sorter", 1 << low, 2 << (c.bucket_w() - low), units);
  add("SU u_slots.u_back", "sorter", c.record_w(), c.records, units);
  add("SU u_marks", "sorter", 3 + c.kind_w() + c.bucket_w(), c.su_marks(), units);
  add("SU u_chains", "sorter", c.kind_w() + c.bucket_w() + 2 * c.record_w() + 1, c.su_chains(), units);
  add("SU u_links", "sorter", c.record_w(), c.records, units);
  const int stack = c.records / 8 + c.key_w() / 4 + 2;  // groups that may wait
  if (c.large_groups)
    add("SU u_split.u_stack", "sorter", 2 * c.record_w() + 1 + clog2(c.key_w()), power_of_two(stack + 1), units, 1);
  add("SU u_emit.u_waiting", "sorter", c.kind_w() + 1 + c.record_w() + c.key_w(), c.su_waiting(), units);
  if (c.overflow) {
    const int ways = c.su_ways(), line = clog2(c.su_way_lines());
    add("SU u_external.u_ways.u_asks", "overflow", 2 * c.slot_w(), ways, units);
    add("SU u_external.u_tree.u_left", "overflow", c.slot_w(), ways, units);
    add("SU u_external.u_tree.u_nodes", "overflow", 1 + c.key_w() + clog2(ways) + 3 + line, ways, units);
    add("SU u_port.u_owners", "overflow", 1 + clog2(ways), c.su_answers(), units);
    add("SU u_port.u_answers", "overflow", memory, c.su_answers(), units);
  }

  const int fronts = c.pu_fronts();
  add("PU u_front.u_fetch.u_reader.u_lines", "parameters", memory, c.geometry_lines(), fronts);
  if (c.tight_cull) add("PU u_front.u_reach.u_words", "parameters", record_width<Visible>(c), c.reach_depth(), fronts);
  add("PU u_visible", "parameters", record_width<Visible>(c), c.visible_depth(), units);
  add("PU u_shape.u_centers", "parameters", record_width<Center>(c), c.center_depth(), units);
  const int payload = c.has_lists() ? record_width<Listed>(c) : record_width<Parted>(c);
  add("PU u_regions.u_waiting", "parameters", payload, c.payload_depth(), units);
  if (c.has_lists()) add("PU u_list.u_payload", "parameters", record_width<Payload>(c), c.shape_places(), units);
  if (c.parts() > 1) add("PU u_parts.u_payload", "parameters", record_width<Payload>(c), c.shape_places(), units);
  add("PU u_walks", "parameters", record_width<Coeff>(c), c.walk_depth(), units);
  if (c.sh_degree > 0) {
    add("PU u_color..u_lines", "parameters", memory, c.color_depth(), units);
    add("PU u_color..u_tasks", "parameters", record_width<ColorTask>(c), c.color_depth(), units);
    add("PU u_color..u_directions", "parameters", record_width<ViewDirection>(c), c.color_depth(), units);
  }
  if (c.has_lists()) {
    const int shape = 2 * c.extent_w() + 1 + c.slope_w() + 2 * (c.mantissa_w + c.float_e_w()) + c.opacity_w() +
                      c.tilt_w() + 2 * c.side_w();
    add("PU u_expand.u_queue", "parameters", shape + 2 * c.mean_w() + 4 * c.window_w(), c.expand_depth(), units);
    add("lists u_counts", "lists", c.list_entry_w(), 1 << c.list_window_w(), 1);
    add("lists u_read.u_reader.u_lines", "lists", memory, c.list_lines(), 1);
  } else if (!c.caches_alphas()) {
    add("PU u_late.u_coeffs", "parameters",
        c.mask_w() + c.a_w() + 2 * c.bc_w() + 3 * c.def_w() + (c.parts() > 1 ? 1 + c.part_w() : 0), c.late_depth(),
        units);
  }
  if (c.caches_alphas()) {
    add("PU u_jobs", "parameters", record_width<RowJob>(c), c.row_jobs(), units);
    if (c.spills_alphas()) add("RU u_fetch.u_external", "overflow", c.line_w(), c.fetch_lines, units);
    add("RU u_fetch.u_records", "queues", record_width<Blend>(c), c.ru_records(), units);
  }
  const int others = c.quads ? c.mask_w() - c.mask_w() / units : 0;  // of the mask, regions of other RUs
  add("RU u_queue", "queues", record_width<Sorted>(c) - others, c.ru_queue(), units);
  if (c.quads) {  // a half: two quads of a group, which of them live, which half of which region, colour
    const int half = 2 + 8 * record_width<Exponent>(c) + 1 + c.region_w() + 3 * c.color_w + c.tap_index_w();
    add("RU u_quads.u_queue", "queues", half, Config::ru_halves(), units * Config::ru_groups());
  }

  add("DOPU readers u_lines", "scene", memory, c.node_lines(), 2);
  add("DOPU u_cells.u_table", "scene", 2 * record_width<Node>(c), std::max(2, c.table_cells() / 2), 1, 1);
  if (c.has_watermarks()) {  // six lists of nodes, each in buckets of depth
    const int nodes = c.nearest_nodes, number = clog2(nodes);
    const int low = c.bucket_w() / 2;  // a bucket is {word, bit}
    add("DOPU u_nearest.u_bucket.u_heads", "scene", number, 6 << c.bucket_w(), 1, 1);
    add("DOPU u_nearest.u_bucket.u_words", "scene", 1 << low, 6 << (c.bucket_w() - low), 1, 1);
    add("DOPU u_nearest.u_bucket.u_nodes", "scene", c.count_w() + c.slot_w() + c.node_place_w() + number + 1, nodes, 1,
        1);
    add("DOPU u_nearest.u_bucket.u_back", "scene", number, nodes, 1);
    if (c.has_walks()) {  // chunks of half as many groups as places, four buckets in a word
      add("DOPU u_load.u_sums", "scene", 4 * clog2((nodes / 2 + 1) * c.group + 1), 1 << (c.load_w() - 2), 2);
    }
  }
}

}  // namespace

double StaticCost::buffer_kb() const {
  uint64_t bits = 0;
  for (const BufferCost& row : buffers) bits += row.bits();
  return static_cast<double>(bits) / 8192;
}

StaticCost static_cost(const Config& config) {
  StaticCost cost;
  cost.row_lanes = kRows * (config.quads ? 8 : config.pixels_per_row) * config.units;
  cost.blend_lanes = kLanes * config.units;
  add_buffers(config, cost);
  return cost;
}

}  // namespace pipegs
