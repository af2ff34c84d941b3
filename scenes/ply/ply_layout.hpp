// SPDX-License-Identifier: Apache-2.0
// ply_layout: what the properties of a .ply mean: which value of a Gaussian each holds, under INRIA's names or others.
//
// Idea    A Gaussian is one row of floats; each property has a place in it. Colours may be red, green, blue instead of
//         f_dc, and then their type says their range: floats to 1, 16 bits to 65535, others to 255, unless one is
//         much larger; so may an opacity.
// Rule    A property that is not read is said, unless every program leaves it out: normals, colours beside f_dc, if
//         these are not all 0.
// Errors  InputError that says what the file is: a point cloud, a mesh, anchors of Scaffold-GS, or what is missing.
#pragma once

#include <string>
#include <vector>

#include "scenes/formats/format.hpp"
#include "scenes/ply/ply_file.hpp"

namespace pipegs {

// Places in a row; kRest: 3 values for each coefficient that is kept.
enum PlySlot {
  kSlotX = 0,
  kSlotDc = 3,
  kSlotOpacity = 6,
  kSlotScale = 7,
  kSlotRotation = 10,
  kSlotFilter = 14,
  kSlotColor = 15,  // of a file that has coefficients too
  kSlotRest = 18
};

struct PlyLayout {
  std::vector<int> slots;  // of each property; kSkip, kWide - axis for a position of more than 32 bits
  int sh_degree = 0;       // that is kept
  int scales = 3;          // 1: a ball, 2: flat, as 2DGS is
  double color_range = 0;  // above 0: colours instead of coefficients, of which this is the largest, or the next
  std::vector<std::string> colors;  // their names
  bool beside = false;              // they are meant only if all coefficients are 0
  double opacity_range = 0;         // above 0: opacities from 0 to this instead of logits
  bool wide = false;                // positions of more than 32 bits
  bool rotated = true;              // has a rotation
  bool filtered = false;            // has filter_3D of Mip-Splatting
};

PlyLayout ply_layout(const std::string& file, const PlyHeader& header, const PlyElement& vertex, SceneFormat& format);

}  // namespace pipegs
