// SPDX-License-Identifier: Apache-2.0
// generate: our own scene, made of formulas, so that the project runs without any download.
//
// Idea    A still life in a landscape: a spined seashell tower and glossy spheres on pebbles, a
//         flowering meadow, mountains, clouds. Each Gaussian is coloured as training would: its SH
//         are fitted to the radiance seen from a ring of cameras, reflections included.
// Stats   Like a trained scene: SH degree 3, log-normal scales, anisotropy 1..100, many faint
//         Gaussians, needles, haze, near and far, background out to thousands of units.
// Split   A scene of many more Gaussians that shows about the same picture, as a scan has them: as the densification of
//         3DGS splits one, the means of the parts are drawn from the Gaussian itself. One of k parts has its parent's
//         scales / sqrt(k), so that the parts cover the area that their parent covers, seen from anywhere; rotation,
//         opacity and colour are the parent's. Part c is one of Gaussian c mod n: neighbours in the file are none in
//         space, as after training.
// Same    seed and count give the same scene on every machine: own generator, no std distribution,
//         stored values rounded to a grid coarser than the libraries' differences.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scenes/camera.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

inline constexpr std::size_t kGeneratedCount = 60000;

Scene generate_scene(std::uint64_t seed, std::size_t count = kGeneratedCount);

// Three views of it, 1024x768, 60 degrees wide.
std::vector<Camera> generated_cameras();

// `count` is at least the number of Gaussians of the scene, which holds at least one. A Gaussian that activate() culls
// is copied. `sh_degree` caps the degree of the colours. Throws std::invalid_argument.
Scene split_scene(const Scene& scene, std::size_t count, int sh_degree, std::uint64_t seed);

}  // namespace pipegs
