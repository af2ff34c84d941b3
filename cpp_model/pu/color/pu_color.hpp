// SPDX-License-Identifier: Apache-2.0
// pu_color: the colour of a Gaussian seen from the camera, and the record that becomes a splat.
//
// Paper   SH colours of 3D Gaussian splatting (INRIA's order and constants).
// Idea    fetch the line of coefficients | rotate -> normalise -> basis | sum; the two arms meet in the sum.
// Stream  color_job -> colored, in order; an end beat passes with colour zero.
// Error   <= 2^-10, rms 2^-11.7 against double, of which 2^-11.8 is the resolution of the colour itself (ColorW = 12).
// RTL     rtl/pu/color/pu_color.sv
#pragma once

#include "cpp_model/pu/color/pu_color_basis.hpp"
#include "cpp_model/pu/color/pu_color_fetch.hpp"
#include "cpp_model/pu/color/pu_color_normalise.hpp"
#include "cpp_model/pu/color/pu_color_rotate.hpp"
#include "cpp_model/pu/color/pu_color_sum.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

// `sh_line`: the 16 words of the job's line of memory (see color_line), null when color_degree() is 0 or for an end
// beat.
inline Colored pu_color(const Config& config, const Frame& frame, const ColorJob& job, const uint32_t* sh_line,
                        ColorCounts* counts = nullptr) {
  ShBasis basis;
  if (job.kind == kData && color_degree(config, frame) > 0) {
    basis = pu_color_basis(pu_color_normalise(config, pu_color_rotate(config, frame, color_direction(job))));
  }
  return pu_color_sum(config, frame, color_task(config, job), sh_line, basis, counts);
}

}  // namespace pipegs
