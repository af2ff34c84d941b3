// SPDX-License-Identifier: Apache-2.0
// measurement_store.cpp: see measurement_store.hpp.
#include "sim/report/measurement_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "scenes/atomic_file.hpp"
#include "scenes/input_error.hpp"
#include "scenes/text/json.hpp"
#include "scenes/text/text_file.hpp"
#include "sim/measured_by.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

// FNV-1a.
class Hash {
 public:
  void add(const void* data, size_t bytes) {
    for (size_t i = 0; i < bytes; ++i) hash_ = (hash_ ^ static_cast<const unsigned char*>(data)[i]) * 0x100000001b3ull;
  }
  std::string text() const { return fmt::format("{:016x}", hash_); }

 private:
  uint64_t hash_ = 0xcbf29ce484222325ull;
};

std::string contents(const Scene& scene) {
  Hash hash;
  hash.add(scene.gaussians.data(), scene.gaussians.size() * sizeof(Gaussian));
  hash.add(scene.sh_rest.data(), scene.sh_rest.size() * sizeof(float));
  hash.add(&scene.antialiased, sizeof scene.antialiased);
  return hash.text();
}

std::vector<double> pose_of(const Camera& camera) {
  std::vector<double> pose = {camera.position.x, camera.position.y, camera.position.z, camera.fx,
                              camera.fy,         camera.cx,         camera.cy};
  if (camera.of_width != 0) pose.insert(pose.end(), {camera.tan_x(), camera.tan_y()});
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) pose.push_back(camera.world_to_camera[i][k]);
  }
  return pose;
}

}  // namespace

MeasurementStore::MeasurementStore(std::filesystem::path folder, const Scene& scene, const Camera& camera,
                                   const SimulateOptions& options, const Json& more)
    : folder_(std::move(folder)) {
  const ExternalMemoryOptions& m = options.memory;
  view_ = {
      {"measured_by", kMeasuredBy},  {"scene", valid_utf8(scene.name)},         {"gaussians", scene.gaussians.size()},
      {"contents", contents(scene)}, {"camera", {camera.width, camera.height}}, {"pose", pose_of(camera)},
      {"near", options.near_plane},  {"walk_most", options.walk_most},          {"memory", m.dram}};
  if (options.rest != 0) view_["rest"] = options.rest;
  if (options.lod_pixels != 0) view_["lod_pixels"] = options.lod_pixels;
  if (m.dram == "ideal") view_["ideal"] = {m.latency, m.bytes_per_cycle, m.jitter, m.seed};
  if (options.window) view_["window"] = *options.window;
  if (options.crop) view_["crop"] = {options.crop->x0, options.crop->y0, options.crop->x1, options.crop->y1};
  view_.update(more);
  if (!folder_.empty()) make_folders(folder_);
}

MeasurementStore MeasurementStore::with(const Json& more) const {
  MeasurementStore result = *this;
  result.view_.update(more);
  return result;
}

MeasurementStore MeasurementStore::of(const Camera& camera) const {
  return with({{"camera", {camera.width, camera.height}}, {"pose", pose_of(camera)}});
}

Json MeasurementStore::key(const Config& config) const {
  Json key = view_;
  for (const ConfigEntry& entry : config_entries(config)) {
    if (entry.member != nullptr) key["config"][std::string(entry.name)] = entry.value;
  }
  return key;
}

std::filesystem::path MeasurementStore::path(const Config& config) const {
  return folder_ / (config_difference(config).substr(0, 120) + "-" + hash_of_text(json_text(key(config))) + ".json");
}

std::optional<Json> MeasurementStore::measured(const Config& config) const {
  if (folder_.empty()) return std::nullopt;
  const std::filesystem::path file = path(config);
  if (!std::filesystem::exists(file)) return std::nullopt;
  require_regular_file(file, "a kept measurement");  // else it could not be written in the end
  try {
    const Json json = read_json<Json>(file, "a kept measurement");
    if (!json.is_object() || !json.contains("key") || json["key"] != key(config) || !json.contains("measured"))
      return std::nullopt;
    return json["measured"];
  } catch (const InputError&) { return std::nullopt; }
}

void MeasurementStore::save(const Config& config, const Json& measured) const {
  if (folder_.empty()) return;
  write_whole(path(config), json_text(Json{{"key", key(config)}, {"measured", measured}}, 1) + "\n");
}

std::string hash_of_text(const std::string& text) {
  Hash hash;
  hash.add(text.data(), text.size());
  return hash.text();
}

std::string hash_of_files(const std::filesystem::path& folder, const std::string& extension) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == extension) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  Hash hash;
  for (const std::filesystem::path& path : paths) {
    std::ifstream file(path, std::ios::binary);
    const std::string text =
        path.filename().string() + '\0' + std::string(std::istreambuf_iterator<char>(file), {}) + '\0';
    hash.add(text.data(), text.size());
  }
  return hash.text();
}

std::string measured_by() { return kMeasuredBy; }

}  // namespace pipegs
