// SPDX-License-Identifier: Apache-2.0
// pu_intersect: which 8x8 regions of a part hold a pixel with alpha >= 1/AlphaCut.
//
// Paper   the tile test and the 4-bit bitmap of each tile (Sec. 4.2), for all sixteen tiles of 64x64 pixels at once.
// Idea    The box mean +- extent gives a range of columns and rows of regions. In it, region by region: the power is
//         concave, so its maximum over the region's box of pixel centres lies at the mean, or on the edges that face
//         the mean. The region is kept where
//           a corner reaches the cut (exact: corners are pixels), or
//           the power rises at one end of a facing edge and falls at its other end, and the peak between them,
//           P + g^2 / (4 |E|), reaches it:   g^2 >= 4 |E| (cut - P)      no division, no square root, no slope
//         P and the gradients step from region to region by additions.
//         TileTest 0: every region of the box. More work, the same pixels: a region more holds no pixel that counts.
// Numbers Exact in CoeffF fraction bits up to the last test, whose three numbers are rounded towards "keep".
//         The cut is lowered by cut_slack, which covers what is proved in pu_intersect.cpp, so no pixel is lost.
// RTL     rtl/pu/conic/pu_intersect.sv
#pragma once

#include "cpp_model/records.hpp"

namespace pipegs {

// A data beat whose mask is empty is not emitted.
Tiles pu_intersect(const Config& config, const Frame& frame, const Coeff& coeff);

// Cycles in which the regions of the box are walked, Tests of a row in each; 0 when nothing is walked.
int pu_intersect_steps(const Config& config, const Coeff& coeff);

}  // namespace pipegs
