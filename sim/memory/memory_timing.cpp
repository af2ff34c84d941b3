// SPDX-License-Identifier: Apache-2.0
// memory_timing.cpp: see memory_timing.hpp.
#include "sim/memory/memory_timing.hpp"

#include <algorithm>
#include <stdexcept>

#include "sim/memory/dram_memory.hpp"

namespace pipegs {

PinsTiming::PinsTiming(const ExternalMemoryOptions& options) : options_(options), rng_(options.seed) {
  if (options.latency < 1 || options.bytes_per_cycle <= 0 || options.jitter < 0 || options.queue < 1) {
    throw std::invalid_argument("external memory: latency, bandwidth and queue must be positive");
  }
  cycles_per_line_ = 64.0 / options.bytes_per_cycle;
}

void PinsTiming::request(bool write, uint64_t, int tag, int lines, int halves) {
  const double share = write || halves == 3 ? 1 : 0.5;
  for (int i = 0; i < lines; ++i) add(write, tag, share * cycles_per_line_);
}

void PinsTiming::add(bool write, int tag, double cycles) {
  const double start = std::max(now_, pins_free_);
  pins_free_ = start + cycles;
  starts_.push_back(start);
  if (write) return;
  double due = start + options_.latency;
  if (options_.jitter == 0) return answers_.push_back({due, order_++, tag});
  due += static_cast<double>(rng_() % (static_cast<uint64_t>(options_.jitter) + 1));
  due = std::max(due, last_due_[static_cast<size_t>(tag)]);
  last_due_[static_cast<size_t>(tag)] = due;
  shuffled_.push({due, order_++, tag});
}

int PinsTiming::step() {
  now_ += 1;
  while (!starts_.empty() && starts_.front() <= now_) starts_.pop_front();
  if (!answers_.empty() && answers_.front().due <= now_) {
    const int tag = answers_.front().tag;
    answers_.pop_front();
    return tag;
  }
  if (!shuffled_.empty() && shuffled_.top().due <= now_) {
    const int tag = shuffled_.top().tag;
    shuffled_.pop();
    return tag;
  }
  return kNoAnswer;
}

double memory_peak(const ExternalMemoryOptions& options) {
  return options.dram == "ideal" ? options.bytes_per_cycle : dram_memory_timing(options.dram).peak_gbps();
}

std::unique_ptr<MemoryTiming> memory_timing(const ExternalMemoryOptions& options) {
  if (options.dram == "ideal") return std::make_unique<PinsTiming>(options);
  return std::make_unique<DramMemory>(options);
}

}  // namespace pipegs
