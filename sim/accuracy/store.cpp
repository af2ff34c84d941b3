// store.cpp: see store.hpp.
#include "sim/accuracy/store.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "scenes/atomic_file.hpp"
#include "scenes/input_error.hpp"
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

// JSON has no infinity: equal images have a PSNR of null.
Json psnr_json(double psnr) { return std::isfinite(psnr) ? Json(psnr) : Json(nullptr); }
double psnr_from(const Json& json) { return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>(); }

Json to_json(const ErrorFigures& e) {
  return {{"psnr_db", psnr_json(e.psnr)}, {"ssim", std::isfinite(e.ssim) ? Json(e.ssim) : Json(nullptr)}, {"max", e.max}, {"p999", e.p999}};
}

ErrorFigures errors_from(const Json& json) {
  const Json& ssim = json.at("ssim");
  return {psnr_from(json.at("psnr_db")), ssim.is_null() ? std::nan("") : ssim.get<double>(), json.at("max").get<double>(), json.at("p999").get<double>()};
}

}  // namespace

Json to_json(const Accuracy& a) {
  if (!a.failure.empty()) return {{"failure", a.failure}};
  return {{"numeric", to_json(a.numeric)},
          {"order", to_json(a.order)},
          {"total", to_json(a.total)},
          {"decisions", a.flips.decisions},
          {"flipped", a.flips.flipped},
          {"cycles", a.cycles},
          {"bytes", a.bytes},
          {"buffer_bits", a.buffer_bits},
          {"seconds", {{"golden", a.seconds_golden}, {"truth", a.seconds_truth}, {"trace", a.seconds_trace}, {"model", a.seconds_model}}}};
}

Accuracy accuracy_from_json(const Json& json) {
  Accuracy a;
  if (json.contains("failure")) {
    a.failure = json.at("failure").get<std::string>();
    return a;
  }
  a.numeric = errors_from(json.at("numeric"));
  a.order = errors_from(json.at("order"));
  a.total = errors_from(json.at("total"));
  a.flips = {json.at("decisions").get<uint64_t>(), json.at("flipped").get<uint64_t>()};
  a.cycles = json.at("cycles").get<uint64_t>();
  a.bytes = json.at("bytes").get<uint64_t>();
  a.buffer_bits = json.at("buffer_bits").get<uint64_t>();
  const Json& seconds = json.at("seconds");
  a.seconds_golden = seconds.at("golden").get<double>();
  a.seconds_truth = seconds.at("truth").get<double>();
  a.seconds_trace = seconds.at("trace").get<double>();
  a.seconds_model = seconds.at("model").get<double>();
  return a;
}

AccuracyStore::AccuracyStore(std::filesystem::path folder, const Scene& scene, const Camera& camera, const SimulateOptions& options) : folder_(std::move(folder)) {
  std::vector<double> pose = {camera.position.x, camera.position.y, camera.position.z, camera.fx, camera.fy, camera.cx, camera.cy};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) pose.push_back(camera.world_to_camera[i][k]);
  }
  const ExternalMemoryOptions& m = options.memory;
  view_ = {{"measured_by", kMeasuredBy},
           {"scene", scene.name},
           {"gaussians", scene.gaussians.size()},
           {"contents", contents(scene)},
           {"camera", {camera.width, camera.height}},
           {"pose", pose},
           {"near", options.near_plane},
           {"memory", m.dram}};
  if (m.dram == "ideal") view_["ideal"] = {m.latency, m.bytes_per_cycle, m.jitter, m.seed};
  if (options.window) view_["window"] = {(*options.window)[0], (*options.window)[1], options.windows};
  if (!folder_.empty()) std::filesystem::create_directories(folder_);
}

Json AccuracyStore::key(const Config& config) const {
  Json key = view_;
  for (const ConfigEntry& entry : config_entries(config)) {
    if (entry.member != nullptr) key["config"][std::string(entry.name)] = entry.value;
  }
  return key;
}

std::filesystem::path AccuracyStore::path(const Config& config) const {
  const std::string text = key(config).dump();
  Hash hash;
  hash.add(text.data(), text.size());
  return folder_ / (config_difference(config).substr(0, 120) + "-" + hash.text() + ".json");
}

std::optional<Accuracy> AccuracyStore::load(const Config& config) const {
  if (folder_.empty()) return std::nullopt;
  std::ifstream file(path(config), std::ios::binary);
  const Json json = Json::parse(file, nullptr, false);
  if (!json.is_object() || !json.contains("key") || json["key"] != key(config)) return std::nullopt;
  try {
    return accuracy_from_json(json.at("measured"));
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

void AccuracyStore::save(const Config& config, const Accuracy& accuracy) const {
  if (folder_.empty()) return;
  AtomicFile file(path(config));
  std::ofstream out(file.temporary(), std::ios::binary);
  out << Json{{"key", key(config)}, {"measured", to_json(accuracy)}}.dump(1) << "\n";
  out.close();
  if (!out) throw InputError(path(config).string(), "", "cannot be written");
  file.commit();
}

}  // namespace pipegs
