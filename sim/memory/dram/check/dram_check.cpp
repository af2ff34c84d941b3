// SPDX-License-Identifier: Apache-2.0
// dram_check.cpp: see dram_check.hpp.
#include "sim/memory/dram/check/dram_check.hpp"

#include <algorithm>
#include <cstdio>
#include <map>

namespace pipegs {
namespace {

struct OfferedBurst {
  uint64_t number;  // byte address / bytes of a burst
  bool write;
};

std::vector<OfferedBurst> cut_into_bursts(std::span<const DramTransfer> trace, uint64_t bytes) {
  std::vector<OfferedBurst> bursts;
  for (const DramTransfer& transfer : trace) {
    const uint64_t first = transfer.address / bytes, last = (transfer.address + transfer.bytes - 1) / bytes;
    for (uint64_t number = first; number <= last; ++number) bursts.push_back({number, transfer.write});
  }
  return bursts;
}

}  // namespace

DramPlay play_dram(const DramTiming& timing, std::span<const DramTransfer> trace, int max_out,
                   bool writes_finish_twice) {
  constexpr int kOfferedInACycle = 4;
  const std::vector<OfferedBurst> bursts = cut_into_bursts(trace, timing.burst_bytes());
  const DramPlaces places(timing);
  std::vector<DramChannel> channels(timing.channels, DramChannel(timing));
  std::vector<DramCycle> seen(bursts.size());
  std::vector<DramCycle> writes_seen;  // of which the first `written` are done: their order does not change the mean
  uint64_t reads = 0, written = 0, finished = 0;
  DramCycle read_cycles = 0, write_cycles = 0, now = 0;
  int64_t out = 0;
  std::size_t front = 0;
  for (bool over = bursts.empty(); !over;) {
    int offered = 0;
    for (; front < bursts.size() && out < max_out && offered < kOfferedInACycle; ++front, ++offered) {
      const OfferedBurst& burst = bursts[front];
      const DramPlace place = places(burst.number);
      DramChannel& channel = channels[place.channel];
      if (!channel.accepts(burst.write)) break;
      channel.accept(now, burst.write, place, static_cast<uint32_t>(front));
      if (burst.write) {
        writes_seen.push_back(now + 1);
        ++finished;
      } else {
        seen[front] = now + 1;
        ++out;
      }
    }
    over = finished >= bursts.size();
    DramCycle next = over || offered == kOfferedInACycle ? now + 1 : INT64_MAX;
    for (const DramChannel& channel : channels) next = std::min(next, channel.next());
    now = next;
    uint64_t all_written = 0;
    for (DramChannel& channel : channels) {
      if (channel.next() <= now) {
        uint32_t tag;
        while (channel.finished(now, tag)) {
          read_cycles += now - seen[tag];
          ++reads;
          ++finished;
          --out;
        }
        channel.tick(now);
      }
      all_written += channel.counters().bursts_written + channel.counters().writes_merged;
    }
    for (; written < all_written; ++written) {
      write_cycles += now - writes_seen[written];
      if (!writes_finish_twice) continue;
      ++finished;
      --out;
    }
    over = over || finished >= bursts.size();
  }
  DramPlay play;
  play.bursts = bursts.size();
  play.cycles = now;
  for (const DramChannel& channel : channels) play.counters += channel.counters();
  const double seconds = 1e-12 * static_cast<double>(now) * timing.t_ck_ps;
  const auto gbps = [&](uint64_t count) { return 1e-9 * static_cast<double>(count) * timing.burst_bytes() / seconds; };
  const auto mean_ns = [&](DramCycle cycles, uint64_t count) {
    return count == 0 ? 0 : 1e-3 * timing.t_ck_ps * static_cast<double>(cycles) / static_cast<double>(count);
  };
  play.gbps = gbps(play.bursts);
  play.pin_gbps = gbps(play.counters.bursts_read + play.counters.bursts_written);
  play.latency_ns = mean_ns(read_cycles + write_cycles, reads + written);
  play.read_latency_ns = mean_ns(read_cycles, reads);
  return play;
}

std::vector<DramCheck> check_dram(std::span<const DramReference> references) {
  std::map<std::string, std::vector<DramTransfer>> traces;
  std::vector<DramCheck> checks;
  for (const DramReference& reference : references) {
    auto [trace, made] = traces.try_emplace(reference.trace);
    if (made) trace->second = dram_trace(reference.trace);
    const DramTiming timing = dram_reference_timing(reference.configuration);
    const DramPlay play = play_dram(timing, trace->second, reference.max_out, reference.source == "ramulator2");
    checks.push_back({reference, play});
  }
  return checks;
}

bool DramCheck::agrees() const {
  if (known_to_differ()) return true;
  if (reference.source == "ramulator2" && play.cycles != reference.cycles) return false;
  return play.bursts == reference.bursts && std::abs(difference()) <= (streaming() ? 0.05 : 0.10);
}

std::string dram_check_table(std::span<const DramCheck> checks) {
  std::string table =
      "| reference | configuration | trace | in flight | GB/s at the pins | GB/s | reference | difference | "
      "latency ns | reference |\n|---|---|---|---|---|---|---|---|---|---|\n";
  for (const DramCheck& check : checks) {
    const DramReference& r = check.reference;
    char line[256];
    std::snprintf(line, sizeof line, "| %s | %s | %s | %d | %.3f | %.3f | %.3f | %+.2f %% | %.1f | %.1f |\n",
                  r.source.c_str(), r.configuration.c_str(), r.trace.c_str(), r.max_out, check.play.pin_gbps,
                  check.play.gbps, r.gbps, 100 * check.difference(), check.play.latency_ns, r.latency_ns);
    table += line;
  }
  return table;
}

}  // namespace pipegs
