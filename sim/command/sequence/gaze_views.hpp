// SPDX-License-Identifier: Apache-2.0
// gaze_views.hpp: `pipegs sim --gaze X,Y,FULL,HALF`: pictures in parts, finer where the eye looks, and how good they
// are.
//
// Idea    A part is a frame of its own (cpp_model/gaze_parts.hpp); all parts of a view make one picture, gaze_0000.png,
//         smooth between samples. With --truth it is held against the float64 render of the whole view, in each of the
//         three rings: samples repeated, samples blended, and samples against the mean of the render's pixels in them,
//         which says how good they are for what they are: an eye sees no finer there.
// Rule    Ring 0 is the square around the gaze. Eccentricity: degrees from the gaze to a ring's inner edge, at the
//         camera's focal length.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cpp_model/gaze_parts.hpp"
#include "sim/command/sequence/frame_table.hpp"

namespace pipegs {

// The rows of all parts of these views, those of a view one behind the other.
std::vector<FrameRow> rows_of_parts(const std::vector<FrameRow>& views, const Gaze& gaze);

class GazeViews {
 public:
  // `folder`: of the pictures; none without one.
  GazeViews(const Scene& scene, const std::vector<FrameRow>& views, const Gaze& gaze, const SimulateOptions& options,
            const glm::dvec3& background, const std::string& folder, bool truth);
  // The picture of the next part, of two eyes side by side. With the last one of a view that view is done.
  void add(const Image& part);
  const std::vector<GazeView>& done() const { return done_; }

 private:
  GazeView finish(const Camera& whole, const std::vector<GazePart>& parts) const;

  const Scene& scene_;
  std::vector<Camera> views_;
  Gaze gaze_;
  SimulateOptions options_;
  glm::dvec3 background_;
  std::string folder_;
  bool truth_;
  std::vector<GazePart> parts_;  // of the view that is drawn
  std::vector<Image> images_;    // of its parts, so far
  std::vector<GazeView> done_;
};

}  // namespace pipegs
