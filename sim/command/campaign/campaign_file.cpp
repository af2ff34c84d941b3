// SPDX-License-Identifier: Apache-2.0
// campaign_file.cpp: see campaign_file.hpp.
#include "sim/command/campaign/campaign_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>

#include "scenes/formats/axes.hpp"
#include "scenes/input_error.hpp"
#include "scenes/text/json.hpp"
#include "scenes/text/json_node.hpp"
#include "scenes/text/text_file.hpp"
#include "sim/command/picture_size.hpp"
#include "sim/memory/dram_memory.hpp"

namespace pipegs {
namespace {

constexpr std::size_t kMostElements = 1000, kMostPoints = 100000;
constexpr int kMostViews = 100000;

using Fields = std::vector<std::string>;

void check_fields(const JsonNode& node, const Fields& known) {
  for (const std::string& key : node.keys()) {
    if (std::find(known.begin(), known.end(), key) == known.end())
      node[key.c_str()].refuse(fmt::format("one of the fields {}", fmt::join(known, ", ")));
  }
}

// The elements of a list that is there and has some, not too many.
std::vector<JsonNode> elements_of(const JsonNode& list) {
  if (list.size() == 0 || list.size() > kMostElements) list.refuse(fmt::format("1 to {} elements", kMostElements));
  std::vector<JsonNode> elements;
  for (std::size_t i = 0; i < list.size(); ++i) elements.push_back(list[i]);
  return elements;
}

// Names stand in tables and name files.
std::string name_of(const JsonNode& node, std::set<std::string>& names) {
  const std::string name = node.text();
  const bool plain = !name.empty() && name.size() <= 60 && name[0] != '.' &&
                     std::all_of(name.begin(), name.end(), [](unsigned char c) {
                       return (c < 0x80 && std::isalnum(c)) || c == '_' || c == '-' || c == '.';
                     });
  if (!plain) node.refuse("a name of up to 60 letters, digits, '_', '-' and '.'");
  if (!names.insert(name).second) node.refuse("each name once");
  return name;
}

std::string one_of(const JsonNode& node, const std::vector<std::string>& known) {
  const std::string text = node.text();
  if (std::find(known.begin(), known.end(), text) == known.end())
    node.refuse(fmt::format("one of {}", fmt::join(known, ", ")));
  return text;
}

// A file that is there.
std::string path_of(const JsonNode& node, const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / node.text();
  std::error_code ignored;
  if (!is_one_line(path.string())) node.refuse("a path of one line, without control characters");
  if (node.text().empty() || !std::filesystem::exists(path, ignored)) node.refuse("a file that is there");
  return path.string();
}

// What throws ConfigError becomes an error of this place.
template <class Work>
void at(const JsonNode& node, const Work& work) {
  std::optional<std::string> wrong;
  try {
    work();
  } catch (const ConfigError& error) { wrong = error.what(); }
  if (wrong) node.refuse("what is allowed there: " + *wrong);
}

struct NamedScene {
  std::string name;
  ViewArguments view;
  std::vector<int> views;
};

NamedScene read_scene_entry(const JsonNode& node, const std::filesystem::path& folder, std::set<std::string>& names) {
  check_fields(node, {"name", "scene", "axes", "lod", "cameras", "size", "orbit", "views"});
  NamedScene scene{.name = name_of(node["name"], names), .view = {}, .views = {}};
  ViewArguments& view = scene.view;
  if (node.has("scene")) view.scene.file = path_of(node["scene"], folder);
  if (node.has("lod")) view.scene.read.lod = static_cast<int>(node["lod"].integer(0, 63));
  if (node.has("axes")) {
    view.scene.read.axes = node["axes"].text();
    if (!are_axes(view.scene.read.axes)) node["axes"].refuse("R or L, U or D, F or B, such as RDF or RUB");
  }
  if (node.has("cameras")) view.cameras.file = path_of(node["cameras"], folder);
  if (node.has("size")) {
    view.cameras.size = node["size"].text();
    if (view.cameras.size.empty()) node["size"].refuse("WxH, such as 160x120");
    at(node["size"], [&] { picture_size("size", view.cameras.size); });
  }
  if (node.has("orbit")) {
    if (node.has("cameras")) node["orbit"].refuse("cameras or an orbit, not both");
    view.cameras.orbit = static_cast<int>(node["orbit"].integer(1, kMostViews));
  }
  if (!node.has("views")) {
    scene.views = {0};
    return scene;
  }
  for (const JsonNode& one : elements_of(node["views"])) {
    const int index = static_cast<int>(one.integer(0, kMostViews - 1));
    if (std::find(scene.views.begin(), scene.views.end(), index) != scene.views.end()) one.refuse("each view once");
    scene.views.push_back(index);
  }
  return scene;
}

struct NamedSettings {
  std::string name;
  std::vector<std::string> settings;
};

std::vector<NamedSettings> read_configurations(const JsonNode& campaign) {
  if (!campaign.has("configurations")) return {{"default", {}}};
  std::vector<NamedSettings> configurations;
  std::set<std::string> names;
  for (const JsonNode& node : elements_of(campaign["configurations"])) {
    check_fields(node, {"name", "set"});
    NamedSettings& one = configurations.emplace_back(NamedSettings{name_of(node["name"], names), {}});
    if (!node.has("set")) continue;
    for (const JsonNode& setting : elements_of(node["set"])) one.settings.push_back(setting.text());
  }
  return configurations;
}

std::vector<std::string> read_designs(const JsonNode& campaign) {
  std::vector<std::string> designs;
  if (!campaign.has("designs")) return {std::string(kDefaultDesignPoint)};
  std::set<std::string> names;
  for (const JsonNode& node : elements_of(campaign["designs"])) {
    designs.push_back(name_of(node, names));
    at(node, [&] { find_design_point(designs.back()); });
  }
  return designs;
}

// What all points share.
PointArguments read_shared(const JsonNode& campaign, const std::filesystem::path& keep) {
  PointArguments shared;
  shared.keep = keep.string();
  if (campaign.has("engine")) shared.engine = one_of(campaign["engine"], kPointEngines);
  if (campaign.has("truth")) shared.truth = campaign["truth"].boolean();
  if (shared.truth && shared.engine == "model")
    campaign["truth"].refuse("false with the engine model, which makes no pixels");
  std::vector<std::string> memories = dram_memory_names();
  memories.emplace_back("ideal");
  shared.memory.external.dram = campaign.has("memory") ? one_of(campaign["memory"], memories) : "lpddr5-6400x4";
  shared.memory.external.jitter = 20;
  if (campaign.has("seed")) shared.memory.seed = campaign["seed"].integer(0, uint64_t{1} << 53);
  return shared;
}

}  // namespace

std::vector<CampaignPoint> read_campaign(const std::filesystem::path& path, const std::filesystem::path& keep) {
  const JsonNode file = JsonNode::parse(path.string(), read_text_file(path, "a campaign file", kMostJsonBytes));
  check_fields(file, {"scenes", "designs", "configurations", "engine", "truth", "memory", "seed"});
  const PointArguments shared = read_shared(file, keep);
  std::vector<CampaignPoint> points;
  std::vector<NamedScene> scenes;
  std::set<std::string> names;
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  for (const JsonNode& node : elements_of(file["scenes"])) scenes.push_back(read_scene_entry(node, folder, names));
  const std::vector<NamedSettings> configurations = read_configurations(file);
  const std::vector<std::string> designs = read_designs(file);
  std::size_t views = 0;
  for (const NamedScene& scene : scenes) views += scene.views.size();
  if (views * configurations.size() * designs.size() > kMostPoints) {
    throw InputError(path.string(), "",
                     fmt::format("found {} views x {} configurations x {} design points, expected at most {} points",
                                 views, configurations.size(), designs.size(), kMostPoints));
  }
  for (const NamedScene& scene : scenes) {
    for (const int view : scene.views) {
      for (std::size_t c = 0; c < configurations.size(); ++c) {
        for (const std::string& design : designs) {
          CampaignPoint point{scene.name, configurations[c].name, shared};
          point.arguments.view = scene.view;
          point.arguments.view.view = view;
          point.arguments.view.design_point = design;
          point.arguments.view.settings = configurations[c].settings;
          if (configurations[c].settings.empty()) point.arguments.options();
          else at(file["configurations"][c]["set"], [&] { point.arguments.options(); });
          point.arguments.line();  // refuses what no line can hold
          points.push_back(std::move(point));
        }
      }
    }
  }
  return points;
}

}  // namespace pipegs
