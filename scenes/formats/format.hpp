// SPDX-License-Identifier: Apache-2.0
// format: what the readers of scene files share: options, what they say about a file, and the values of a Scene.
//
// Idea    Every format is another packing of INRIA's values, so a reader ends in the same five: mean, log of the scale,
//         quaternion w x y z, logit of the opacity, SH coefficients. What a packing has cost stands in SceneFormat, as
//         the file itself shows it, for `pipegs info`.
// Rule    A byte for the opacity may be 0 or 255, a linear scale may be 0. Their logit and log are kept finite, so that
//         a .ply made of them holds no infinity: at these bounds float32 activates to exactly 1, below 1/255, and flat.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "scenes/check/finding.hpp"
#include "scenes/free_memory.hpp"
#include "scenes/packed/input_file.hpp"
#include "scenes/scene.hpp"
#include "scenes/sh_basis.hpp"

namespace pipegs {

struct ReadOptions {
  int lod = 0;       // of a streamed SOG; 0 is the finest level
  std::string axes;  // in which the file is, such as RUB (axes.hpp); empty: as the format or the file says
};

struct SceneFormat {
  std::string name;                                         // "spz version 3"
  std::string axes;                                         // in which the file is; empty: nothing says it
  std::vector<std::pair<std::string, std::string>> fields;  // "position", "24 bits, steps of 1/4096"
  Findings findings;                                        // what was mended or left out
  int levels = 1;                                           // of detail
  glm::dvec3 origin{0};                                     // what was subtracted from the positions (origin.hpp)
};

// Each reads the whole file, whose format its content has shown.
Scene read_compressed_ply(class PlySource& source, const struct PlyHeader& header, SceneFormat& format);
Scene read_splat(const InputFile& file, SceneFormat& format);
Scene read_ksplat(const InputFile& file, SceneFormat& format);
Scene read_spz(const InputFile& file, SceneFormat& format);
Scene read_sog(const InputFile& meta, SceneFormat& format);
// What the parts of a streamed one take together, and what they are packed in.
struct SogBytes {
  PackedBytes packed;
  std::uint64_t unpacked = 0;
  bool lossy = false;  // is said
};
Scene read_sog(const InputFile& meta, SceneFormat& format, SogBytes& bytes);
Scene read_streamed_sog(const InputFile& meta, int lod, SceneFormat& format);
Scene read_gltf(const InputFile& file, SceneFormat& format);
Scene read_xyzs(const InputFile& file, SceneFormat& format);

// Signatures of the two that have none: whether all that can be checked of the file is as theirs.
bool looks_like_splat(const InputFile& file);
bool looks_like_ksplat(const InputFile& file);

inline constexpr double kLargestLogit = 20;

inline float logit_of(double alpha) {
  return static_cast<float>(std::clamp(std::log(alpha / (1 - alpha)), -kLargestLogit, kLargestLogit));
}
inline float log_of(double scale) {
  return narrow(std::log(scale == 0 ? std::numeric_limits<float>::min() : scale));  // NaN below 0: culled
}
// The constant coefficient of a colour from 0 to 1.
inline float dc_of(double color) { return static_cast<float>((color - 0.5) / kShConstant); }

// What follows the last Gaussian.
inline void tell_behind(std::uint64_t bytes, SceneFormat& format) {
  if (bytes > 0)
    format.findings.emplace_back(
        "behind_end", "found " + std::to_string(bytes) + " bytes behind the last Gaussian, which are left out");
}

// Whether a form holds for a scene that its format does not mean: few such Gaussians are no form, but errors.
template <typename Odd>
bool are_many(const Scene& scene, Odd&& odd) {
  constexpr std::ptrdiff_t kOneOf = 20;
  const auto all = static_cast<std::ptrdiff_t>(scene.gaussians.size());
  return all > 0 && kOneOf * std::count_if(scene.gaussians.begin(), scene.gaussians.end(), odd) >= all;
}

// Scales of a format that means them linear, as they are stored: their logarithms. A file in which many are negative
// holds logarithms already, as writers of drafts did; single ones are culled.
inline void take_linear_scales(Scene& scene, SceneFormat& format) {
  const auto negative = [](const Gaussian& g) { return g.log_scale.x < 0 || g.log_scale.y < 0 || g.log_scale.z < 0; };
  if (are_many(scene, negative)) {
    format.findings.emplace_back("log_scales",
                                 "scales are negative where the format means them linear: they are taken "
                                 "as logarithms");
    return;
  }
  for (Gaussian& g : scene.gaussians) {
    for (int k = 0; k < 3; ++k) g.log_scale[k] = log_of(g.log_scale[k]);
  }
}

// InputError where it does not fit into the memory.
inline Scene scene_of_size(std::size_t count, int sh_degree) {
  check_scene_memory(count, sh_degree);
  Scene scene;
  scene.sh_degree = sh_degree;
  scene.gaussians.resize(count);
  scene.sh_rest.resize(count * 3 * static_cast<std::size_t>(sh_rest_count(sh_degree)));
  return scene;
}

// Rows of a scene behind those of another, whose SH degree is no lower.
inline void append(Scene& scene, const Scene& part, std::uint64_t first, std::uint64_t count) {
  const auto to = static_cast<std::size_t>(3 * sh_rest_count(scene.sh_degree)),
             from = static_cast<std::size_t>(3 * sh_rest_count(part.sh_degree));
  for (std::uint64_t i = first; i < first + count; ++i) {
    scene.gaussians.push_back(part.gaussians[i]);
    const auto rest = part.sh_rest.begin() + static_cast<std::ptrdiff_t>(from * i);
    scene.sh_rest.insert(scene.sh_rest.end(), rest, rest + static_cast<std::ptrdiff_t>(from));
    scene.sh_rest.resize(scene.gaussians.size() * to);
  }
}

}  // namespace pipegs
