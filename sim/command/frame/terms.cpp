// SPDX-License-Identifier: Apache-2.0
// terms.cpp: see terms.hpp.
#include "sim/command/frame/terms.hpp"

#include <fmt/format.h>

#include "sim/progress.hpp"
#include "sim/study/terms/report.hpp"

namespace pipegs {

int ladder_terms(const ViewArguments& view, const MemoryArguments& memory, bool json) {
  const SimulateOptions options = view.options();
  if (options.window) throw ConfigError("--window: --terms counts the whole view, expected none");
  if (memory.external.dram == "ideal") throw ConfigError("--memory: found ideal, --terms expects a DRAM");
  const LoadedView loaded = load_view(view);
  check_picture_memory(loaded.camera, options, kCountPixels);
  Progress progress("counting");
  CountOptions counted{.near_plane = view.near_plane, .grids = {4, 8}};
  counted.progress = [&](double share) { progress.update(share); };
  const TermsView work = terms_view(count_frame(loaded.scene, loaded.camera, counted));
  const TermsReport report = terms_report(work, memory_rates(work, memory.external.dram, 1.0));
  if (json) {
    nlohmann::ordered_json all = {{"scene", loaded.scene.name}, {"camera", loaded.camera.name}};
    all.update(terms_json(report));
    fmt::print("{}\n", all.dump(2));
  } else {
    fmt::print("{}: {} Gaussians; view {} ({}x{}); the paper's ladder by counts of the view\n\n{}", loaded.scene.name,
               loaded.scene.gaussians.size(), loaded.camera.name, loaded.camera.width, loaded.camera.height,
               terms_text(report));
  }
  return kExitOk;
}

}  // namespace pipegs
