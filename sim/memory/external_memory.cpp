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

void ExternalMemory::count(bool write, int tag, int lines, int halves) {
  Traffic& traffic = traffic_[static_cast<size_t>(tag)];
  if (write) {
    ++traffic.lines_written;
    traffic.halves_written += static_cast<uint64_t>((halves & 1) + (halves >> 1));
  } else {
    ++traffic.bursts;
    traffic.lines_read += static_cast<uint64_t>(lines);
  }
}

void ExternalMemory::request(bool write, uint64_t address, int tag, const uint32_t* data, int lines, int halves) {
  timing_->request(write, address, tag, lines);
  count(write, tag, lines, halves);
  if (write) {
    for (int half = 0; half < 2; ++half) {
      if ((halves >> half & 1) != 0) std::copy(data + 8 * half, data + 8 * half + 8, line(address).begin() + 8 * half);
    }
    return;
  }
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
