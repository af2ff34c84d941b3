// SPDX-License-Identifier: Apache-2.0
// dram_trace.cpp: see dram_trace.hpp.
#include "sim/memory/dram/check/dram_trace.hpp"

#include <bit>
#include <stdexcept>
#include <string>

namespace pipegs {

PythonRandom::PythonRandom(uint32_t seed) {
  state_[0] = 19650218;
  for (uint32_t i = 1; i < 624; ++i) state_[i] = 1812433253u * (state_[i - 1] ^ (state_[i - 1] >> 30)) + i;
  const auto mixed = [&](uint32_t i, uint32_t factor) {
    return state_[i] ^ ((state_[i - 1] ^ (state_[i - 1] >> 30)) * factor);
  };
  uint32_t i = 1;
  const auto advance = [&] {
    if (++i == 624) {
      state_[0] = state_[623];
      i = 1;
    }
  };
  for (int k = 0; k < 624; ++k) {
    state_[i] = mixed(i, 1664525u) + seed;
    advance();
  }
  for (int k = 0; k < 623; ++k) {
    state_[i] = mixed(i, 1566083941u) - i;
    advance();
  }
  state_[0] = 0x80000000u;
}

uint32_t PythonRandom::next_word() {
  if (index_ == 624) {
    for (int i = 0; i < 624; ++i) {
      const uint32_t y = (state_[i] & 0x80000000u) | (state_[(i + 1) % 624] & 0x7fffffffu);
      state_[i] = state_[(i + 397) % 624] ^ (y >> 1) ^ ((y & 1) != 0 ? 0x9908b0dfu : 0);
    }
    index_ = 0;
  }
  uint32_t y = state_[index_++];
  y ^= y >> 11;
  y ^= (y << 7) & 0x9d2c5680u;
  y ^= (y << 15) & 0xefc60000u;
  return y ^ (y >> 18);
}

uint32_t PythonRandom::randrange(uint32_t n) {
  const int bits = std::bit_width(n);
  uint32_t value;
  do { value = next_word() >> (32 - bits); } while (value >= n);
  return value;
}

std::vector<DramTransfer> dram_trace(std::string_view name) {
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

}  // namespace pipegs
