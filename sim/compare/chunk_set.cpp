// SPDX-License-Identifier: Apache-2.0
// chunk_set.cpp: see chunk_set.hpp.
#include "sim/compare/chunk_set.hpp"

#include "cpp_model/dopu/dopu.hpp"
#include "cpp_model/dopu/nearest/dopu_nearest.hpp"

namespace pipegs {

ChunkSet::ChunkSet(const GoldenInput& input, uint64_t x, uint64_t y) {
  const auto keep = [&](int, const Chunk& chunk, uint64_t) { chunks_[chunk.slot].chunk = chunk; };
  const Config& config = input.packed->config;
  const int column = static_cast<int>(x), row = static_cast<int>(y);
  if (config.has_watermarks()) dopu_nearest(config, input.frame, *input.packed, column, row, keep);
  else dopu_window(config, input.frame, *input.packed, column, row, keep);
}

const Chunk* ChunkSet::find(uint64_t slot) const {
  const auto found = chunks_.find(slot);
  return found == chunks_.end() ? nullptr : &found->second.chunk;
}

bool ChunkSet::take(uint64_t slot) {
  One& one = chunks_.at(slot);
  const bool first = !one.come;
  one.come = true;
  return first;
}

std::optional<uint64_t> ChunkSet::missing() const {
  std::optional<uint64_t> first;
  for (const auto& [slot, one] : chunks_) {
    if (!one.come && slot < first.value_or(~uint64_t{0})) first = slot;
  }
  return first;
}

}  // namespace pipegs
