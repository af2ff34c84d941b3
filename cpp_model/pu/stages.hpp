// SPDX-License-Identifier: Apache-2.0
// stages: the table of a PU's stages (stages.def) as a list.
#pragma once

#include <string_view>
#include <vector>

namespace pipegs {

struct Config;

#define PIPEGS_STAGE(...) +1
#define PIPEGS_EIGHT_CYCLES(...) +1
inline constexpr int kPuStages = 0
#include "cpp_model/pu/stages.def"
    ;
#undef PIPEGS_EIGHT_CYCLES
#undef PIPEGS_STAGE

struct PuStage {
  std::string_view name, camel_name;
  int depth, claim;         // of pu_phases; 0 for another stage
  int begin, free, result;  // cycles: see stages.def
  bool built;               // the configuration has it
};

// In the order of the chain.
std::vector<PuStage> pu_stages(const Config& c);

// How many are built behind one of them, and in front of another one if it is named.
int pu_stages_behind(const Config& c, std::string_view stage, std::string_view end = {});

}  // namespace pipegs
