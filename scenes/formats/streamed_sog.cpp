// SPDX-License-Identifier: Apache-2.0
// streamed_sog: lod-meta.json of PlayCanvas: a tree of boxes, each with rows of SOG files for several levels of detail.
//
// Idea    One level of the whole tree is a scene: the rows that its boxes name, file by file. An "environment" (the
//         sky) is a SOG of its own that belongs to every level.
// Rule    Files and their rows are named once, so a small tree cannot name a large scene many times.
// Errors  InputError with the node of the tree; --lod beyond the levels.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "scenes/formats/format.hpp"
#include "scenes/input_error.hpp"
#include "scenes/packed/unpack.hpp"
#include "scenes/text/json_node.hpp"

namespace pipegs {
namespace {

struct Rows {
  std::uint64_t offset, count;
};
using FileRows = std::map<std::uint64_t, std::vector<Rows>>;  // by the index of the file

void collect(const JsonNode& node, const std::string& level, std::uint64_t files, FileRows& found) {
  if (node.has("lods") && node["lods"].has(level.c_str())) {
    const JsonNode rows = node["lods"][level.c_str()];
    found[rows["file"].integer(0, files - 1)].push_back(
        {rows["offset"].integer(0, UINT32_MAX), rows["count"].integer(0, UINT32_MAX)});
  }
  if (!node.has("children")) return;
  const JsonNode children = node["children"];
  for (std::size_t i = 0; i < children.size(); ++i) collect(children[i], level, files, found);
}

Scene read_part(const InputFile& meta, const std::string& name, SceneFormat& format, SogBytes& bytes) {
  const InputFile file = meta.beside(name);
  return read_sog(file.starts_with("PK") ? unpack_zip(file, "meta.json") : file, format, bytes);
}

}  // namespace

Scene read_streamed_sog(const InputFile& meta, int lod, SceneFormat& format) {
  const JsonNode json = JsonNode::parse(meta.name(), meta.text());
  const JsonNode names = json["filenames"];
  if (names.size() == 0) names.refuse("a file at least");
  std::set<std::filesystem::path> different;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!different.insert(std::filesystem::path(names[i].text()).lexically_normal()).second)
      names[i].refuse("each file once");
  }
  const std::uint64_t levels = json["lodLevels"].integer(1, 64);
  if (static_cast<std::uint64_t>(lod) >= levels)
    throw InputError(meta.name(), "--lod", fmt::format("found {}, expected 0 to {}", lod, levels - 1));
  FileRows found;
  collect(json["tree"], std::to_string(lod), names.size(), found);
  std::vector<std::pair<Scene, std::vector<Rows>>> parts;
  SogBytes bytes;
  for (auto& [index, rows] : found) {
    const JsonNode name = names[static_cast<std::size_t>(index)];
    Scene part = read_part(meta, name.text(), format, bytes);
    std::sort(rows.begin(), rows.end(), [](const Rows& a, const Rows& b) { return a.offset < b.offset; });
    std::uint64_t free = 0;
    for (const Rows& row : rows) {
      if (row.offset < free || row.offset + row.count > part.gaussians.size()) {
        name.refuse(fmt::format("rows {} to {} of it to lie within its {} and to be named once", row.offset,
                                row.offset + row.count, part.gaussians.size()));
      }
      free = row.offset + row.count;
    }
    parts.emplace_back(std::move(part), rows);
  }
  if (json.has("environment") && !json["environment"].is_null()) {
    Scene part = read_part(meta, json["environment"].text(), format, bytes);
    const std::uint64_t count = part.gaussians.size();
    parts.emplace_back(std::move(part), std::vector<Rows>{{0, count}});
  }
  Scene scene;
  for (const auto& [part, rows] : parts) {
    scene.sh_degree = std::max(scene.sh_degree, part.sh_degree);
    scene.antialiased |= part.antialiased;
  }
  for (auto& [part, rows] : parts) {
    for (const Rows& row : rows) append(scene, part, row.offset, row.count);
    part = Scene{};
  }
  format.levels = static_cast<int>(levels);
  format.name = fmt::format("streamed {}, level of detail {} of 0 to {}", format.name, lod, levels - 1);
  return scene;
}

}  // namespace pipegs
