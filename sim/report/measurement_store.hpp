// SPDX-License-Identifier: Apache-2.0
// measurement_store.hpp: what was measured of configurations of one view, one JSON file each, so that it is measured
// once.
//
// Idea    A file holds what it was measured of (the key: scene, camera, walk_most, memory, every entry of the
//         configuration, the sources of the models, and what else the measurement depends on) beside what was measured.
//         One that is broken (json.hpp's rules), of another key, or refused by who reads it (NumberError, a field that
//         is not there) is as good as none: its configuration is measured again.
// Rule    A file appears when it is complete, never before.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>

#include "scenes/text/number.hpp"
#include "sim/compare/simulate.hpp"

namespace pipegs {

class MeasurementStore {
 public:
  // Without a folder nothing is kept. `more` joins the key.
  MeasurementStore(std::filesystem::path folder, const Scene& scene, const Camera& camera,
                   const SimulateOptions& options,
                   const nlohmann::ordered_json& more = nlohmann::ordered_json::object());

  // The same folder and view; `more` joins the key, too.
  MeasurementStore with(const nlohmann::ordered_json& more) const;
  // The same folder and scene, seen by another camera.
  MeasurementStore of(const Camera& camera) const;

  // What `read` makes of the JSON that was saved.
  template <typename Read>
  auto load(const Config& config, const Read& read) const
      -> std::optional<std::invoke_result_t<Read, const nlohmann::ordered_json&>> {
    const std::optional<nlohmann::ordered_json> kept = measured(config);
    try {
      if (kept) return read(*kept);
    } catch (const NumberError&) {
    } catch (const nlohmann::json::exception&) {}
    return std::nullopt;
  }
  void save(const Config& config,
            const nlohmann::ordered_json& measured) const;  // any thread; OwnFailure when it cannot be written
  std::filesystem::path path(const Config& config) const;

 private:
  nlohmann::ordered_json key(const Config& config) const;
  std::optional<nlohmann::ordered_json> measured(const Config& config) const;

  std::filesystem::path folder_;
  nlohmann::ordered_json view_;  // the key's part that all configurations share
};

// A hash of a text.
std::string hash_of_text(const std::string& text);

// A hash of the contents of all files of a folder with this extension, and of their names.
std::string hash_of_files(const std::filesystem::path& folder, const std::string& extension);

// A hash of the sources of all that measures without the RTL.
std::string measured_by();

}  // namespace pipegs
