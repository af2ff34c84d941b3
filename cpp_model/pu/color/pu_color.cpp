// SPDX-License-Identifier: Apache-2.0
#include "cpp_model/pu/color/pu_color.hpp"

#include "cpp_model/pu/color/pu_color_basis.hpp"
#include "cpp_model/pu/color/pu_color_fetch.hpp"
#include "cpp_model/pu/color/pu_color_normalise.hpp"
#include "cpp_model/pu/color/pu_color_rotate.hpp"

namespace pipegs {

Colored pu_color(const Config& config, const Frame& frame, const ColorJob& job, const uint32_t* sh_line,
                 ColorCounts* counts) {
  ShBasis basis;
  if (job.kind == kData && color_degree(config, frame) > 0) {
    basis = pu_color_basis(pu_color_normalise(config, pu_color_rotate(config, frame, color_direction(job))));
  }
  return pu_color_sum(config, frame, color_task(job), sh_line, basis, counts);
}

}  // namespace pipegs
