// SPDX-License-Identifier: Apache-2.0
// traffic.cpp: see traffic.hpp.
#include "sim/studies/rivals/models/traffic.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/memory/dram/dram.hpp"
#include "sim/memory/dram_memory.hpp"

namespace pipegs {
namespace {

constexpr double kLineBytes = 64;
constexpr uint64_t kAreaLines = uint64_t{1} << 21;  // 128 MB: tables lie that far apart, longer ones go round
constexpr uint64_t kAreaSkew = 1237;                // so that they do not begin in the same bank

// Places without a table or a pattern: multiplication by an odd constant, high bits (Knuth).
uint64_t spread(uint64_t i) { return (i * 0x9E3779B97F4A7C15ULL) >> 24; }

// The lines of a flow, one after the other.
class Lines {
 public:
  Lines(const Flow& flow, uint64_t number) : write_(flow.write), base_(number * (kAreaLines + kAreaSkew)) {
    for (const double size : {flow.bytes, flow.run, flow.table}) {
      if (!(size >= 0) || !std::isfinite(size))
        throw std::invalid_argument("traffic: flow " + flow.kind + " has a size that is negative or not finite");
    }
    const double runs = flow.run > 0 ? std::ceil(flow.bytes / flow.run) : 1;
    const double longest = flow.run > 0 ? flow.run : flow.bytes;
    run_ = static_cast<uint64_t>(std::ceil(longest / kLineBytes));
    count_ = static_cast<uint64_t>(runs) * run_;
    if (flow.bytes == 0) count_ = 0;
    const double table = std::max({flow.table, flow.run > 0 ? flow.bytes : 0.0, kLineBytes});
    places_ = std::max<uint64_t>(1, static_cast<uint64_t>(table / kLineBytes) / std::max<uint64_t>(run_, 1));
    spread_ = flow.run > 0;
  }
  bool write() const { return write_; }
  uint64_t count() const { return count_; }
  uint64_t next() {
    const uint64_t run = given_ / run_, within = given_ % run_;
    ++given_;
    const uint64_t place = spread_ ? spread(run) % places_ : run;
    return base_ + (place * run_ + within) % kAreaLines;
  }

 private:
  bool write_, spread_ = false;
  uint64_t base_, run_ = 0, count_ = 0, places_ = 1, given_ = 0;
};

}  // namespace

double pin_bytes(const Flow& flow) { return static_cast<double>(Lines(flow, 0).count()) * kLineBytes; }

Traffic play_traffic(const std::vector<Flow>& flows, const std::string& dram_name, double clock_ghz) {
  std::vector<Lines> lines;
  uint64_t all = 0;
  for (const Flow& flow : flows) {
    lines.emplace_back(flow, lines.size());
    all += lines.back().count();
  }
  Traffic traffic{.bytes = static_cast<double>(all) * kLineBytes};
  if (dram_name == "ideal") return traffic;
  Dram dram(dram_memory_timing(dram_name), clock_ghz);
  if (all == 0) return traffic;
  const uint64_t played = std::min(all, kPlayedLines);
  std::vector<double> credit(lines.size(), 0);
  const auto step = [&] {
    dram.step();
    for (uint32_t id; dram.done(id);) {}
  };
  for (uint64_t i = 0; i < played; ++i) {
    std::size_t chosen = 0;  // the flow that is furthest behind its share
    for (std::size_t f = 0; f < lines.size(); ++f) {
      credit[f] += static_cast<double>(lines[f].count()) / static_cast<double>(all);
      if (credit[f] > credit[chosen]) chosen = f;
    }
    credit[chosen] -= 1;
    while (!dram.ready()) step();
    dram.request(lines[chosen].write(), lines[chosen].next(), 0);
  }
  while (!dram.idle()) step();
  const Dram::Statistics statistics = dram.statistics();
  const double bursts = static_cast<double>(statistics.row_hits + statistics.row_misses + statistics.row_conflicts);
  traffic.row_hits = bursts > 0 ? static_cast<double>(statistics.row_hits) / bursts : 0;
  traffic.cycles = static_cast<double>(dram.cycles()) * static_cast<double>(all) / static_cast<double>(played);
  return traffic;
}

}  // namespace pipegs
