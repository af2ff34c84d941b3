// SPDX-License-Identifier: Apache-2.0
// ports.hpp: words in and out of the ports of a Verilated module, whatever C++ type Verilator chose for them.
//
// Up to 64 bits a port is an integer, above it is an array of 32-bit words, lowest first.
#pragma once

#include <verilated.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "cpp_model/records.hpp"

namespace pipegs {

// Copies words into a port of any Verilator type, and back.
template <class Port>
void write_port(Port& port, const uint32_t* words) {
  if constexpr (std::is_integral_v<Port>) {
    port = static_cast<Port>(sizeof(Port) > 4 ? (static_cast<uint64_t>(words[1]) << 32) | words[0] : words[0]);
  } else {
    for (size_t i = 0; i < sizeof(Port) / 4; ++i) port.m_storage[i] = words[i];
  }
}
template <class Port>
void read_port(const Port& port, uint32_t* words) {
  if constexpr (std::is_integral_v<Port>) {
    words[0] = static_cast<uint32_t>(port);
    if constexpr (sizeof(Port) > 4) words[1] = static_cast<uint32_t>(static_cast<uint64_t>(port) >> 32);
  } else {
    for (size_t i = 0; i < sizeof(Port) / 4; ++i) words[i] = port.m_storage[i];
  }
}
template <class Port>
constexpr size_t port_words() {
  return (sizeof(Port) + 3) / 4;
}

// `width` bits at `at` of a wide port, as words.
template <class Port>
void slice(const Port& port, int at, int width, uint32_t* words) {
  constexpr size_t kWords = sizeof(Port) / 4 + 2;
  uint32_t all[kWords] = {};
  const uint32_t* source;
  if constexpr (std::is_integral_v<Port>) {
    read_port(port, all);
    source = all;
  } else {
    source = port.data();
  }
  const int count = (width + 31) / 32, shift = at % 32, first = at / 32;
  for (int i = 0; i < count; ++i) {
    const uint64_t low = source[first + i];
    const uint64_t high = shift != 0 && first + i + 1 < static_cast<int>(kWords - 2) ? source[first + i + 1] : 0;
    words[i] = static_cast<uint32_t>((high << 32 | low) >> shift);
  }
  if (width % 32 != 0) words[count - 1] &= (1u << (width % 32)) - 1;
}

// The fields of a struct port, one after another from the lowest bit on.
class PortReader {
 public:
  template <class Port>
  explicit PortReader(const Port& port) {
    if constexpr (std::is_integral_v<Port>) {
      read_port(port, small_);
      words_ = small_;
    } else {
      words_ = port.data();
    }
  }
  uint64_t next(int width) { return get_bits(words_, std::exchange(at_, at_ + width), width); }
  void skip(int width) { at_ += width; }

 private:
  uint32_t small_[2] = {};
  const uint32_t* words_;
  int at_ = 0;
};
class PortWriter {  // of a port above 64 bits
 public:
  template <class Port>
  explicit PortWriter(Port& port) : words_(port.data()) {}
  void next(int width, uint64_t value) { put_bits(words_, std::exchange(at_, at_ + width), width, value); }
  void skip(int width) { at_ += width; }

 private:
  uint32_t* words_;
  int at_ = 0;
};

}  // namespace pipegs
