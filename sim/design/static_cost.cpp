// SPDX-License-Identifier: Apache-2.0
// static_cost.cpp: see static_cost.hpp.
#include "sim/design/static_cost.hpp"

#include <algorithm>

#include "cpp_model/records.hpp"

namespace pipegs {
namespace {

constexpr int kAdderBits = 14;  // of both values that a sum must have to be counted
constexpr int kRows = 8;        // Row Units of a unit, Table 2
constexpr int kLanes = 16;      // of an RU: the paper's Rendering Units, Table 2

void add_row_inits(const Config& c, StaticCost& cost) {
  int adders = 0, constant = 0;
  for (int dy = 0; dy < kRows; ++dy) {
    adders += dy == 0 ? 1 : 4;
    constant += 2 * constant_product_adders(dy) + constant_product_adders(dy * dy);
  }
  cost.arithmetic.push_back({"pu_row_init", "power", c.caches_alphas() ? "pu" : "ru", kRows * c.units, 0,
                             adders * c.units, constant * c.units});
}

// With quads: the powers of all pixels of a region at once, exponentials for the lanes.
void add_live_power(const Config& c, StaticCost& cost) {
  const auto add = [&](const char* module, int instances, int multipliers, int adders, int constant_adders = 0) {
    cost.arithmetic.push_back({module, "power", "ru", instances, multipliers, adders, constant_adders});
  };
  // Column x: power + x slope + x (x - 1) curve; the last products serve all rows.
  int adders = 0, constant = 0;
  for (int x = 0; x < 8; ++x) {
    adders += kRows * std::min(x, 2);
    constant += kRows * constant_product_adders(x) + constant_product_adders(x * (x - 1));
  }
  add("ru_regions", c.units, 8 * c.units, 9 * c.units);
  add("ru_power", c.units, 0, adders * c.units, constant * c.units);
  add_row_inits(c, cost);
  const int chords = c.exp_linear ? kLanes * c.units : 0;
  add("pipegs_exp2", kLanes * c.units, chords, chords);
}

// The Row Units, wherever they stand.
void add_power(const Config& c, StaticCost& cost) {
  if (c.quads) return add_live_power(c, cost);
  const std::string unit = c.caches_alphas() ? "pu" : "ru";
  const int rows = kRows * c.units, pixels = c.pixels_per_row;
  const auto add = [&](const char* module, int instances, int multipliers, int adders, int constant_adders = 0) {
    cost.arithmetic.push_back({module, "power", unit, instances, multipliers, adders, constant_adders});
  };
  add("pu_region", c.units, 8 * c.units, 9 * c.units);
  if (c.quadratic) {
    // Row dy, each pixel: slope_x x, curve_x x x, twist x (none in row 0); six summands (three in row 0). The products
    // of slope_y, curve_y and twist with dy are constant ones; the first two are shared by the pixels of a cycle.
    int multipliers = 0, adders = 0, constant = 0;
    for (int dy = 0; dy < kRows; ++dy) {
      multipliers += pixels * (dy == 0 ? 3 : 4);
      adders += pixels * (dy == 0 ? 2 : 5);
      constant += constant_product_adders(dy) * (3 + pixels);
    }
    add("pu_power", rows, multipliers * c.units, adders * c.units, constant * c.units);
  } else {
    add_row_inits(c, cost);
    add("pu_row_unit", rows, 0, rows * (pixels == 1 ? 2 : 4));
  }
  const int chords = c.exp_linear ? rows * pixels : 0;
  add("pipegs_exp2", rows * pixels, chords, chords);
}

void add_arithmetic(const Config& c, StaticCost& cost) {
  const auto times = [](std::initializer_list<int> constants) {
    int adders = 0;
    for (const int constant : constants) adders += constant_product_adders(constant);
    return adders;
  };
  // `n` of them, and what one of them holds; `each` per unit (the DOPU is one).
  const auto add_n = [&](const char* module, const char* kind, const char* unit, int n, int multipliers, int adders,
                         int constant = 0) {
    cost.arithmetic.push_back({module, kind, unit, n, n * multipliers, n * adders, n * constant});
  };
  const auto add = [&](const char* module, const char* kind, const char* unit, int each, int multipliers, int adders,
                       int constant = 0) {
    add_n(module, kind, unit, each * (std::string(unit) == "dopu" ? 1 : c.units), multipliers, adders, constant);
  };
  add("dopu_layer", "partition", "dopu", 1, 0, c.layered ? 2 : 0);
  add("dopu_origin", "partition", "dopu", 1, 3, 6);
  add("dopu_planes", "partition", "dopu", 1, 1, 3);
  add("dopu_test", "partition", "dopu", c.has_watermarks() ? 2 : 1, 8, 9 + (c.tight_boxes ? 2 : 0));
  // Of a window with its margin, sixteenths of a pixel; with lists against the rectangle of all windows.
  const int span = (c.window - 1 + 2 * c.reach_margin()) * 16 + 1;
  if (c.has_lists()) {
    add_n("pu_cull", "projection", "pu", c.pu_fronts(), 18, 27);
  } else {
    add_n("pu_cull", "projection", "pu", c.pu_fronts(), 16, 29 + (c.tight_cull ? 6 : 0), times({span}));
  }
  if (c.tight_cull) add_n("pu_reach", "projection", "pu", c.pu_fronts(), 36, 26);
  add("pu_project", "projection", "pu", 1, 1, 1);
  add("pu_orient", "projection", "pu", 1, 4, 14);
  add("pu_jacobian", "projection", "pu", 1, 2, 4);
  add("pu_factors", "projection", "pu", 1, 2, 0);
  add("pu_squares", "projection", "pu", 1, 2, 2);
  add("pu_covariance", "projection", "pu", 1, 1, 1);
  if (c.antialias) {
    add("pu_compensate", "projection", "pu", 1, 0, 3);
    add("pipegs_log2", "projection", "pu", 2, 1, 1);
  }
  add("pu_conic", "projection", "pu", 1, 1, 0);
  if (c.oriented()) {
    add("pu_axes", "projection", "pu", 1, 2, 5);
    add("pu_box", "projection", "pu", 1, 2, 6);
    add("pu_touch", "projection", "pu", c.tests + c.has_lists(), 2, 6, times({7}));  // 15 takes one adder, too
    add("pipegs_rsqrt", "projection", "pu", 2, 1, 1);
  } else {
    add("pu_extent", "projection", "pu", 1, 0, 0, times({361}));
    add("pu_root", "projection", "pu", 2, 0, 2);
  }
  add("pipegs_recip", "projection", "pu", 2 + c.oriented(), 3, 1);
  if (c.has_lists() || c.parts() > 1) add("pu_span", "projection", "pu", 2, 0, 2);
  add("pu_coeff", "projection", "pu", 1, 2, 6);
  add("pu_intersect", "projection", "pu", 1, 6, 12 + 5 * (c.tests - 1));
  add("pu_step", "projection", "pu", c.tests, 0, 4);
  if (c.tile_test == 1) add("pu_edge", "projection", "pu", c.tests, 2, 10, times({7, 7, 7, 14, 14, 49, 49, 49}));
  if (c.sh_degree > 0) {
    add("pu_color_rotate", "color", "pu", 1, 2, 2);
    add("pu_color_normalise", "color", "pu", 1, 1, 0);
    add("pipegs_rsqrt", "color", "pu", 1, 1, 1);
    add("pu_color_basis", "color", "pu", 1, 4, 4);
    add("pu_color_sum", "color", "pu", 1, 6, c.base_w < kAdderBits ? 6 : 9);  // three add the base
  }
  add_power(c, cost);
  add("ru_blend", "blend", "ru", kLanes, 4, 4);
}

int power_of_two(int n) { return 1 << clog2(n); }

void add_buffers(const Config& c, StaticCost& cost) {
  const auto add = [&](const char* buffer, const char* purpose, int width, int depth, int count) {
    cost.buffers.push_back({buffer, purpose, width, depth, count});
  };
  const int units = c.units, splat = record_width<Splat>(c), memory = c.memory_w();
  if (c.has_stores()) {
    add("alpha store u_lines", "alphas", c.line_w(), c.alpha_lines, units);
    add("alpha store u_slots", "alphas", c.alpha_slot_w(), c.alpha_addresses(), units);
    add("alpha store u_pool.u_back", "alphas", c.alpha_slot_w(), c.alpha_lines, units);
  }
  const int halves = c.quads ? 1 : 2;  // of the pixels: lanes of living quads hand them over region by region
  add("RU u_pixels", "pixels", c.tap_word_w(), c.regions() / units * 4, halves * units * c.tap_lanes());

  add("SU u_records", "records", splat - c.key_w() - c.kind_w(), c.records, units);
  add("SU u_keys", "records", c.key_w(), c.records, units);
  const int low = (c.bucket_w() + 1) / 2;  // a bucket is {word, bit}
  add("SU u_buckets.u_table", "sorter", 3 * c.record_w() + 1, 2 << c.bucket_w(), units);
  add("SU u_buckets.u_words", "sorter", 1 << low, 2 << (c.bucket_w() - low), units);
  add("SU u_slots.u_back", "sorter", c.record_w(), c.records, units);
  add("SU u_marks", "sorter", 3 + c.kind_w() + c.bucket_w(), c.su_marks(), units);
  add("SU u_chains", "sorter", c.kind_w() + c.bucket_w() + 2 * c.record_w() + 1, c.su_chains(), units);
  add("SU u_links", "sorter", c.record_w(), c.records, units);
  const int stack = c.records / 8 + c.key_w() / 4 + 2;  // groups that may wait
  if (c.large_groups)
    add("SU u_split.u_stack", "sorter", 2 * c.record_w() + 1 + clog2(c.key_w()), power_of_two(stack + 1), units);
  if (c.overflow) add("SU u_emit.u_numbers", "overflow", c.slot_w(), c.records, units);
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
  add("RU u_queue", "queues", record_width<Sorted>(c), c.ru_queue(), units);

  add("DOPU readers u_lines", "scene", memory, c.node_lines(), 2);
  const int cell_bits = 3 * (c.grid > 1 ? clog2(c.grid) : 1);
  add("DOPU u_cells.u_table", "scene", 2 * record_width<Node>(c), 1 << (cell_bits - 1), 1);
  if (c.has_watermarks()) {  // six lists of nodes, each in buckets of depth
    const int nodes = c.nearest_nodes, number = clog2(nodes);
    const int low = c.bucket_w() / 2;  // a bucket is {word, bit}
    add("DOPU u_nearest.u_bucket.u_heads", "scene", number, 6 << c.bucket_w(), 1);
    add("DOPU u_nearest.u_bucket.u_words", "scene", 1 << low, 6 << (c.bucket_w() - low), 1);
    add("DOPU u_nearest.u_bucket.u_nodes", "scene", c.count_w() + c.slot_w() + 3 * c.world_w + c.exp_w() + number + 1,
        nodes, 1);
    add("DOPU u_nearest.u_bucket.u_back", "scene", number, nodes, 1);
  }
}

}  // namespace

int constant_product_adders(int constant) {
  int digits = 0;
  for (int rest = constant; rest != 0; rest >>= 1) {
    if ((rest & 1) == 0) continue;
    ++digits;
    rest += (rest & 3) == 3 ? 1 : -1;  // a run of ones is 2^n - 1
  }
  return digits > 1 ? digits - 1 : 0;
}

int StaticCost::multipliers(const std::string& kind) const {
  int sum = 0;
  for (const ArithmeticCost& row : arithmetic) sum += kind.empty() || row.kind == kind ? row.multipliers : 0;
  return sum;
}

int StaticCost::adders(const std::string& kind) const {
  int sum = 0;
  for (const ArithmeticCost& row : arithmetic)
    sum += kind.empty() || row.kind == kind ? row.adders + row.constant_adders : 0;
  return sum;
}

double StaticCost::buffer_kb(const std::string& purpose) const {
  uint64_t bits = 0;
  for (const BufferCost& row : buffers) bits += purpose.empty() || row.purpose == purpose ? row.bits() : 0;
  return static_cast<double>(bits) / 8192;
}

StaticCost static_cost(const Config& config) {
  StaticCost cost;
  cost.row_lanes = kRows * (config.quads ? 8 : config.pixels_per_row) * config.units;
  cost.blend_lanes = kLanes * config.units;
  add_arithmetic(config, cost);
  add_buffers(config, cost);
  return cost;
}

}  // namespace pipegs
