// SPDX-License-Identifier: Apache-2.0
// chunk_set.hpp: the chunks that the DOPU sends to the PUs for one window, and which of them have come.
//
// Idea    Which chunks pass, and what is known of each, follows from the window; in which order they go, and to which
//         PU, from the memory. So each comes once, with the bits that the bit-accurate model gives it.
#pragma once

#include <optional>
#include <unordered_map>

#include "cpp_model/golden.hpp"

namespace pipegs {

class ChunkSet {
 public:
  // Of the window x, y; with lists of the frame, whose first window this is.
  ChunkSet(const GoldenInput& input, uint64_t x, uint64_t y);

  const Chunk* find(uint64_t slot) const;   // the one that begins with this Gaussian, or null
  bool take(uint64_t slot);                 // it has come; false: again
  std::optional<uint64_t> missing() const;  // the first one that has not

 private:
  struct One {
    Chunk chunk;
    bool come = false;
  };
  std::unordered_map<uint64_t, One> chunks_;
};

}  // namespace pipegs
