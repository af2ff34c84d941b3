// SPDX-License-Identifier: Apache-2.0
// flips.hpp: how many decisions "this Gaussian counts at this pixel" the machine takes unlike the truth.
//
// Idea    The truth counts a Gaussian at a pixel from alpha = 1/255 on. Machine and truth walk a window's pixels in the
//         machine's order; a pair (Gaussian, pixel) is a decision when the machine's pixel has not stopped at its turn
//         and at least one of both counts it. It is flipped when only one does: because of a rounded power, a lost
//         region, a cull, or another cut. A Gaussian that the machine shows nowhere takes its turn after all others.
// Sample  Only every n-th square of 64x64 pixels, spread over the image, so that some 40 of a large one are looked at.
#pragma once

#include <cstdint>
#include <vector>

#include "cpp_model/float/projection.hpp"
#include "cpp_model/golden.hpp"
#include "sim/studies/explore/figures.hpp"

namespace pipegs {

class FlipCounter {
 public:
  static constexpr int kSquare = 64;

  // The truth of the view. `area` is the part of the image that is looked at; `squares` about how many of it.
  FlipCounter(const Scene& scene, const Camera& camera, double near_plane, const PixelRect& area, int squares = 40);

  // The machine's decisions in the sampled squares. May be asked from several threads.
  Flips count(const GoldenInput& input, const std::vector<uint32_t>& rank) const;

  double sampled() const { return sampled_; }  // share of the area's pixels

 private:
  struct Footprint {
    glm::dvec2 mean;
    glm::dvec3 conic;
    double opacity, least_power;
    PixelRect rect;
    uint32_t index;
    bool counts(int x, int y) const;  // alpha >= 1/255
  };
  struct Square {
    PixelRect pixels;
    std::vector<Footprint> footprints;
  };
  Flips count_window(const GoldenInput& input, const std::vector<uint32_t>& rank, const Square& square, uint64_t x,
                     uint64_t y) const;

  std::vector<Square> squares_;
  double sampled_ = 0;
};

}  // namespace pipegs
