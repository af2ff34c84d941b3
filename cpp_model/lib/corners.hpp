// SPDX-License-Identifier: Apache-2.0
// corners.hpp: random configurations that config_check allows, most of their entries at an end of their range.
//
// What no design point has is built by nobody, and breaks unseen: a width that gets too large, a cast to no bits, a
// negative constant. So lint and tests walk through such corners, each made from a seed that repeats it.
//
// Idea    From the default, entry by entry in a random order, each gets its lowest value, its highest or any between
//         where config_check agrees, and else stays; twice, because one entry may forbid what another one allows later.
// Users   cpp_model/package_sv.cpp (`--corner SEED`, for synth/lint.sh), verif/design/corners_test.cpp
#pragma once

#include <cstdint>
#include <string>

#include "cpp_model/config.hpp"

namespace pipegs {

// The legal configuration of this seed; the same on every host.
Config config_corner(uint64_t seed);

// What differs from the default as arguments of a command: "units=1 alpha_w=10".
std::string config_arguments(const Config& config);

}  // namespace pipegs
