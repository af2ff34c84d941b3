// SPDX-License-Identifier: Apache-2.0
// external_memory.cpp: see external_memory.hpp.
#include "sim/memory/external_memory.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pipegs {

ExternalMemory::ExternalMemory(const ExternalMemoryOptions& options) : timing_(memory_timing(options)) {}

void ExternalMemory::request(bool write, uint64_t address, int tag, const uint32_t* data) {
  if (address >= size_) {
    throw MemoryFault(fmt::format("external memory: tag {} {} line {}, but there are {} lines", tag,
                                  write ? "writes" : "reads", address, size_));
  }
  if (write && !overwrites_ && unanswered_.contains(address)) {
    throw MemoryFault(
        fmt::format("external memory: tag {} writes line {}, and a read of it is not answered", tag, address));
  }
  timing_->request(write, address, tag);
  ++lines_;
  if (write) {
    std::copy(data, data + 16, line(address).begin());
    ++traffic_[tag].lines_written;
    return;
  }
  ++traffic_[tag].lines_read;
  read_[tag].push_back({address, line(address)});
  ++unanswered_[address];
}

void ExternalMemory::step() {
  const int tag = timing_->step();
  shown_.reset();
  if (tag == MemoryTiming::kNoAnswer) return;
  const Read& read = read_[tag].front();
  shown_ = Answer{tag, read.data};
  if (const auto count = unanswered_.find(read.line); --count->second == 0) unanswered_.erase(count);
  read_[tag].pop_front();
}

}  // namespace pipegs
