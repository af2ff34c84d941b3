// SPDX-License-Identifier: Apache-2.0
// static_cost.hpp: what a configuration is built of, before anything runs: lanes, arithmetic, memory.
//
// Idea    Everything follows from the Config: a row for each datapath module (how many there are, what one holds) and
//         for each SRAM (width x depth x count). A test elaborates the RTL of several design points with Yosys and
//         compares.
// Rules   A multiplier multiplies two variable values. A product with a constant is shifts and adders: one adder for
//         each nonzero digit of the constant after the first, in the signed-digit form that has the fewest. An adder
//         adds or subtracts two variable values of at least 14 bits (at the default widths): sums of exponents,
//         counters, addresses, rounding constants and comparisons are not counted. The same holds for products with
//         constants, so the index of a table is none. Only modules that compute something of a Gaussian or a pixel are
//         counted, as the RTL states it, equal ones once: a multiplier that serves several products in turn is one.
// Units   Bits; 1 KB is 1024 bytes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cpp_model/config.hpp"

namespace pipegs {

struct ArithmeticCost {
  std::string module;       // rtl/*/<module>.sv
  std::string kind;         // partition (DOPU), projection, color, power, blend
  std::string unit;         // dopu, pu, su or ru
  int instances = 0;        // in the whole machine
  int multipliers = 0;      // in all instances
  int adders = 0;           // in all instances, without those of constant_products
  int constant_adders = 0;  // of products with constants
};

struct BufferCost {
  std::string buffer;   // instance, as in docs/silicon/silicon.md
  std::string purpose;  // alphas, pixels, records, sorter, parameters, scene, queues, overflow
  int width = 0, depth = 0, count = 0;
  uint64_t bits() const { return uint64_t(width) * uint64_t(depth) * uint64_t(count); }
};

struct StaticCost {
  int row_lanes = 0;    // pixels whose power the machine computes in a cycle
  int blend_lanes = 0;  // pixels that it blends in a cycle
  std::vector<ArithmeticCost> arithmetic;
  std::vector<BufferCost> buffers;

  // Sums over the rows of one kind; "" for all.
  int multipliers(const std::string& kind) const;
  int adders(const std::string& kind) const;  // those of constant products included
  double buffer_kb(const std::string& purpose) const;
};

StaticCost static_cost(const Config& config);

// Adders of a product with a constant: nonzero digits of its non-adjacent form, minus one.
int constant_product_adders(int constant);

}  // namespace pipegs
