// SPDX-License-Identifier: Apache-2.0
// path.hpp: a camera that moves through the views of a scene at a speed that is known.
//
// Idea    From each view to the next: rotation by slerp, position by a straight line, both even. A leg's length is the
//         larger of two angles, in degrees: its rotation, and its parallax, the distance that it moves over the median
//         view depth of the Gaussians whose mean its first view shows. So "a degree" moves the picture by about one.
//         One view alone: an arc of 30 degrees around the point at that depth in the middle of the picture, about the
//         camera's own vertical, the view in its middle.
// Rule    Views that do not differ make no leg. Before the first view and behind the last one the path goes on as it
//         begins and ends. Pictures have the size and focal length of the view that was asked for.
#pragma once

#include <vector>

#include "scenes/camera.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

class CameraPath {
 public:
  CameraPath(const Scene& scene, const Camera& view, const std::vector<Camera>& cameras, double near_plane);

  double length() const { return length_; }                    // degrees
  double rotation() const { return rotation_; }                // all that it rotates, degrees
  double distance() const { return distance_; }                // all that it moves, scene units
  double parallax() const { return parallax_; }                // of all that it moves, degrees
  int legs() const { return static_cast<int>(legs_.size()); }  // 1 for an arc
  bool arc() const { return arc_; }
  Camera at(double degrees) const;  // 0 to length(), and beyond

 private:
  struct Leg {
    Camera from, to;
    double begin, length;  // degrees
  };
  void add(const Camera& from, const Camera& to, double depth);

  Camera view_;
  std::vector<Leg> legs_;
  bool arc_ = false;
  double length_ = 0, rotation_ = 0, distance_ = 0, parallax_ = 0, pivot_ = 0;
};

// Median view depth of the Gaussians whose mean is in the picture and beyond the near plane; 1 where there is none.
double median_depth(const Scene& scene, const Camera& camera, double near_plane);

}  // namespace pipegs
