// SPDX-License-Identifier: Apache-2.0
// stages.cpp: see stages.hpp.
#include "cpp_model/pu/stages.hpp"

#include "cpp_model/config.hpp"

namespace pipegs {

std::vector<PuStage> pu_stages(const Config& c) {
  return {
#define PIPEGS_STAGE(name, Name, in, out, begin, free, result, built) {#name, #Name, 0, 0, begin, free, result, built},
#define PIPEGS_EIGHT_CYCLES(name, Name, in, out, depth, claim, built) \
  {#name, #Name, depth, claim, 1 + (claim), 7 - (claim), 8 - (claim) + (depth), built},
#include "cpp_model/pu/stages.def"
#undef PIPEGS_EIGHT_CYCLES
#undef PIPEGS_STAGE
  };
}

int pu_stages_behind(const Config& c, std::string_view stage, std::string_view end) {
  int count = 0;
  bool behind = false;
  for (const PuStage& one : pu_stages(c)) {
    if (one.name == end) break;
    if (behind && one.built) ++count;
    behind = behind || one.name == stage;
  }
  return count;
}

}  // namespace pipegs
