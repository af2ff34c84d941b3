// SPDX-License-Identifier: Apache-2.0
// generate: our own scene, made of formulas, so that the project runs without any download.
//
// Idea    A still life in a landscape: a spined seashell tower and glossy spheres on pebbles, a
//         flowering meadow, mountains, clouds. Each Gaussian is coloured as training would: its SH
//         are fitted to the radiance seen from a ring of cameras, reflections included.
// Stats   Like a trained scene: SH degree 3, log-normal scales, anisotropy 1..100, many faint
//         Gaussians, needles, haze, near and far, background out to thousands of units.
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

}  // namespace pipegs
