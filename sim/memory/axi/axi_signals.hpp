// SPDX-License-Identifier: Apache-2.0
// axi_signals.hpp: what AXI4 shows in one cycle, seen from a subordinate: the manager's side and its own.
#pragma once

#include <array>
#include <cstdint>

namespace pipegs {

enum class AxiResponse { kOkay = 0, kSlaveError = 2, kDecodeError = 3 };

struct AxiAddress {  // AR or AW
  bool valid = false;
  uint32_t id = 0;
  uint64_t address = 0;  // of a byte
  int length = 0;        // beats - 1
  int size = 0;          // log2 of the bytes of a beat
  int burst = 1;         // 1: INCR
  bool operator==(const AxiAddress&) const = default;
};

struct AxiWriteBeat {
  bool valid = false;
  bool last = false;
  uint64_t strobes = 0;
  std::array<uint32_t, 16> data{};  // those of the bus width, bit 0 of the bus is bit 0 of word 0
  bool operator==(const AxiWriteBeat&) const = default;
};

struct AxiManagerSide {
  AxiAddress ar, aw;
  AxiWriteBeat w;
  bool r_ready = false, b_ready = false;
};

struct AxiSubordinateSide {
  bool ar_ready = false, aw_ready = false, w_ready = false;
  struct {
    bool valid = false;
    bool last = false;
    uint32_t id = 0;
    AxiResponse response = AxiResponse::kOkay;
    std::array<uint32_t, 16> data{};
  } r;
  struct {
    bool valid = false;
    uint32_t id = 0;
    AxiResponse response = AxiResponse::kOkay;
  } b;
};

}  // namespace pipegs
