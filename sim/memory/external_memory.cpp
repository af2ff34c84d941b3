// SPDX-License-Identifier: Apache-2.0
// external_memory.cpp: see external_memory.hpp.
#include "sim/memory/external_memory.hpp"

#include <algorithm>

namespace pipegs {

ExternalMemory::ExternalMemory(const ExternalMemoryOptions& options, int bus_w) {
  if (bus_w == 0) {
    timing_ = memory_timing(options);
  } else {
    bus_ = std::make_unique<AxiMemory>(
        AxiMemoryOptions{.data_w = bus_w, .harsh = options.harsh, .timing = options, .seed = options.seed});
  }
}

void ExternalMemory::request(bool write, uint64_t address, int tag, const uint32_t* data) {
  timing_->request(write, address, tag);
  count(write, tag);
  if (write) {
    std::copy(data, data + 16, line(address).begin());
    return;
  }
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
