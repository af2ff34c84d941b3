// SPDX-License-Identifier: Apache-2.0
// external_memory.cpp: see external_memory.hpp.
#include "sim/memory/external_memory.hpp"

#include <algorithm>

namespace pipegs {

ExternalMemory::ExternalMemory(const ExternalMemoryOptions& options) : timing_(memory_timing(options)) {}

void ExternalMemory::request(bool write, uint64_t address, int tag, const uint32_t* data, int lines) {
  timing_->request(write, address, tag, lines);
  lines_ += static_cast<uint64_t>(lines);
  if (write) {
    std::copy(data, data + 16, line(address).begin());
    ++traffic_[tag].lines_written;
    return;
  }
  ++traffic_[tag].bursts;
  traffic_[tag].lines_read += static_cast<uint64_t>(lines);
  for (int i = 0; i < lines; ++i) read_[tag].push_back(line(address + static_cast<uint64_t>(i)));
}

void ExternalMemory::step() {
  const int tag = timing_->step();
  shown_.reset();
  if (tag == MemoryTiming::kNoAnswer) return;
  shown_ = Answer{tag, read_[tag].front()};
  read_[tag].pop_front();
}

}  // namespace pipegs
