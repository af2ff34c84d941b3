// SPDX-License-Identifier: Apache-2.0
// aov_image: AOVs as they lie in memory, in the units of the scene.
//
// Idea    Coverage is T u1.15 below the number of Gaussians; depths are u0.32 of the frame's range; an index is that in
//         the scene's file.
// RTL     rtl/ru/aovs/ru_aov_lines.sv
#pragma once

#include "cpp_model/float/image.hpp"
#include "cpp_model/pack/pack.hpp"
#include "cpp_model/ru/ru_aovs.hpp"

namespace pipegs {

// View depth in scene units that a depth key stands for.
double key_depth(const PackedScene& packed, uint64_t key);

// Puts what a frame wants into an image of all its pixels, in place of what that has.
void show_aovs(const PackedScene& packed, const Frame& frame, const AovPixels& aovs, Image& image);

}  // namespace pipegs
