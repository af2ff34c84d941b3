// SPDX-License-Identifier: Apache-2.0
// pixels.hpp: what the orders of other machines do to pixels: pictures against the one in exact depth order.
//
// Idea    STREAMINGGS on one view, for edges of voxels and sides of groups (streaming.hpp). GSAcc and Neo on a camera
//         that moves (path.hpp, frames.hpp): frames spread evenly over the path, each in the order that the frame
//         before leaves, at several speeds. Everything is blended in float64 at full resolution, nothing else differs.
// Speed   A step of 1x is 50/90 degrees: a head that turns at 50 degrees a second (S. LaValle, Virtual Reality, 7.4,
//         who has 300 for an extremely fast turn) before a display of 90 frames a second, which STREAMINGGS asks for.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scenes/camera.hpp"
#include "scenes/scene.hpp"
#include "sim/studies/rivals/pixels/difference.hpp"
#include "sim/studies/rivals/pixels/picture_counts.hpp"

namespace pipegs {

inline constexpr int kExtentParts[] = {16, 32, 64};  // edges of voxels as parts of the scene's extent
inline constexpr int kWarmFrames = 4;  // before each frame of Neo, from a full sort on; the last is the frame before

struct PixelOptions {
  double near_plane = 0.2;
  std::vector<double> voxels = {0.5, 1, 2, 4};  // edges, scene units
  std::vector<int> groups = {16, 64, 128};      // sides, pixels
  std::vector<double> speeds = {1, 2, 4, 8};
  double step = 50.0 / 90;  // degrees of the path from a frame to the next at 1x
  int frames = 4;           // of the path that are rendered
  double index_bytes = 8;   // of what STREAMINGGS fetches behind its coarse filter, a Gaussian
  unsigned threads = 0;
  std::function<void(double)> progress = {};
};

struct StreamRow {
  double edge = 0;         // of a voxel, scene units
  int part = 0, side = 0;  // extent / edge where the edge was chosen so, else 0; of a group, pixels
  uint64_t occupied = 0;   // voxels with a Gaussian
  Difference whole = {};   // against exact order of all Gaussians
  Difference order = {};   // against exact order of the Gaussians that groups have
  Difference lost = {};    // exact order of those against exact order of all
  OrderCounts blends = {};
  StreamCounts counts = {};
  double bytes = 0;
};

struct PathRow {
  std::string machine;  // gsacc_all, gsacc_seen, neo, neo_even (newcomers merged by last frame's depths)
  double speed = 0;
  Difference mean = {};
  double worst_db = 0;   // of a frame
  double late = 0;       // share of the blends
  double newcomers = 0;  // share of the Gaussians with a pixel to reach that touch no tile of the frame before
};

struct PixelStudy {
  double extent = 0;  // of the scene: longest side of the box of the means from the 1st to the 99th percentile
  std::vector<StreamRow> streams = {};
  bool arc = false;  // the path is one around a lone view
  int legs = 0;
  double degrees = 0;                       // length of the path
  double turn = 0, move = 0, parallax = 0;  // of a step at 1x: degrees of rotation, scene units, degrees of parallax
  std::vector<PathRow> paths = {};
};

// `cameras`: the views that the path goes through. Throws std::invalid_argument for options without meaning,
// std::runtime_error when interrupted.
PixelStudy study_pixels(const Scene& scene, const Camera& view, const std::vector<Camera>& cameras,
                        const PixelOptions& options);

}  // namespace pipegs
