// SPDX-License-Identifier: Apache-2.0
// static_cost.hpp: what a configuration is built of, before anything runs: lanes and memory.
//
// Idea    All follows from the Config: lanes, and a row for each SRAM (width x depth x count). A test elaborates the
//         RTL of several design points with Yosys and compares the bits.
// Units   Bits; 1 KB is 1024 bytes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cpp_model/config.hpp"

namespace pipegs {

struct BufferCost {
  std::string buffer;   // instance, as in docs/silicon/silicon.md
  std::string purpose;  // alphas, pixels, records, sorter, parameters, scene, queues, overflow
  int width = 0, depth = 0, count = 0, ports = 2;
  uint64_t bits() const { return uint64_t(width) * uint64_t(depth) * uint64_t(count); }
};

struct StaticCost {
  int row_lanes = 0;    // pixels whose power the machine computes in a cycle
  int blend_lanes = 0;  // pixels that it blends in a cycle
  std::vector<BufferCost> buffers;

  double buffer_kb() const;
};

StaticCost static_cost(const Config& config);

}  // namespace pipegs
