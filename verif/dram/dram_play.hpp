// SPDX-License-Identifier: Apache-2.0
// dram_play.hpp: the traces of the reference runs, and the channels of a DRAM that play them.
//
// Idea    The traces are those that a short Python script wrote for the reference simulators, made again without
//         Python: its random.Random(1) is a Mersenne Twister, seeded by an array of one word, and randrange(n) draws
//         bit_length(n) bits until they are below n. The three random traces share one generator, in their order.
//         The runs are played again by their own rules. Requests are cut into bursts and offered in order, up to four
//         in a cycle; a full queue stops the burst at the front and all behind it. A burst is offered while fewer than
//         `max_out` are on their way. The run ends when as many bursts have finished as the trace has. In the runs of
//         Ramulator 2 a write counted twice, when it was accepted and when it was written: a trace with one write in
//         three then ends after three quarters of it, with GB/s 4/3 of what crossed the pins.
//         Latencies count from the cycle in which the controller sees the burst to the last beat of a read, or to the
//         command of a write.
// Docs    docs/cycles/memory_timing.md
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <random>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "sim/memory/dram/dram_channel.hpp"
#include "sim/memory/dram/dram_place.hpp"
#include "sim/memory/dram/dram_timing.hpp"

namespace pipegs {

// Python's random.Random(seed).
class PythonRandom {
 public:
  explicit PythonRandom(uint32_t seed) {
    constexpr uint32_t kWords = std::mt19937::state_size;
    std::array<uint32_t, kWords> state;
    state[0] = 19650218;
    for (uint32_t i = 1; i < kWords; ++i) state[i] = 1812433253u * (state[i - 1] ^ (state[i - 1] >> 30)) + i;
    const auto mixed = [&](uint32_t i, uint32_t factor) {
      return state[i] ^ ((state[i - 1] ^ (state[i - 1] >> 30)) * factor);
    };
    uint32_t i = 1;
    const auto advance = [&] {
      if (++i == kWords) {
        state[0] = state[kWords - 1];
        i = 1;
      }
    };
    for (uint32_t k = 0; k < kWords; ++k) {
      state[i] = mixed(i, 1664525u) + seed;
      advance();
    }
    for (uint32_t k = 1; k < kWords; ++k) {
      state[i] = mixed(i, 1566083941u) - i;
      advance();
    }
    state[0] = 0x80000000u;
    std::stringstream text;
    for (const uint32_t word : state) text << word << ' ';
    text << kWords;  // all of them are used up
    text >> words_;
  }
  uint32_t randrange(uint32_t n) {  // 0 .. n - 1
    uint32_t value;
    do { value = words_() >> (32 - std::bit_width(n)); } while (value >= n);
    return value;
  }

 private:
  std::mt19937 words_;
};

struct DramTransfer {
  uint64_t address;
  bool write;
  uint32_t bytes;
};

inline constexpr std::array<std::string_view, 6> kDramTraces = {"stream_rd64", "random_rd64",   "random_rd256",
                                                                "random_rd4k", "stream_rdwr64", "two_streams_1k"};

inline std::vector<DramTransfer> dram_trace(std::string_view name) {
  constexpr uint32_t kCount = 100000;
  constexpr uint64_t kSpan = uint64_t{1} << 30;
  std::vector<DramTransfer> trace;
  PythonRandom random(1);
  const auto random_reads = [&](uint32_t count, uint32_t bytes) {
    trace.clear();
    for (uint32_t i = 0; i < count; ++i) {
      trace.push_back({uint64_t{random.randrange(static_cast<uint32_t>(kSpan / bytes))} * bytes, false, bytes});
    }
  };
  if (name == "stream_rd64") {
    for (uint64_t i = 0; i < kCount; ++i) trace.push_back({i * 64, false, 64});
  } else if (name == "random_rd64" || name == "random_rd256" || name == "random_rd4k") {
    random_reads(kCount, 64);
    if (name != "random_rd64") random_reads(kCount / 4, 256);
    if (name == "random_rd4k") random_reads(kCount / 64, 4096);
  } else if (name == "stream_rdwr64") {
    for (uint64_t i = 0; i < kCount; ++i) {
      const bool write = i % 3 == 0;
      trace.push_back({write ? kSpan / 2 + i / 3 * 64 : i * 64, write, 64});
    }
  } else if (name == "two_streams_1k") {
    for (uint64_t i = 0; i < kCount; ++i) {
      const uint64_t pair = i / 32, within = i % 32;
      trace.push_back({(within < 16 ? 0 : kSpan / 2) + (pair * 16 + within % 16) * 64, false, 64});
    }
  } else {
    throw std::invalid_argument("dram: no trace is called " + std::string(name));
  }
  return trace;
}

struct DramPlay {
  uint64_t bursts = 0;    // of the trace
  DramCycle cycles = 0;   // clock cycles of the DRAM
  double gbps = 0;        // bytes of the trace over the time of the run, as the references count
  double latency_ns = 0;  // mean of reads and writes, as the references count
};

inline DramPlay play_dram(const DramTiming& timing, std::span<const DramTransfer> trace, int max_out,
                          bool writes_finish_twice = false) {
  constexpr int kOfferedInACycle = 4;
  struct Burst {
    uint64_t number;  // byte address / bytes of a burst
    bool write;
  };
  std::vector<Burst> bursts;
  const auto bytes = static_cast<uint64_t>(timing.burst_bytes());
  for (const DramTransfer& transfer : trace) {
    const uint64_t first = transfer.address / bytes, last = (transfer.address + transfer.bytes - 1) / bytes;
    for (uint64_t number = first; number <= last; ++number) bursts.push_back({number, transfer.write});
  }
  const DramPlaces places(timing);
  std::vector<DramChannel> channels(static_cast<std::size_t>(timing.channels), DramChannel(timing));
  std::vector<DramCycle> seen(bursts.size());
  std::vector<DramCycle> writes_seen;  // of which the first `written` are done: their order does not change the mean
  uint64_t reads = 0, written = 0, finished = 0;
  DramCycle read_cycles = 0, write_cycles = 0, now = 0;
  int64_t out = 0;
  std::size_t front = 0;
  for (bool over = bursts.empty(); !over;) {
    int offered = 0;
    for (; front < bursts.size() && out < max_out && offered < kOfferedInACycle; ++front, ++offered) {
      const Burst& burst = bursts[front];
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
  play.gbps = static_cast<double>(play.bursts * bytes) / static_cast<double>(now) / timing.t_ck_ps * 1e3;
  play.latency_ns =
      1e-3 * timing.t_ck_ps * static_cast<double>(read_cycles + write_cycles) / static_cast<double>(reads + written);
  return play;
}

}  // namespace pipegs
