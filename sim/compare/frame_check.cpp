// SPDX-License-Identifier: Apache-2.0
// frame_check.cpp: see frame_check.hpp.
#include "sim/compare/frame_check.hpp"

#include <fmt/format.h>

namespace pipegs {

Findings check_packed(const PackedScene& packed) {
  if (packed.counts.out_of_range == 0) return {};
  return {{"left_out", fmt::format("{} of {} Gaussians lie beyond the range of the machine's numbers and are left out: "
                                   "another unit or origin of scene and cameras",
                                   packed.counts.out_of_range, packed.scene_gaussians)}};
}

Findings check_frame(const Simulation& simulation, const SimulateOptions& options) {
  const Work& work = simulation.golden.work;
  if (work.blended > 0 || options.window || options.crop) return {};
  const PackedScene& packed = *simulation.input.packed;
  std::string why;
  if (work.fetched == 0) why = "nothing was fetched";
  else if (work.visible == 0)
    why = fmt::format("all {} that were fetched were culled, before the near plane of {:g} or beside the picture",
                      work.fetched, options.near_plane);
  else
    why = fmt::format("of {} that were fetched {} were visible and none changed a pixel", work.fetched, work.visible);
  return {{"empty_frame", fmt::format("the frame is empty: {}; {} of {} Gaussians are in the memory image", why,
                                      packed.counts.packed, packed.scene_gaussians)}};
}

}  // namespace pipegs
