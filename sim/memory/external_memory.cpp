// SPDX-License-Identifier: Apache-2.0
// external_memory.cpp: see external_memory.hpp.
#include "sim/memory/external_memory.hpp"

#include <fmt/format.h>

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

void ExternalMemory::accept(bool write, uint64_t address, int tag, int lines, int halves) {
  const uint64_t end = address + static_cast<uint64_t>(lines);
  if (end > size_) {
    throw MemoryFault(fmt::format("external memory: tag {} {} line {}, but there are {} lines", tag,
                                  write ? "writes" : "reads", end - 1, size_));
  }
  if (write && !overwrites_ && unanswered_.contains(address)) {
    throw MemoryFault(
        fmt::format("external memory: tag {} writes line {}, and a read of it is not answered", tag, address));
  }
  Traffic& traffic = traffic_[static_cast<size_t>(tag)];
  if (write) {
    ++traffic.lines_written;
    traffic.halves_written += static_cast<uint64_t>((halves & 1) + (halves >> 1));
    return;
  }
  ++traffic.bursts;
  traffic.lines_read += static_cast<uint64_t>(lines);
  traffic.halves_read += halves == 3 ? 2 * static_cast<uint64_t>(lines) : 1;
  for (uint64_t line = address; line < end; ++line) {
    asked_[static_cast<size_t>(tag)].push_back(line);
    ++unanswered_[line];
  }
}

void ExternalMemory::answered(int tag) {
  std::deque<uint64_t>& asked = asked_[static_cast<size_t>(tag)];
  if (const auto count = unanswered_.find(asked.front()); --count->second == 0) unanswered_.erase(count);
  asked.pop_front();
}

void ExternalMemory::forget() {
  for (std::deque<uint64_t>& asked : asked_) asked.clear();
  unanswered_.clear();
}

void ExternalMemory::load(const std::vector<MemoryLine>& lines, uint64_t first) {
  for (const MemoryLine& one : lines) line(first++) = one;
}

void ExternalMemory::set_lines(uint64_t lines) {
  size_ = lines;
  if (bus_) bus_->set_lines(lines);
}

void ExternalMemory::request(bool write, uint64_t address, int tag, const uint32_t* data, int lines, int halves) {
  accept(write, address, tag, lines, halves);
  timing_->request(write, address, tag, lines, write ? 3 : halves);
  if (write) {
    for (int half = 0; half < 2; ++half) {
      if ((halves >> half & 1) != 0) std::copy(data + 8 * half, data + 8 * half + 8, line(address).begin() + 8 * half);
    }
    return;
  }
  for (int i = 0; i < lines; ++i) read_[tag].push_back(line(address + static_cast<uint64_t>(i)));
  if (halves != 3) std::fill_n(read_[tag].back().begin() + (halves == 1 ? 8 : 0), 8, 0xa5a5a5a5u);
}

void ExternalMemory::step() {
  const int tag = timing_->step();
  shown_.reset();
  if (tag == MemoryTiming::kNoAnswer) return;
  shown_ = Answer{tag, read_[tag].front()};
  answered(tag);
  read_[tag].pop_front();
}

}  // namespace pipegs
