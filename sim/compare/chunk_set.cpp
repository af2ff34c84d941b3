// SPDX-License-Identifier: Apache-2.0
// chunk_set.cpp: see chunk_set.hpp.
#include "sim/compare/chunk_set.hpp"

#include "cpp_model/dopu/dopu.hpp"
#include "cpp_model/dopu/nearest/dopu_nearest.hpp"

namespace pipegs {

ChunkSet::ChunkSet(const GoldenInput& input, uint64_t x, uint64_t y, const std::vector<uint64_t>& walks) {
  const auto keep = [&](int, const Chunk& chunk, uint64_t) { chunks_[name_of(chunk)].chunk = chunk; };
  const Config& config = input.packed->config;
  const int column = static_cast<int>(x), row = static_cast<int>(y);
  if (!config.has_watermarks()) {
    dopu_window(config, input.frame, *input.packed, column, row, keep);
    return;
  }
  for (const uint64_t walk : walks) dopu_nearest(config, input.frame, *input.packed, column, row, walk, keep);
}

const Chunk* ChunkSet::find(const Chunk& like) const {
  const auto found = chunks_.find(name_of(like));
  return found == chunks_.end() ? nullptr : &found->second.chunk;
}

bool ChunkSet::take(const Chunk& like) {
  One& one = chunks_.at(name_of(like));
  const bool first = !one.come;
  one.come = true;
  return first;
}

std::optional<uint64_t> ChunkSet::missing(const std::function<bool(const Chunk&)>& needed) const {
  std::optional<uint64_t> first;
  for (const auto& [name, one] : chunks_) {
    if (!one.come && one.chunk.slot < first.value_or(~uint64_t{0}) && needed(one.chunk)) first = one.chunk.slot;
  }
  return first;
}

}  // namespace pipegs
