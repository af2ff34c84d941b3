// SPDX-License-Identifier: Apache-2.0
// terms.hpp: `pipegs ladder --terms paper`: the ladder in the paper's own terms instead of the RTL's.
#pragma once

#include "sim/command/command.hpp"

namespace pipegs {

int ladder_terms(const ViewArguments& view, const MemoryArguments& memory, bool json);

}  // namespace pipegs
