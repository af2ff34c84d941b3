// SPDX-License-Identifier: Apache-2.0
// generate_split: a scene of many more Gaussians that shows about the same picture, as a scan has them.
//
// Idea    As the densification of 3DGS splits a Gaussian: the means of its parts are drawn from the Gaussian itself.
//         One of k parts has its parent's scales / sqrt(k), so that the parts together cover the area that their
//         parent covers, seen from anywhere. Rotation, opacity and colour are the parent's.
// Order   Part c of the scene is one of Gaussian c mod n: neighbours in the file are none in space, as after training.
// Same    seed and count give the same scene; each part has random numbers of its own.
#pragma once

#include <cstddef>
#include <cstdint>

#include "scenes/scene.hpp"

namespace pipegs {

// `count` is at least the number of Gaussians of the scene, which holds at least one. A Gaussian that activate() culls
// is copied. `sh_degree` caps the degree of the colours. Throws std::invalid_argument.
Scene split_scene(const Scene& scene, std::size_t count, int sh_degree, std::uint64_t seed);

}  // namespace pipegs
