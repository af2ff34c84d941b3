// SPDX-License-Identifier: Apache-2.0
// dram_trace.hpp: the traces of the DRAM check: streams, random reads, reads with writes among them.
//
// Idea    The traces are those that a short Python script wrote for the reference simulators, made again without
//         Python: its random.Random(1) is a Mersenne Twister, seeded by an array of one word, and randrange(n) draws
//         bit_length(n) bits until they are below n. The three random traces share one generator, in their order.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace pipegs {

// Python's random.Random(seed).
class PythonRandom {
 public:
  explicit PythonRandom(uint32_t seed);
  uint32_t randrange(uint32_t n);  // 0 .. n - 1

 private:
  uint32_t next_word();

  std::array<uint32_t, 624> state_;
  int index_ = 624;
};

struct DramTransfer {
  uint64_t address;
  bool write;
  uint32_t bytes;
};

inline constexpr std::array<std::string_view, 6> kDramTraces = {"stream_rd64", "random_rd64",   "random_rd256",
                                                                "random_rd4k", "stream_rdwr64", "two_streams_1k"};

std::vector<DramTransfer> dram_trace(std::string_view name);

}  // namespace pipegs
