// SPDX-License-Identifier: Apache-2.0
// frame_areas: how large each area is that a frame uses: the tables of its scene, its pixels, and what overflows.
//
// RTL     areas_t of rtl/pipegs_pkg.sv, taken with the frame
// Idea    The overflow area is as large as the frame can need at most: the driver says how large that is
//         (pipegs_overflow_size of cpp_model/driver/pipegs_frame.h), to a user's program and to the model.
// Units   Lines of external memory.
#pragma once

#include "cpp_model/areas/areas.hpp"
#include "cpp_model/pack/pack.hpp"
#include "cpp_model/ru/ru_raster.hpp"

namespace pipegs {

// Of the machine `config`, which may differ from the scene's in what does not change the scene.
Areas frame_areas(const Config& config, const PackedScene& scene, const Frame& frame, const Picture& picture = {});
// The overflow area alone, for a scene of so many slots.
uint64_t overflow_area(const Config& config, uint64_t slots, uint64_t windows);

// Everything that a frame names in memory lies so many lines further on.
void move_frame(Frame& frame, uint64_t lines);

// The windows that a frame renders, and the overflow area as one record.
uint64_t frame_windows(const Frame& frame);
Span overflow_span(const Frame& frame, const Areas& areas);

// Lines of the pixels of all windows of the picture, whole ones, whatever is rendered of it.
uint64_t pixel_area(const Config& config, uint64_t width, uint64_t height);

}  // namespace pipegs
