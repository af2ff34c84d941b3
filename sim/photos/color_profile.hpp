// SPDX-License-Identifier: Apache-2.0
// color_profile: whether the ICC profile of a picture, or its codes of ITU-T H.273, are those of sRGB.
//
// Idea    Profiles of sRGB are many, of other bytes and names. They have the same three primaries, adapted to D50; so a
//         profile with others is another one. Without primaries (grey, tables) its name says it.
#pragma once

#include <string>
#include <string_view>

namespace pipegs {

// The name of a profile that is not sRGB's; empty for sRGB and for bytes that are no profile.
std::string foreign_profile(std::string_view bytes);
// As "BT.2020, PQ", of primaries and transfer in the chunk cICP of a PNG; empty for sRGB.
std::string foreign_codes(int primaries, int transfer);

}  // namespace pipegs
