// SPDX-License-Identifier: Apache-2.0
// memory_line.hpp: a line of external memory, the unit of every request.
#pragma once

#include <array>
#include <cstdint>

namespace pipegs {

using MemoryLine = std::array<uint32_t, 16>;  // 64 bytes, bit 0 of the line is bit 0 of word 0

}  // namespace pipegs
