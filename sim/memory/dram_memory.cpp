// SPDX-License-Identifier: Apache-2.0
// dram_memory.cpp: see dram_memory.hpp.
#include "sim/memory/dram_memory.hpp"

#include <algorithm>
#include <stdexcept>

namespace pipegs {
namespace {

constexpr int kLineBytes = 64;
constexpr int kQueue = 64;  // reads, and as many writes, that a channel's controller chooses from

}  // namespace

DramTiming dram_memory_timing(const std::string& name) {
  const DramTiming* preset = dram_preset(name);
  if (preset == nullptr) {
    std::string known = "ideal";
    for (const std::string& other : dram_memory_names()) known += ", " + other;
    throw std::invalid_argument("external memory '" + name + "': expected one of " + known);
  }
  DramTiming timing = *preset;
  timing.interleave_bytes = std::max(timing.interleave_bytes, kLineBytes);
  timing.mapping = DramMapping::kRoBaCoGrCh;
  timing.hits_first = true;
  timing.read_queue = timing.write_queue = kQueue;
  if (name.starts_with("lpddr5")) timing.t_rfcpb = 96;   // 120 ns (JESD209-5, 8 Gb)
  if (name.starts_with("lpddr4")) timing.t_rfcpb = 144;  // 90 ns (JESD209-4, 8 Gb)
  timing.write_high = 0.9, timing.write_low = 0.1;
  return timing;
}

DramMemory::DramMemory(const ExternalMemoryOptions& options)
    : dram_(dram_memory_timing(options.dram)), path_(options.path) {
  if (options.path < 0) throw std::invalid_argument("external memory: path must not be negative");
  for (uint32_t i = 0; i < kFlying; ++i) free_.push_back(i);
}

void DramMemory::request(bool write, uint64_t line, int tag, int lines, int halves) {
  if (write) return dram_.request(true, line, 0);
  next_line_ = line;
  lines_left_ = lines;
  tag_ = tag;
  halves_ = halves;
  enter();
}

void DramMemory::enter() {
  for (; lines_left_ > 0 && dram_.ready() && flying_ < kFlying; --lines_left_) {
    const uint32_t id = free_.front();
    free_.pop_front();
    ++flying_;
    reads_[id] = {tag_, false};
    order_[static_cast<size_t>(tag_)].push_back(id);
    dram_.request(false, next_line_++, id, halves_);
  }
}

int DramMemory::step() {
  ++now_;
  dram_.step();
  if (lines_left_ > 0) enter();
  for (uint32_t id; dram_.done(id);) {
    reads_[id].back = true;
    auto& order = order_[static_cast<size_t>(reads_[id].tag)];
    for (; !order.empty() && reads_[order.front()].back; order.pop_front()) {
      due_.push_back({now_ + path_, reads_[order.front()].tag});
      free_.push_back(order.front());
      --flying_;
    }
  }
  if (due_.empty() || due_.front().cycle > now_) return kNoAnswer;
  const int tag = due_.front().tag;
  due_.pop_front();
  return tag;
}

}  // namespace pipegs
