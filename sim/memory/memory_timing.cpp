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
  starts_.resize(static_cast<size_t>(options.queue) + kMostLines);
  answers_.resize(64);
}

void PinsTiming::request(bool write, uint64_t, int tag, int lines) {
  for (int i = 0; i < lines; ++i) add(write, tag);
}

void PinsTiming::add(bool write, int tag) {
  const double start = std::max(now_, pins_free_);
  pins_free_ = start + cycles_per_line_;
  starts_[(first_start_ + static_cast<size_t>(waiting_)) % starts_.size()] = start;
  ++waiting_;
  if (write) return;
  double due = start + options_.latency;
  if (options_.jitter == 0) {
    if (answer_count_ == answers_.size()) {
      std::vector<Pending> larger(2 * answers_.size());
      for (size_t i = 0; i < answer_count_; ++i) larger[i] = answers_[(first_answer_ + i) & (answers_.size() - 1)];
      answers_ = std::move(larger);
      first_answer_ = 0;
    }
    answers_[(first_answer_ + answer_count_++) & (answers_.size() - 1)] = {due, order_++, tag};
    return;
  }
  due += static_cast<double>(rng_() % (static_cast<uint64_t>(options_.jitter) + 1));
  due = std::max(due, last_due_[static_cast<size_t>(tag)]);
  last_due_[static_cast<size_t>(tag)] = due;
  shuffled_.push({due, order_++, tag});
}

int PinsTiming::step() {
  now_ += 1;
  while (waiting_ > 0 && starts_[first_start_] <= now_) {
    first_start_ = first_start_ + 1 == starts_.size() ? 0 : first_start_ + 1;
    --waiting_;
  }
  if (answer_count_ != 0 && answers_[first_answer_].due <= now_) {
    const int tag = answers_[first_answer_].tag;
    first_answer_ = (first_answer_ + 1) & (answers_.size() - 1);
    --answer_count_;
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
