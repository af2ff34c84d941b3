// store.hpp: measured points in a folder, one JSON file each, so that a sweep can be stopped and taken up again.
//
// Idea    A file holds what it was measured of (the key: scene, camera, memory, every entry of the configuration, the
//         sources of the models) beside what was measured. One that is broken or of another key is as good as none.
// Rule    A file appears when it is complete, never before.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "sim/accuracy/view.hpp"

namespace pipegs {

nlohmann::ordered_json to_json(const Accuracy& accuracy);
Accuracy accuracy_from_json(const nlohmann::ordered_json& json);  // throws nlohmann::json::exception

class AccuracyStore {
 public:
  // Without a folder nothing is kept.
  AccuracyStore(std::filesystem::path folder, const Scene& scene, const Camera& camera, const SimulateOptions& options);

  std::optional<Accuracy> load(const Config& config) const;
  void save(const Config& config, const Accuracy& accuracy) const;  // any thread; InputError when it cannot be written
  std::filesystem::path path(const Config& config) const;

 private:
  nlohmann::ordered_json key(const Config& config) const;

  std::filesystem::path folder_;
  nlohmann::ordered_json view_;  // the key's part that all points share
};

}  // namespace pipegs
