// SPDX-License-Identifier: Apache-2.0
// view.hpp: a view whose Gaussians are blended in any order that is given, group of pixels by group.
//
// Idea    The truth of cpp_model/float blends in depth order, or by one rank for the whole picture. Other machines have
//         an order for each group of pixels, and some leave Gaussians out. So projection and blending are apart here:
//         what is blended comes in as a sequence for each group. In depth order the picture is the truth's, bit by bit.
// Rule    As kExact: a Gaussian adds where alpha >= 1/255; a pixel stops at the one that would bring T below 1e-4.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "cpp_model/float/image.hpp"
#include "sim/studies/rivals/count/cover.hpp"
#include "sim/studies/rivals/pixels/picture_counts.hpp"

namespace pipegs {

struct PixelView {
  Camera camera;
  SeenScene seen;                    // in depth order, ties by index; a place is a number in it
  std::vector<glm::dvec3> rgb = {};  // by place
};
PixelView pixel_view(const Scene& scene, const Camera& camera, double near_plane, unsigned threads);

// Of each group of side x side pixels, row by row, the places that are blended there, the first one first.
struct Sequences {
  int side = 0;  // a multiple of kTileSide
  std::vector<std::vector<uint32_t>> places = {};
};

// Every place in the groups that its pixels may lie in; `order` holds each place once.
Sequences sequences_of(const PixelView& view, const std::vector<uint32_t>& order, int side);
std::vector<uint32_t> depth_order(const PixelView& view);
// Places with alpha >= 1/255 at a pixel of the group, in depth order.
Sequences exact_sequences(const PixelView& view, int side, unsigned threads);

inline constexpr size_t kNeverStops = std::numeric_limits<size_t>::max();

struct OrderedPicture {
  Image image;
  OrderCounts counts = {};
  std::vector<size_t> stops = {};  // by group: how many of its sequence were walked until its last pixel stopped
};

// Throws std::invalid_argument for sequences of another grid, std::runtime_error when interrupted. The result does not
// depend on the number of threads.
OrderedPicture blend(const PixelView& view, const Sequences& sequences, unsigned threads);

}  // namespace pipegs
