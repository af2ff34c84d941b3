// SPDX-License-Identifier: Apache-2.0
// measure.cpp: see measure.hpp.
#include "sim/studies/shapes/measure.hpp"

#include <map>
#include <mutex>
#include <stdexcept>

#include "cpp_model/float/parallel.hpp"
#include "scenes/text/json.hpp"
#include "sim/progress.hpp"
#include "sim/timing/trace/trace.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

EngineResult frame_from_json(const Json& json) {
  EngineResult frame;
  frame.cycles = json_integer<uint64_t>(json.at("cycles"), 1);
  frame.bytes = json_integer<uint64_t>(json.at("bytes"));
  return frame;
}

}  // namespace

MeasureShapes measure_shapes(const Scene& scene, const Camera& camera, const SimulateOptions& options,
                             const MeasurementStore& store) {
  const CycleEngine engine = model_engine(scene, camera, options);
  return [&store, engine, memory = options.memory](const std::vector<Config>& configs) {
    std::vector<EngineResult> frames(configs.size());
    std::map<std::string, std::vector<size_t>> missing;  // by trace
    size_t count = 0, done = 0;
    for (size_t i = 0; i < configs.size(); ++i) {
      if (const std::optional<EngineResult> kept = store.load(configs[i], frame_from_json)) {
        frames[i] = *kept;
        continue;
      }
      missing[config_difference(timing_config(configs[i]))].push_back(i);
      ++count;
    }
    Progress progress("shapes");
    std::mutex mutex;
    for (const auto& [trace, places] : missing) {
      parallel_for(places.size(), 0, [&, &places = places](size_t k) {
        if (interrupted()) throw std::runtime_error("interrupted");
        const Config& config = configs[places[k]];
        EngineResult& frame = frames[places[k]];
        frame = engine(config, memory);
        store.save(config, {{"cycles", frame.cycles}, {"bytes", frame.bytes}});
        const std::lock_guard lock(mutex);
        progress.update(static_cast<double>(++done) / static_cast<double>(count));
      });
    }
    return frames;
  };
}

}  // namespace pipegs
