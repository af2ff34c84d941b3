// SPDX-License-Identifier: Apache-2.0
// point.hpp: one point of a campaign: one view on one machine, measured once and kept.
//
// Key     MeasurementStore's (contents of the scene, camera, walk_most, memory, every entry of the configuration,
//         sources of the models), the bytes of this program, engine, truth, seed; with the RTL its sources.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/command/command.hpp"
#include "sim/report/measurement_store.hpp"

namespace pipegs {

// Who measures: the timing model (no pixels), the golden model (no cycles), or the RTL, compared with it bit for bit.
inline const std::vector<std::string> kPointEngines = {"model", "golden", "rtl"};

struct PointArguments {
  ViewArguments view;
  MemoryArguments memory;
  std::string engine = "model", keep;
  bool truth = false;

  void add(CLI::App& app);
  SimulateOptions options() const;  // throws ConfigError
  // The command that measures this point, from any folder: paths are absolute.
  std::string line() const;
};

// Where points of this view are kept, as measured by `engine`.
MeasurementStore point_store(const PointArguments& point, const Scene& scene, const Camera& camera);

// The configuration of the point on the scene of this view.
SimulateOptions point_options(const PointArguments& point, const LoadedView& loaded);

// {"result": what was measured, the same wherever it is; "cost": seconds and bytes of the computer}. Nothing when a
// part of it is not there as it was kept.
std::optional<nlohmann::ordered_json> kept_point(const MeasurementStore& store, const Config& config);

}  // namespace pipegs
