// SPDX-License-Identifier: Apache-2.0
// published.hpp: what the papers print of each other, and what it comes to when it is multiplied.
//
// Idea    "Chained": PipeGS over GSCore (2.85x at most, Fig. 9) divided by the rival over GSCore. 2.77 / 2.3 is 1.204,
//         the least that the paper prints; so its Figs. 10 and 11 may be such chains. Frames are nobody's here: scenes
//         differ from paper to paper.
#pragma once

#include <array>
#include <string_view>

namespace pipegs {

inline constexpr double kPrintedArea[] = {1.96, 3.34}, kPrintedEnergy[] = {1.20, 2.77};  // PipeGS over all four
inline constexpr double kPipegsSpeed = 2.85;  // over its own reproduction of GSCore, at most

struct PublishedClaim {
  std::string_view key;          // of the rival
  double speed = 0, energy = 0;  // over GSCore, as its paper prints; 0 where it prints none
  std::string_view what;
};
inline constexpr std::array<PublishedClaim, 6> kClaims = {{
    {"gscore", 1, 1, "the baseline of all"},
    {"gs_tg", 1.54, 2.12, "over \"state of the art\"; average or most: sources differ"},
    {"streaminggs", 2.1, 2.3, "over GSCore"},
    {"gsacc", 0, 1.74, "energy 1.74x to 2.9x; \"PPA\" 1.41x on average, not defined"},
    {"neo", 1.8, 0, "over GSCore of 16 cores: 1.8x HD, 3.3x FHD, 5.6x QHD"},
    {"flicker", 1.5, 2.6, "over GSCore, at most"},
}};

}  // namespace pipegs
