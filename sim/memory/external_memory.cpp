// SPDX-License-Identifier: Apache-2.0
// external_memory.cpp: see external_memory.hpp.
#include "sim/memory/external_memory.hpp"

#include <algorithm>

namespace pipegs {

ExternalMemory::ExternalMemory(const ExternalMemoryOptions& options) : timing_(memory_timing(options)) {}

void ExternalMemory::request(bool write, uint64_t address, int tag, const uint32_t* data, int halves) {
  timing_->request(write, address, tag);
  ++lines_;
  if (write) {
    for (int half = 0; half < 2; ++half) {
      if ((halves >> half & 1) == 0) continue;
      std::copy(data + 8 * half, data + 8 * half + 8, line(address).begin() + 8 * half);
      ++traffic_[tag].halves_written;
    }
    ++traffic_[tag].lines_written;
    return;
  }
  ++traffic_[tag].lines_read;
  read_[tag].push_back(line(address));
}

void ExternalMemory::step() {
  const int tag = timing_->step();
  shown_.reset();
  if (tag == MemoryTiming::kNoAnswer) return;
  shown_ = Answer{tag, read_[tag].front()};
  read_[tag].pop_front();
}

}  // namespace pipegs
