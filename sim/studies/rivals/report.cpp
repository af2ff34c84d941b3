// SPDX-License-Identifier: Apache-2.0
// report.cpp: see report.hpp.
#include "sim/studies/rivals/report.hpp"

#include <fmt/format.h>

#include <utility>

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

struct NamedCover {
  Cover cover;
  const char *key, *what;
};
constexpr NamedCover kNamed[] = {
    {Cover::kSquare, "square", "square of ceil(3 sigma), as INRIA"},
    {Cover::kAxis, "axis_box", "box of 3 sigma in x and y"},
    {Cover::kOriented, "oriented_box", "box of 3 sigma along the eigenvectors, as GSCore"},
    {Cover::kExact, "exact", "alpha >= 1/255 at a pixel"},
};
constexpr const char *kPairUnit = "(Gaussian, tile)", *kPartUnit = "(Gaussian, part)",
                     *kPixelUnit = "(Gaussian, pixel)", *kFetchUnit = "(Gaussian, group)";

class Rows {
 public:
  void section(const std::string& name) { section_ = name; }
  void add(const std::string& key, uint64_t value, const std::string& unit, const std::string& what) {
    rows_.push_back({section_, key, value, unit, what});
  }
  void parts(const std::string& key, const PartCounts& parts, const std::string& what) {
    add(key, parts.all, kPartUnit, what);
    add(key + "_tile_open", parts.tile_open, kPartUnit, "of those, before the tile is opaque");
    add(key + "_open", parts.open, kPartUnit, "of those, before the part is opaque");
    add(key + "_live", parts.live, kPartUnit, "of those, with alpha >= 1/255 at a pixel that has not stopped");
  }
  void filters(const std::string& key, const FilterCounts& filters, const std::string& unit, const std::string& what) {
    add(key + "fetched", filters.fetched, unit, "in voxels that are met" + what);
    add(key + "coarse", filters.coarse, unit, "of those, sphere of 3 x the largest scale touches the group");
    add(key + "fine", filters.fine, unit, "of those, alpha >= 1/255 at a pixel of the group");
  }
  std::vector<CountRow> take() { return std::move(rows_); }

 private:
  std::string section_;
  std::vector<CountRow> rows_;
};

Json list_json(const ListCounts& lists) {
  Json json = {{"side", lists.side}, {"tiles", lists.lengths.exact.size()}};
  for (const NamedCover& named : kNamed) {
    const ListSums sums = list_sums(lists.lengths[named.cover]);
    json[named.key] = {{"pairs", sums.pairs},
                       {"nonempty", sums.nonempty},
                       {"longest", sums.longest},
                       {"lists_above_16", sums.long_lists},
                       {"pairs_above_16", sums.long_pairs},
                       {"chunks_of_16", sums.chunks},
                       {"pivot_steps", sums.steps},
                       {"histogram", sums.histogram}};
  }
  return json;
}

const std::pair<const char*, const char*> kListColumns[] = {
    {"tiles", "tiles of this side in the image"},
    {"pairs", "(Gaussian, tile) pairs: lengths of all lists, opaque tiles too"},
    {"nonempty", "lists with a Gaussian"},
    {"longest", "Gaussians in the longest list"},
    {"lists_above_16", "lists of more than 16 Gaussians"},
    {"pairs_above_16", "pairs in lists of more than 16"},
    {"chunks_of_16", "sum of ceil(n / 16): runs of a sorter of 16"},
    {"pivot_steps", "sum of n ceil(log8(n / 16)), none for n <= 16: keys that a splitter by 8 pivots moves"},
    {"histogram", "[k]: lists with 2^k <= n < 2^(k+1)"},
};

}  // namespace

