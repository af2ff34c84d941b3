// SPDX-License-Identifier: Apache-2.0
// pu_root: the integer square root of a 28-bit number.
//
// Idea    Digit by digit, from the top: two bits of the radicand give one bit of the root, a compare and a subtraction.
//           rest = 4 rest + two bits;   if (rest >= 4 root + 1) rest -= 4 root + 1, the new bit is 1
// Numbers floor(sqrt(radicand)), exact.
// RTL     rtl/pu/conic/pu_root.sv
#pragma once

#include <cstdint>

namespace pipegs {

inline constexpr int kRadicandW = 28;

inline uint64_t pu_root(uint64_t radicand) {
  uint64_t root = 0, rest = 0;
  for (int i = kRadicandW - 2; i >= 0; i -= 2) {
    rest = (rest << 2) | ((radicand >> i) & 3);
    const uint64_t trial = (root << 2) | 1, bit = rest >= trial ? 1 : 0;
    rest -= trial & (0 - bit);
    root = (root << 1) | bit;
  }
  return root;
}

}  // namespace pipegs
