// SPDX-License-Identifier: Apache-2.0
// axi_memory_test: the AXI4 memory of the tests (sim/memory/axi/axi_memory) names each rule that a manager breaks; what
// lies outside of it or fails is answered as such.
#include <gtest/gtest.h>

#include <functional>

#include "sim/memory/axi/axi_memory.hpp"

namespace pipegs {
namespace {

constexpr int kWords = 4;  // of the bus of 128 bits

AxiAddress address(uint64_t byte, int beats, uint32_t id = 0) {
  return {.valid = true, .id = id, .address = byte, .length = beats - 1, .size = 4, .burst = 1};
}
AxiWriteBeat beat(uint32_t word, bool last) {
  AxiWriteBeat beat{.valid = true, .last = last, .strobes = 0xffff};
  beat.data.fill(0);
  for (int i = 0; i < kWords; ++i) beat.data[static_cast<size_t>(i)] = word;
  return beat;
}

// The rule that is broken when the manager shows these cycles one after the other; each ready is as told.
std::string broken(const std::vector<AxiManagerSide>& cycles, bool ready) {
  AxiRules rules(128, 2, 2);
  AxiSubordinateSide own;
  own.ar_ready = own.aw_ready = own.w_ready = ready;
  try {
    for (const AxiManagerSide& cycle : cycles) rules.check(cycle, own);
  } catch (const std::runtime_error& error) {
    const std::string text = error.what();
    return text.substr(text.find(": ") + 2);
  }
  return "";
}
AxiManagerSide ar(AxiAddress address) { return {.ar = address}; }
AxiManagerSide aw(AxiAddress address) { return {.aw = address}; }
AxiManagerSide w(AxiWriteBeat beat) { return {.w = beat}; }

TEST(AxiRules, WhatWaitsStays) {
  EXPECT_EQ(broken({ar(address(64, 4)), ar(address(64, 4))}, false), "");
  EXPECT_EQ(broken({ar(address(64, 4)), {}}, false), "valid fell before the address was taken");
  EXPECT_EQ(broken({ar(address(64, 4)), ar(address(128, 4))}, false), "the address changed before it was taken");
  EXPECT_EQ(broken({ar(address(64, 4)), ar(address(128, 4))}, true), "");
  EXPECT_EQ(broken({aw(address(64, 4)), {}}, false), "valid fell before the address was taken");
  EXPECT_EQ(broken({aw(address(64, 4)), aw(address(64, 4, 1))}, false), "the address changed before it was taken");
  EXPECT_EQ(broken({w(beat(1, false)), {}}, false), "valid fell before the beat was taken");
  EXPECT_EQ(broken({w(beat(1, false)), w(beat(2, false))}, false), "the beat changed before it was taken");
  EXPECT_EQ(broken({w(beat(1, false)), w(beat(2, false))}, true), "");
}

TEST(AxiRules, BurstsAreLegal) {
  AxiAddress fixed = address(64, 4), narrow = address(64, 4);
  fixed.burst = 0;
  narrow.size = 3;
  EXPECT_EQ(broken({ar(fixed)}, true), "a burst that is not INCR");
  EXPECT_EQ(broken({ar(narrow)}, true), "beats narrower or wider than the bus");
  EXPECT_EQ(broken({ar(address(64, 257))}, true), "a burst of more than 256 beats");
  EXPECT_EQ(broken({ar(address(72, 4))}, true), "an address that is not aligned");
  EXPECT_EQ(broken({ar(address(4096 - 64, 4))}, true), "");
  EXPECT_EQ(broken({ar(address(4096 - 48, 4))}, true), "a burst crosses 4 KB");
}

TEST(AxiRules, WlastStandsAtTheLastBeat) {
  const AxiManagerSide first = aw(address(64, 2));
  EXPECT_EQ(broken({first, w(beat(1, false)), w(beat(1, true))}, true), "");
  EXPECT_EQ(broken({first, w(beat(1, true))}, true), "WLAST is not at the last beat");
  EXPECT_EQ(broken({first, w(beat(1, false)), w(beat(1, false))}, true), "WLAST is not at the last beat");
  EXPECT_EQ(broken({w(beat(1, true)), first}, true), "the data that came before it has another length");
}

TEST(AxiRules, NoMoreThanAgreedAreUnanswered) {
  const AxiManagerSide read = ar(address(64, 4)), write = aw(address(64, 4));
  EXPECT_EQ(broken({read, read}, true), "");
  EXPECT_EQ(broken({read, read, read}, true), "more than 2 bursts are unanswered");
  EXPECT_EQ(broken({write, write}, true), "");
  EXPECT_EQ(broken({write, write, write}, true), "more than 2 bursts are unanswered");
}

// Writes a line and reads it back over the bus; the responses of the two.
struct RoundTrip {
  AxiResponse write, read;
  uint32_t word;  // that the read shows
  int cycles;     // until the write was answered
};
RoundTrip round_trip(AxiMemory& memory, uint64_t byte) {
  RoundTrip result{};
  const auto run = [&](AxiManagerSide side, bool write, const std::function<bool(const AxiSubordinateSide&)>& done) {
    int beats = 0;
    side.r_ready = side.b_ready = true;
    for (int cycle = 0; cycle < 5000; ++cycle) {
      if (write && beats < 4) side.w = beat(77, beats == 3);
      const AxiSubordinateSide shown = memory.step();
      memory.observe(side);
      if (side.aw.valid && shown.aw_ready) side.aw = {};
      if (side.ar.valid && shown.ar_ready) side.ar = {};
      if (side.w.valid && shown.w_ready) side.w = {}, ++beats;
      if (done(shown)) return cycle;
    }
    ADD_FAILURE() << "no answer";
    return 0;
  };
  result.cycles = run(aw(address(byte, 4)), true, [&](const AxiSubordinateSide& shown) {
    result.write = shown.b.response;
    return shown.b.valid;
  });
  run(ar(address(byte, 4, 3)), false, [&](const AxiSubordinateSide& shown) {
    result.read = shown.r.response;
    result.word = shown.r.data[0];
    return shown.r.valid && shown.r.last;
  });
  return result;
}

TEST(AxiMemory, WritesLateAndAnswersWhatFails) {
  for (const bool harsh : {false, true}) {
    AxiMemory memory({.data_w = 128, .base = 4096, .size = 4096, .harsh = harsh, .timing = {.write_latency = 200}});
    const AxiMemory before({.data_w = 128});
    memory.failing.insert(66);
    const RoundTrip good = round_trip(memory, 4096), failing = round_trip(memory, 66 * 64);
    EXPECT_EQ(good.write, AxiResponse::kOkay);
    EXPECT_EQ(good.read, AxiResponse::kOkay);
    EXPECT_EQ(good.word, 77u);
    EXPECT_GE(good.cycles, 200);
    EXPECT_EQ(failing.write, AxiResponse::kSlaveError);
    EXPECT_EQ(failing.read, AxiResponse::kSlaveError);
    EXPECT_EQ(memory.line(66), before.line(66));
    for (const uint64_t outside : {uint64_t{4096 - 64}, uint64_t{8192}}) {
      const RoundTrip nothing = round_trip(memory, outside);
      EXPECT_EQ(nothing.write, AxiResponse::kDecodeError);
      EXPECT_EQ(nothing.read, AxiResponse::kDecodeError);
      EXPECT_EQ(memory.line(outside / 64), before.line(outside / 64));
    }
  }
}

}  // namespace
}  // namespace pipegs
