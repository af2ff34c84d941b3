// store.hpp: measured points in a folder, so that a sweep can be stopped and taken up again: see sim/measurement_store.hpp.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "sim/accuracy/view.hpp"
#include "sim/measurement_store.hpp"

namespace pipegs {

nlohmann::ordered_json to_json(const Accuracy& accuracy);
Accuracy accuracy_from_json(const nlohmann::ordered_json& json);  // throws nlohmann::json::exception

class AccuracyStore {
 public:
  AccuracyStore(const std::filesystem::path& folder, const Scene& scene, const Camera& camera, const SimulateOptions& options)
      : store_(folder, scene, camera, options) {}

  std::optional<Accuracy> load(const Config& config) const;
  void save(const Config& config, const Accuracy& accuracy) const { store_.save(config, to_json(accuracy)); }
  std::filesystem::path path(const Config& config) const { return store_.path(config); }

 private:
  MeasurementStore store_;
};

}  // namespace pipegs
