// external_memory.cpp: see external_memory.hpp.
#include "sim/external_memory.hpp"

#include <algorithm>
#include <stdexcept>

namespace pipegs {

ExternalMemory::ExternalMemory(const ExternalMemoryOptions& options) : options_(options), rng_(options.seed) {
  if (options.latency < 1 || options.bytes_per_cycle <= 0 || options.jitter < 0 || options.queue < 1) {
    throw std::invalid_argument("external memory: latency, bandwidth and queue must be positive");
  }
}

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
  const double start = std::max(now_, pins_free_);
  pins_free_ = start + 64.0 / options_.bytes_per_cycle;
  starts_.push_back(start);
  waiting_ = static_cast<int>(starts_.size());
  ++lines_;
  if (write) {
    std::copy(data, data + 16, line(address).begin());
    ++traffic_[tag].lines_written;
    return;
  }
  ++traffic_[tag].lines_read;
  double due = start + options_.latency;
  if (options_.jitter > 0) due += static_cast<double>(rng_() % (static_cast<uint64_t>(options_.jitter) + 1));
  due = std::max(due, last_due_[tag]);
  last_due_[tag] = due;
  pending_.push({due, order_++, {tag, line(address)}});
}

const ExternalMemory::Answer* ExternalMemory::answer() const { return shown_ ? &*shown_ : nullptr; }

void ExternalMemory::step() {
  now_ += 1;
  while (!starts_.empty() && starts_.front() <= now_) starts_.pop_front();
  waiting_ = static_cast<int>(starts_.size());
  shown_.reset();
  if (!pending_.empty() && pending_.top().due <= now_) {
    shown_ = pending_.top().answer;
    pending_.pop();
  }
}

}  // namespace pipegs
