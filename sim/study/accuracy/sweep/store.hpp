// SPDX-License-Identifier: Apache-2.0
// store.hpp: measured points in a folder, so that a sweep can be stopped and taken up again: see
// sim/study/measurement_store.hpp.
#pragma once

#include <filesystem>
#include <optional>

#include "sim/study/accuracy/accuracy_json.hpp"
#include "sim/study/measurement_store.hpp"

namespace pipegs {

class AccuracyStore {
 public:
  AccuracyStore(const std::filesystem::path& folder, const Scene& scene, const Camera& camera,
                const SimulateOptions& options)
      : store_(folder, scene, camera, options) {}

  std::optional<Accuracy> load(const Config& config) const;
  void save(const Config& config, const Accuracy& accuracy) const { store_.save(config, to_json(accuracy)); }
  std::filesystem::path path(const Config& config) const { return store_.path(config); }

 private:
  MeasurementStore store_;
};

}  // namespace pipegs