std::vector<CountRow> count_rows(const FrameCounts& counts, const CountOptions& options) {
  Rows rows;
  const GaussianCounts& g = counts.gaussians;
  rows.section("gaussians");
  rows.add("scene", g.scene, "Gaussians", "in the file");
  rows.add("valid", g.valid, "Gaussians", "finite, with a rotation");
  rows.add("in_front", g.in_front, "Gaussians", "of those, in front of the near plane");
  rows.add("in_frustum", g.listed.square, "Gaussians", "of those, square of 3 sigma in a 16-px tile of the image");
  rows.add("in_axis_box", g.listed.axis, "Gaussians", "box of 3 sigma in x and y in such a tile");
  rows.add("in_oriented_box", g.listed.oriented, "Gaussians", "oriented box of 3 sigma in such a tile");
  rows.add("visible", g.listed.exact, "Gaussians", "alpha >= 1/255 at a pixel of the image, opaque or not");
  rows.add("in_two_tiles", g.in_two, "Gaussians", "of those, in two 16-px tiles or more");
  rows.add("blended", g.blended, "Gaussians", "of those, that add to a pixel");

  rows.section("pairs_before_opaque");
  for (const NamedCover& named : kNamed) {
    const WalkCounts& walk = counts.total.walk[named.cover];
    rows.add(named.key, walk.open, kPairUnit, fmt::format("16-px tiles by {}, before the tile is opaque", named.what));
  }
  rows.section("pixels");
  for (const NamedCover& named : kNamed) {
    const WalkCounts& walk = counts.total.walk[named.cover];
    rows.add(fmt::format("evaluated_{}", named.key), kTileSide * kTileSide * walk.open, kPixelUnit,
             "all 256 for each of these pairs");
    rows.add(fmt::format("alive_{}", named.key), walk.alive, kPixelUnit, "of those, pixels that have not stopped");
  }
  rows.add("reached", counts.total.reached, kPixelUnit, "alpha >= 1/255, stopped or not");
  rows.add("blends", counts.total.blends, kPixelUnit, "of those, that add to the pixel");
  rows.add("stops", counts.total.stops, "pixels", "that stop");

  rows.section("parts");
  rows.parts("oriented_8x8", counts.total.oriented_8x8, "8x8 parts of 16-px tiles that the oriented box touches");
  rows.parts("exact_8x8", counts.total.exact_8x8, "8x8 parts with alpha >= 1/255 at a pixel");
  rows.parts("exact_4x4", counts.total.exact_4x4, "4x4 parts with alpha >= 1/255 at a pixel");
  rows.section("rows");
  rows.parts("exact_16x1", counts.total.exact_16x1, "rows of 16 pixels with alpha >= 1/255 at a pixel");
  rows.parts("exact_8x1", counts.total.exact_8x1, "rows of 8 pixels with alpha >= 1/255 at a pixel");
  rows.add("footprint", g.rows, "(Gaussian, row)", "rows of the whole image with alpha >= 1/255 at a pixel");

  rows.section("masks");
  rows.add("in_axis_groups", counts.masks.axis, kPairUnit,
           "exact, 16-px tiles, in 64-px groups that the axis box touches");
  rows.add("in_oriented_groups", counts.masks.oriented, kPairUnit, "the same, of groups that the oriented box touches");

  rows.section("neighbours");
  rows.add("pairs", counts.neighbours.pairs, "Gaussians", "with an oriented box in a 16-px tile and one before them");
  rows.add("tiles", counts.neighbours.tiles, kPairUnit, "16-px tiles of their oriented boxes");
  rows.add("shared", counts.neighbours.shared, kPairUnit, "of those, tiles of the one before in depth order too");

  const VoxelCounts& v = counts.voxels;
  rows.section("voxels");
  rows.add("occupied", v.occupied, "voxels", fmt::format("of edge {} with a Gaussian's mean in them", options.voxel));
  rows.add("largest", v.largest, "Gaussians", "in the fullest one");
  rows.add("met", v.met, "voxels", "that a pixel's ray meets beyond the near plane");
  rows.add("pairs", v.pairs, "(voxel, group)", fmt::format("that meet, groups of {0}x{0} pixels", options.group));
  rows.add("open_pairs", v.open_pairs, "(voxel, group)", "of those, nearer than where the group is opaque");
  rows.filters("", v.all, kFetchUnit, "");
  rows.filters("open_", v.open, kFetchUnit, " nearer than where the group is opaque");
  rows.filters("distinct_", v.distinct, "Gaussians", ", each Gaussian once");
  return rows.take();
}

Json counts_json(const FrameCounts& counts, const CountOptions& options) {
  Json json;
  json["parameters"] = {{"near", options.near_plane}, {"voxel", options.voxel}, {"group", options.group}};
  for (const CountRow& row : count_rows(counts, options)) {
    json["counts"][row.section][row.key] = row.value;
    json["definitions"][row.section][row.key] = fmt::format("{}: {}", row.unit, row.what);
  }
  for (const ListCounts& lists : counts.lists) json["lists"].push_back(list_json(lists));
  for (const VoxelCounts& voxels : counts.other_voxels)
    json["other_voxels"].push_back({{"voxel", voxels.edge},
                                    {"open_pairs", voxels.open_pairs},
                                    {"open_fetched", voxels.open.fetched},
                                    {"open_coarse", voxels.open.coarse},
                                    {"open_fine", voxels.open.fine}});
  for (const auto& [key, what] : kListColumns) json["definitions"]["lists"][key] = what;
  for (const NamedCover& named : kNamed) json["definitions"]["lists"][named.key] = named.what;
  return json;
}

std::vector<Table> counts_tables(const FrameCounts& counts, const CountOptions& options) {
  std::vector<Table> tables;
  for (const CountRow& row : count_rows(counts, options)) {
    if (tables.empty() || tables.back().title != row.section)
      tables.push_back({.title = row.section,
                        .columns = {{.key = "count", .word = true},
                                    {.key = "value"},
                                    {.key = "unit", .word = true},
                                    {.key = "what", .word = true}}});
    tables.back().rows.push_back(
        {text_cell(row.key), number_cell(static_cast<double>(row.value)), text_cell(row.unit), text_cell(row.what)});
  }
  Table lists{.title = "lists",
              .columns = {{.key = "side", .heading = "side"}, {.key = "by", .heading = "by", .word = true}}};
  for (const auto& [key, what] : kListColumns) {
    if (std::string_view(key) == "histogram") continue;
    lists.columns.push_back({.key = key, .heading = key});
    lists.notes.push_back(fmt::format("{}: {}", key, what));
  }
  for (const ListCounts& one : counts.lists) {
    for (const NamedCover& named : kNamed) {
      const ListSums s = list_sums(one.lengths[named.cover]);
      std::vector<TableCell>& row = lists.rows.emplace_back();
      row = {number_cell(one.side), text_cell(named.key)};
      for (const uint64_t value : {uint64_t{one.lengths[named.cover].size()}, s.pairs, s.nonempty, s.longest,
                                   s.long_lists, s.long_pairs, s.chunks, s.steps})
        row.push_back(number_cell(static_cast<double>(value)));
    }
  }
  tables.push_back(lists);
  return tables;
}

}  // namespace pipegs
