// SPDX-License-Identifier: Apache-2.0
// external_memory.cpp: see external_memory.hpp.
#include "sim/memory/external_memory.hpp"

#include <algorithm>

namespace pipegs {

ExternalMemory::ExternalMemory(const ExternalMemoryOptions& options) : timing_(memory_timing(options)) {}

MemoryLine& ExternalMemory::line(uint64_t address) {
  const uint64_t page = address / kPageLines;
  if (page != cached_page_) {
    auto& slot = pages_[page];
    if (!slot) slot = std::make_unique<std::array<MemoryLine, kPageLines>>();
    cached_page_ = page;
    cached_ = slot.get();
  }
  return (*cached_)[address % kPageLines];
}

const MemoryLine& ExternalMemory::line(uint64_t address) const {
  static const MemoryLine kZero{};
  const uint64_t page = address / kPageLines;
  const auto slot = pages_.find(page);
  return slot == pages_.end() ? kZero : (*slot->second)[address % kPageLines];
}

void ExternalMemory::request(bool write, uint64_t address, int tag, const uint32_t* data) {
  timing_->request(write, address, tag);
  ++lines_;
  if (write) {
    std::copy(data, data + 16, line(address).begin());
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
