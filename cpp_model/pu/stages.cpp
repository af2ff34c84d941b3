// SPDX-License-Identifier: Apache-2.0
// stages.cpp: see stages.hpp.
#include "cpp_model/pu/stages.hpp"

#include "cpp_model/config.hpp"

namespace pipegs {
namespace {

PuStage phases(std::string_view name, std::string_view camel_name, int phases, int depth, int claim, bool built) {
  return {.name = name,
          .camel_name = camel_name,
          .depth = depth,
          .claim = claim,
          .begin = 1 + claim,
          .free = phases - 1 - claim,
          .result = phases - claim + depth,
          .places = 2 + claim / phases,
          .built = built};
}

}  // namespace

std::vector<PuStage> pu_stages(const Config& c) {
  return {
#define PIPEGS_STAGE(name, Name, in, out, begin, free, result, built) \
  {#name, #Name, 0, 0, begin, free, result, 2, built},
#define PIPEGS_EIGHT_CYCLES(name, Name, in, out, depth, claim, built) phases(#name, #Name, 8, depth, claim, built),
#define PIPEGS_FOUR_CYCLES(name, Name, in, out, depth, claim, built) phases(#name, #Name, 4, depth, claim, built),
#include "cpp_model/pu/stages.def"
#undef PIPEGS_FOUR_CYCLES
#undef PIPEGS_EIGHT_CYCLES
#undef PIPEGS_STAGE
  };
}

std::vector<PuStage> pu_built(const Config& c, std::string_view first, std::string_view last) {
  std::vector<PuStage> built;
  bool within = false, ended = false;
  for (const PuStage& stage : pu_stages(c)) {
    within = within || stage.name == first;
    if (ended && stage.name != last) break;
    ended = stage.name == last;
    if (within && stage.built) built.push_back(stage);
  }
  return built;
}

int pu_places(const Config& c, std::string_view first, std::string_view last) {
  int places = 0;
  for (const PuStage& stage : pu_built(c, first, last)) places += stage.places;
  return places;
}

}  // namespace pipegs
