// SPDX-License-Identifier: Apache-2.0
// pack_quantize: one trained value after another into the fields of the packed records.
//
// Idea    Round to nearest, saturate, and count what was clipped. Only bounds (scale_max) round up.
//           scale    (1 + m / 2^ScaleMW) * 2^(e - 8) world units, e = 0 is zero
//           opacity  round(-log2(opacity) * 2^OpacityF), at least 0
//           base     round((0.2820948 f_dc + 0.5) * 2^(BaseW - 3))
//           SH       m * 2^(e - 26 - ShMW), one e for all coefficients of a Gaussian
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "cpp_model/config.hpp"
#include "cpp_model/records.hpp"
#include "cpp_model/pack/pack.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

// A scale in world units as a field; saturates at the largest.
uint64_t encode_scale(const Config& config, double world, bool round_up);

uint64_t encode_opacity(const Config& config, double opacity);

// Largest scale of the record, weighted by how far its opacity lets it reach; in world units.
double effective_scale(const Config& config, const GaussianRecord& record);

// Half extents of the box around the ellipsoid on which alpha is 1/AlphaCut, in world units; a little more, for the
// PU's roundings.
std::array<double, 3> ellipsoid_extents(const Config& config, const GaussianRecord& record);

// The fields of scales, opacity and rotation. Adds to the counts of clipped fields.
GaussianRecord quantize_reach(const Config& config, const ActivatedGaussian& gaussian, int scene_exponent,
                              PackCounts& counts);

// All fields but the offsets. Adds to the counts of clipped fields.
GaussianRecord quantize(const Config& config, const Scene& scene, const ActivatedGaussian& gaussian, uint32_t index,
                        int scene_exponent, PackCounts& counts);

// With record = 48: the code of a Gaussian, all but the offsets. Adds to the counts of clipped fields. `scale_exp`: of
// its chunk, see below.
GaussianCode encode(const Config& config, const Scene& scene, const ActivatedGaussian& gaussian, uint32_t index,
                    int scene_exponent, uint64_t scale_exp, PackCounts& counts);

// The exponent that scale_max of a chunk with these Gaussians has, whichever way their scales are rounded: that of the
// largest effective scale, or so much that the code of none is cut.
uint64_t chunk_scale_exp(const Config& config, std::span<const ActivatedGaussian> gaussians, int scene_exponent);

// Writes the SH coefficients of scene Gaussian `index` at bit `at` of the line.
void quantize_colors(const Config& config, const Scene& scene, int sh_degree, uint32_t index, uint32_t* line, int at,
                     PackCounts& counts);

}  // namespace pipegs
