// dram_memory.cpp: see dram_memory.hpp.
#include "sim/dram_memory.hpp"

#include <stdexcept>

namespace pipegs {
namespace {

DramTiming preset(const std::string& name) {
  if (const DramTiming* timing = dram_preset(name)) return *timing;
  std::string known = "ideal";
  for (const std::string& other : dram_presets()) known += ", " + other;
  throw std::invalid_argument("external memory '" + name + "': expected one of " + known);
}

}  // namespace

DramMemory::DramMemory(const ExternalMemoryOptions& options) : dram_(preset(options.dram)), path_(options.path) {
  if (options.path < 0) throw std::invalid_argument("external memory: path must not be negative");
  for (uint32_t i = 0; i < kFlying; ++i) free_.push_back(i);
}

void DramMemory::request(bool write, uint64_t line, int tag) {
  if (write) return dram_.request(true, line, 0);
  const uint32_t id = free_.front();
  free_.pop_front();
  ++flying_;
  reads_[id] = {tag, false};
  order_[static_cast<size_t>(tag)].push_back(id);
  dram_.request(false, line, id);
}

int DramMemory::step() {
  ++now_;
  dram_.step();
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
