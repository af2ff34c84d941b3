// SPDX-License-Identifier: Apache-2.0
// pu_coeff: the six coefficients of Eq. 3 for one Gaussian and one window.
//
// Paper   Eq. 3, step 1 of Fig. 5a, once per Gaussian and window; the anchor is the window's first pixel.
// Idea    With (p, q) = (x, y), exchanged if swap, the mean relative to the window's first pixel, and
//         w = mean_p - m mean_q:
//           A = -(narrow w^2 + wide mean_q^2) - opacity      D = -narrow      E = -(narrow m^2 + wide)
//           B = 2 narrow w      C = 2 (wide mean_q - narrow m w)             F = 2 narrow m
//         w is exact before it is rounded to MantissaW + 3 bits, and every product keeps more bits than its use needs.
// Numbers A to F: CoeffF fraction bits; each product rounded to nearest, a sum of two rounds twice.
//         Out of range: `dead`, all coefficients zero. Lossless, because a pixel of the window with power >= -10 bounds
//         them: with narrow, wide <= 3.34 k = 2.41 (dilation 0.3), sqrt(narrow) |w'| <= sqrt(10) at that pixel,
//         |w - w'| <= 126 and sqrt(wide) |q'| <= sqrt(10), |mean_q - q'| <= 63:
//           |A| < 49800 < 2^16, as narrow w^2 <= (3.17 + 126 * 1.553)^2 = 39550, wide mean_q^2 <= 10210 likewise
//           |B| <= 2 * 1.553 * 198.9 = 618,  |C| <= 618 + 2 * 1.553 * 101.1 = 933 < 2^12
//           |D|, |E| <= 2.41,  |F| <= 4.82 < 2^3
// RTL     rtl/pu/conic/pu_coeff.sv
#pragma once

#include "cpp_model/records.hpp"

namespace pipegs {

Coeff pu_coeff(const Config& config, const Frame& frame, const Conic& conic);

}  // namespace pipegs
