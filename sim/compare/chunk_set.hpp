// SPDX-License-Identifier: Apache-2.0
// chunk_set.hpp: the chunks that the DOPU sends to the PUs for one window, and which of them have come.
//
// Idea    Which chunks pass, and what is known of each, follows from the window; in which order they go, and to which
//         PU, from the memory. So each comes once in a walk, with the bits that the bit-accurate model gives it.
#pragma once

#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "cpp_model/golden.hpp"

namespace pipegs {

class ChunkSet {
 public:
  // Of the window x, y with these walks (order 2); with lists of the frame, whose first window this is.
  ChunkSet(const GoldenInput& input, uint64_t x, uint64_t y, const std::vector<uint64_t>& walks = {});

  const Chunk* find(const Chunk& like) const;  // the one of its walk that begins with the same Gaussian, or null
  bool take(const Chunk& like);                // it has come; false: again
  // The first one that has not, of those that are needed.
  std::optional<uint64_t> missing(const std::function<bool(const Chunk& chunk)>& needed) const;
  // A chunk of the scene that none of the walk's planes would let pass (Occlusion: tighter ones do, behind the camera).
  void add(const Chunk& chunk) { chunks_[name_of(chunk)].chunk = chunk; }

 private:
  struct One {
    Chunk chunk;
    bool come = false;
  };
  static uint64_t name_of(const Chunk& chunk) { return chunk.walk << 32 | chunk.slot; }
  std::unordered_map<uint64_t, One> chunks_;
};

}  // namespace pipegs
