// SPDX-License-Identifier: Apache-2.0
// rival.cpp: see rival.hpp.
#include "sim/studies/rivals/models/rival.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace pipegs {

Values values_of(const Rival& rival, const Values& changed) {
  Values values;
  for (const Parameter& one : rival.parameters) values[one.name] = one.value;
  for (const auto& [name, to] : changed) {
    if (!values.contains(name)) throw std::invalid_argument(fmt::format("{}: has no parameter {}", rival.key, name));
    if (!std::isfinite(to) || to < 0)
      throw std::invalid_argument(fmt::format("{}: {} is {}, expected a number from 0 on", rival.key, name, to));
    if (to == 0 && (name.ends_with("rate") || name == "lanes" || name == "cores" || name == "splitters" ||
                    name == "sorters" || name == "masks"))
      throw std::invalid_argument(fmt::format("{}: {} is 0, expected at least one unit at work", rival.key, name));
    values[name] = to;
  }
  return values;
}

double value(const Values& values, const std::string& name) {
  const auto found = values.find(name);
  if (found == values.end()) throw std::invalid_argument("a model asks for " + name + ", which is no parameter of it");
  return found->second;
}

MachineFrame frame_of(const Rival& rival, const FrameCounts& counts, PlayedMemory& memory, const Values& changed) {
  return rival.frame(counts, values_of(rival, changed), memory);
}

std::vector<const Rival*> all_rivals() { return {&gscore(), &gs_tg(), &streaminggs(), &gsacc(), &neo(), &flicker()}; }

}  // namespace pipegs
