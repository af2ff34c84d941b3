// SPDX-License-Identifier: Apache-2.0
// info: what is in a scene, in numbers, and what in it looks wrong.
//
// Idea    Statistics are taken over the Gaussians that activate() accepts; what looks wrong is in the findings.
// Use     to_text for people, to_json for programs; both hold the same numbers.
// Terms   anisotropy = largest / smallest scale of a Gaussian;  extent = diagonal of the 2..98
//         percentile box (a trained scene has a few Gaussians thousands of units away).
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scenes/check/finding.hpp"
#include "scenes/formats/format.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

inline constexpr std::array<int, 7> kPercentiles = {0, 2, 25, 50, 75, 98, 100};
using Percentiles = std::array<double, kPercentiles.size()>;

struct SceneInfo {
  std::string name;
  SceneFormat format;  // of the file; without a name when there is none
  std::size_t gaussians = 0, usable = 0;
  int sh_degree = 0;
  bool antialiased = false;
  glm::dvec3 lowest{0}, highest{0};              // of the means
  glm::dvec3 box_lowest{0}, box_highest{0};      // 2..98 percentile, per axis
  Percentiles scale{}, opacity{}, anisotropy{};  // scale: the largest of each Gaussian
  double faint_share = 0;                        // opacity below 1/255: never drawn
  Findings findings;
};

// `findings` are those of the file and of check_scene().
SceneInfo inspect(const Scene& scene, const Findings& findings = {});
std::string to_text(const SceneInfo& info);
std::string to_json(const SceneInfo& info);

}  // namespace pipegs
