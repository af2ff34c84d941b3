// SPDX-License-Identifier: Apache-2.0
// axi_timing.cpp: see axi_timing.hpp.
#include "sim/memory/axi/axi_timing.hpp"

namespace pipegs {
namespace {

constexpr size_t kAsks = 8;   // lines that may wait for the timing before addresses and data are refused
constexpr size_t kBack = 64;  // lines that may wait for R, likewise

}  // namespace

AxiTiming::AxiTiming(const ExternalMemoryOptions& options, int data_w, int write_latency)
    : timing_(memory_timing(options)), beats_(512 / data_w), write_latency_(write_latency) {}

void AxiTiming::step() {
  ++now_;
  const int tag = timing_->step();
  if (tag != MemoryTiming::kNoAnswer) {
    auto& asked = asked_[static_cast<size_t>(tag)];
    back_.push_back(asked.front());
    asked.pop_front();
  }
  ready_ = asks_.size() < kAsks && back_.size() < kBack;
  if (beat_ == 0 && !back_.empty()) {
    shown_ = back_.front();
    beat_ = sent_ + 1;
    if (line_ends()) back_.pop_front();
  }
  if (!answer_ && !answers_.empty() && answers_.front() <= now_) {
    answers_.pop_front();
    answer_ = true;
  }
}

void AxiTiming::read(uint64_t line, int lines, uint32_t id, int halves) {
  for (int i = 0; i < lines; ++i) asks_.push_back({false, line + static_cast<uint64_t>(i), id, i + 1 == lines, halves});
}

std::optional<AxiLine> AxiTiming::end(bool r_ready, bool b_ready) {
  if (beat_ > 0 && r_ready) {
    sent_ = line_ends() ? 0 : beat_;
    beat_ = 0;
  }
  if (b_ready) answer_ = false;
  if (asks_.empty() || !timing_->ready()) return std::nullopt;
  const AxiLine ask = asks_.front();
  asks_.pop_front();
  timing_->request(ask.write, ask.line, static_cast<int>(ask.id & 0xff), 1, ask.halves);
  if (ask.write) {
    answers_.push_back(now_ + write_latency_);
  } else {
    asked_[ask.id & 0xff].push_back(ask);
  }
  return ask;
}

}  // namespace pipegs
