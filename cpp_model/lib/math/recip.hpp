// SPDX-License-Identifier: Apache-2.0
// recip: the reciprocal of a normalised mantissa.
//
// Idea    A table of 64 lines gives 1/v to 2^-14.8: y0 = c0[i] - c1[i] d. One Newton step squares the error:
//           e = 1 - v y0;   y = y0 (1 + e) = (1 - e^2) / v
//         The work is done in 28 bits for every width W.
// Numbers x is u1.(W-1) with its leading one, v = x 2^-(W-1) in [1, 2). y is u0.W with its leading one: 1/v = y 2^-W.
//         So 1/x = y 2^-(2W-1). v = 1 saturates to the largest y, 1 - 2^-W: y is always normalised, no exponent moves.
// Error   |y - 2^W / v| <= 0.5 (rounding) + 2^(W-29.6) (e^2) + 2^(W-31.5) (cuts) units in the last place, 1 at v = 1.
// RTL     rtl/lib/math/pipegs_recip.sv
#pragma once

#include <cstdint>

#include "cpp_model/fixed.hpp"

namespace pipegs {

struct RecipLine {
  int32_t value;  // u0.18
  int32_t slope;  // u0.11
};

inline constexpr RecipLine kRecipLines[64] = {
    {262135, 2016}, {258102, 1955}, {254192, 1897}, {250398, 1841}, {246717, 1788}, {243141, 1737}, {239668, 1688},
    {236292, 1641}, {233011, 1596}, {229819, 1553}, {226713, 1511}, {223691, 1472}, {220747, 1433}, {217881, 1397},
    {215087, 1361}, {212365, 1327}, {209711, 1295}, {207122, 1263}, {204596, 1233}, {202131, 1203}, {199725, 1175},
    {197375, 1148}, {195080, 1121}, {192838, 1096}, {190646, 1071}, {188504, 1047}, {186410, 1024}, {184362, 1002},
    {182358, 980},  {180397, 960},  {178478, 939},  {176599, 920},  {174760, 901},  {172958, 882},  {171194, 865},
    {169464, 847},  {167770, 831},  {166108, 814},  {164480, 798},  {162883, 783},  {161317, 768},  {159781, 754},
    {158274, 740},  {156794, 726},  {155343, 713},  {153918, 700},  {152518, 687},  {151144, 675},  {149795, 663},
    {148469, 651},  {147167, 640},  {145887, 629},  {144629, 618},  {143394, 608},  {142178, 597},  {140983, 587},
    {139809, 578},  {138653, 568},  {137516, 559},  {136398, 550},  {135298, 541},  {134216, 533},  {133151, 524},
    {132102, 516},
};

// width: of x and y, 18 to 28.
inline uint64_t recip(int width, uint64_t x) {
  const int64_t v = static_cast<int64_t>(x << (28 - width));  // u1.27
  const RecipLine line = kRecipLines[(v >> 21) & 63];
  const int64_t d = (v >> 9) & 0xfff;                              // u0.18, below 2^-6
  const int64_t y0 = line.value - ((line.slope * d) >> 11);        // u0.18
  const int64_t e = ((int64_t{1} << 45) - v * y0) >> 13;           // s-14.32
  const int64_t y = shift_round((y0 << 32) + y0 * e, 50 - width);  // u0.50 to u0.width
  return static_cast<uint64_t>(saturate_unsigned(y, width));
}

}  // namespace pipegs
