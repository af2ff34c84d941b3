// SPDX-License-Identifier: Apache-2.0
// stages: the table of a PU's stages (stages.def) as a list.
#pragma once

#include <string_view>
#include <vector>

namespace pipegs {

struct Config;

#define PIPEGS_STAGE(...) +1
#define PIPEGS_EIGHT_CYCLES(...) +1
#define PIPEGS_FOUR_CYCLES(...) +1
inline constexpr int kPuStages = 0
#include "cpp_model/pu/stages.def"
    ;
#undef PIPEGS_FOUR_CYCLES
#undef PIPEGS_EIGHT_CYCLES
#undef PIPEGS_STAGE

struct PuStage {
  std::string_view name, camel_name;
  int depth, claim;         // of pu_phases; 0 for a PIPEGS_STAGE
  int begin, free, result;  // cycles: see stages.def; free is negative where the next is taken before this one claims
  int places;               // Gaussians in it at most, that at its output among them
  bool built;               // the configuration has it
};

// In the order of the chain. A stage that is built in one of two ways has two rows.
std::vector<PuStage> pu_stages(const Config& c);

// Those that are built, from one of them to another one.
std::vector<PuStage> pu_built(const Config& c, std::string_view first, std::string_view last);
// Gaussians in these at most.
int pu_places(const Config& c, std::string_view first, std::string_view last);

}  // namespace pipegs
