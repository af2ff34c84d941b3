// SPDX-License-Identifier: Apache-2.0
// control_registers_test: rtl/control/pipegs_control_registers.sv over the bus: every field of the table, starts,
// events, counters, and what must be refused. In every cycle each output equals that of the bit-accurate model.
#include "verif/control/control_bench.hpp"

namespace pipegs {
namespace {

constexpr uint32_t kStart = 1, kAbort = 2;                         // CONTROL
constexpr uint32_t kFrameDone = 1, kQueueFree = 2, kErrorIrq = 4;  // IRQ_STATUS
constexpr uint32_t kStartFull = 1u << kErrorCauses;                // ERROR
constexpr uint32_t kGivingUp = kStartFull - 1;                     // its other bits

uint32_t mask_of(const RegisterField& field) {
  return static_cast<uint32_t>(((uint64_t{1} << field.width) - 1) << field.low);
}
uint32_t bytes_of(uint32_t strobe) {
  uint32_t mask = 0;
  for (int i = 0; i < 4; ++i) mask |= (strobe >> i & 1) != 0 ? 0xffu << 8 * i : 0;
  return mask;
}

void set_paces(ControlBench& c, int i) { c.pace = kPaces[i % 3], c.answer_pace = kPaces[i / 3 % 3]; }

TEST(ControlRegisters, ReadsWhatTheTableSaysAfterReset) {
  ControlBench c;
  set_paces(c, 4);
  for (const Register& reg : c.model.map.registers) {
    uint32_t expected = 0;
    for (const RegisterField& field : reg.fields) expected |= field.value << field.low;
    EXPECT_EQ(c.value(reg.offset), expected) << reg.name;
  }
  for (const SlotBlock& block : c.model.map.blocks) {
    for (const Slot& slot : block.slots) {
      EXPECT_EQ(c.value(slot.offset), 0u) << slot.name;
      EXPECT_EQ(c.value(slot.offset + 4), 0u) << slot.name;
    }
  }
  EXPECT_EQ(c.value(c.offset("ID")), 0x47504950u);
  EXPECT_NE(c.value(c.offset("LAYOUT")), 0u);
  EXPECT_EQ(c.value(c.offset("CONFIG_COUNTS")) & 0xff, static_cast<uint32_t>(c.config.units));
}

// Slot by slot, word by word, byte by byte: what the table calls a value is kept, the rest reads sign or 0.
TEST(ControlRegisters, KeepsEachSlotOfTheShadowSet) {
  for (int pace = 0; pace < 9; ++pace) {
    ControlBench c(test_seed() + static_cast<uint64_t>(pace));
    set_paces(c, pace);
    const std::vector<Slot> slots = c.model.map.shadow();
    std::vector<uint64_t> kept(slots.size());
    for (int round = 0; round < 3; ++round) {
      for (size_t i = 0; i < slots.size(); ++i) {
        for (int word = 0; word < 2; ++word) {
          const uint32_t data = static_cast<uint32_t>(c.bench.rng());
          const uint32_t strobe = round == 0 ? 15 : static_cast<uint32_t>(c.bench.rng()) & 15;
          ASSERT_TRUE(c.write(slots[i].offset + 4 * word, data, strobe)) << slots[i].name;
          const uint64_t bits = static_cast<uint64_t>(bytes_of(strobe)) << 32 * word;
          kept[i] = (kept[i] & ~bits) | ((static_cast<uint64_t>(data) << 32 * word) & bits);
          const int unused = 64 - slots[i].width - slots[i].shift;
          if (slots[i].width == 0) kept[i] = 0;
          kept[i] = kept[i] >> slots[i].shift << slots[i].shift;
          if (unused > 0 && slots[i].width > 0) {
            kept[i] = slots[i].is_signed ? static_cast<uint64_t>(static_cast<int64_t>(kept[i] << unused) >> unused)
                                         : kept[i] << unused >> unused;
          }
        }
      }
      for (size_t i = 0; i < slots.size(); ++i) {  // after all were written: none lies in another's place
        const uint64_t low = c.value(slots[i].offset), high = c.value(slots[i].offset + 4);
        ASSERT_EQ(high << 32 | low, kept[i]) << slots[i].name << ", " << c.at();
      }
    }
  }
}

TEST(ControlRegisters, KeepsAndClearsTheFieldsOfRegisters) {
  ControlBench c;
  for (int i = 0; i < 200; ++i) {
    set_paces(c, i);
    for (const Register& reg : c.model.map.registers) {
      if (reg.name == "CONTROL" || reg.constant()) continue;
      const uint32_t before = c.value(reg.offset), data = static_cast<uint32_t>(c.bench.rng());
      const uint32_t strobe = static_cast<uint32_t>(c.bench.rng()) & 15, bits = bytes_of(strobe);
      bool writable = false;
      uint32_t expected = before;
      for (const RegisterField& field : reg.fields) {
        const uint32_t mask = mask_of(field) & bits;
        if (field.access == Access::ReadWrite) expected = (expected & ~mask) | (data & mask);
        if (field.access == Access::Clear) expected &= ~(data & mask);
        writable = writable || field.access == Access::ReadWrite || field.access == Access::Clear;
      }
      ASSERT_EQ(c.write(reg.offset, data, strobe), writable) << reg.name;
      if (reg.name == "ERROR_FIRST") continue;
      ASSERT_EQ(c.value(reg.offset), expected) << reg.name << ", " << c.at();
    }
    for (uint64_t& line : c.in.error_lines) line = c.bench.rng() >> (64 - c.config.address_w());
    c.event(c.bench.rng() % 2 != 0, static_cast<uint32_t>(c.bench.rng()) & kGivingUp);
  }
}

TEST(ControlRegisters, RefusesWhatIsOutsideOrCannotBeWritten) {
  ControlBench c;
  std::map<int, bool> writable;
  for (const Register& reg : c.model.map.registers) {
    for (const RegisterField& field : reg.fields) {
      writable[reg.offset] |= field.access != Access::Constant && field.access != Access::Read;
    }
  }
  for (const SlotBlock& block : c.model.map.blocks) {
    for (const Slot& slot : block.slots) writable[slot.offset] = writable[slot.offset + 4] = slot.writable;
  }
  int outside = 0;
  for (int offset = 0; offset < 1 << c.model.map.address_bits; offset += 4) {
    set_paces(c, offset / 4);
    const bool there = writable.count(offset) != 0;
    const int byte = static_cast<int>(c.bench.rng() % 4);  // of the address the two low bits do not count
    const BusAnswer answer = c.read(offset + byte);
    ASSERT_EQ(answer.error, !there) << std::hex << offset;
    if (!there) { ASSERT_EQ(answer.data, 0u) << std::hex << offset; }
    ASSERT_EQ(c.write(offset + byte, 0), there && writable[offset]) << std::hex << offset;
    outside += there ? 0 : 1;
  }
  EXPECT_GT(outside, 500);
}

TEST(ControlRegisters, QueuesOneFrame) {
  for (int pace = 0; pace < 9; ++pace) {
    ControlBench c(test_seed() + static_cast<uint64_t>(pace));
    set_paces(c, pace);
    const int control = c.offset("CONTROL"), status = c.offset("STATUS"), error = c.offset("ERROR");
    const std::vector<Slot> slots = c.model.map.shadow();
    const auto fill = [&] {
      for (const Slot& slot : slots) {
        ASSERT_TRUE(c.write(slot.offset, static_cast<uint32_t>(c.bench.rng())));
        ASSERT_TRUE(c.write(slot.offset + 4, static_cast<uint32_t>(c.bench.rng())));
      }
    };
    fill();
    ASSERT_TRUE(c.write(control, kStart, 0xe));  // its byte is not written: nothing starts
    ASSERT_EQ(c.bench.dut.frame_valid_o, 0);
    ASSERT_TRUE(c.write(control, kStart));
    ASSERT_EQ(c.bench.dut.frame_valid_o, 1);
    ASSERT_EQ(c.value(control), 0u);
    ASSERT_EQ(c.value(status), 2u);
    const std::vector<uint64_t> first = c.model.shadow();
    for (const Slot& slot : slots) ASSERT_FALSE(c.write(slot.offset, ~0u)) << "a queued frame was written";
    ASSERT_EQ(c.model.shadow(), first);
    ASSERT_EQ(c.value(error), 0u);
    ASSERT_TRUE(c.write(control, kStart));
    ASSERT_EQ(c.value(error), kStartFull);
    ASSERT_EQ(c.value(c.offset("ERROR_FIRST")), 0u) << "a start has no address";
    c.event(false, 0, true);
    ASSERT_EQ(c.bench.dut.frame_valid_o, 0) << "a frame is taken once";
    c.in.busy = true;
    ASSERT_EQ(c.value(status), 1u | 4u);
    ASSERT_TRUE(c.write(error, kStartFull));
    ASSERT_EQ(c.value(status), 1u);
    ASSERT_EQ(c.value(c.offset("FRAMES_STARTED")), 1u);
    fill();  // while the first one runs
    ASSERT_TRUE(c.write(control, kStart));
    ASSERT_EQ(c.value(status), 3u);
    c.event(true, 0, true);
    ASSERT_EQ(c.value(c.offset("FRAMES_STARTED")), 2u);
    ASSERT_EQ(c.value(c.offset("FRAMES_DONE")), 1u);
    ASSERT_EQ(c.value(c.offset("IRQ_STATUS")), kFrameDone | kQueueFree | kErrorIrq);
  }
}

TEST(ControlRegisters, AbortsAndDropsTheQueue) {
  ControlBench c;
  const int control = c.offset("CONTROL"), irq = c.offset("IRQ_STATUS");
  int aborts = 0;
  c.before_edge = [&] { aborts += c.bench.dut.abort_o; };
  ASSERT_TRUE(c.write(control, kAbort));
  c.bench.step();
  ASSERT_EQ(aborts, 1) << "a pulse of one cycle";
  ASSERT_EQ(c.value(irq), 0u) << "nothing was queued";
  ASSERT_TRUE(c.write(control, kStart));
  ASSERT_EQ(c.bench.dut.frame_valid_o, 1);
  ASSERT_TRUE(c.write(control, kAbort));
  ASSERT_EQ(c.bench.dut.frame_valid_o, 0);
  ASSERT_EQ(c.value(irq), kQueueFree);
  ASSERT_EQ(c.value(c.offset("FRAMES_STARTED")), 0u);
  ASSERT_TRUE(c.write(control, kStart | kAbort));
  ASSERT_EQ(c.bench.dut.frame_valid_o, 0) << "an abort takes the start of the same write";
  c.bench.step();
  ASSERT_EQ(aborts, 3);
  ASSERT_TRUE(c.write(control, kStart));
  ASSERT_TRUE(c.write(control, kStart | kAbort));
  ASSERT_EQ(c.bench.dut.frame_valid_o, 0);
  ASSERT_EQ(c.value(c.offset("ERROR")), 0u);
}

TEST(ControlRegisters, ShowsAndSaysHowLongMemoryMayBeSilent) {
  ControlBench c;
  const int timeout = c.offset("BUS_TIMEOUT"), status = c.offset("STATUS");
  EXPECT_EQ(c.bench.dut.timeout_o, 1u << 24) << "after a reset nothing hangs for ever";
  ASSERT_TRUE(c.write(timeout, 0x12345678));
  ASSERT_TRUE(c.write(timeout, 0xffffffff, 4));
  EXPECT_EQ(c.value(timeout), 0x12ff5678u);
  EXPECT_EQ(c.bench.dut.timeout_o, 0x12ff5678u);
  for (const bool silent : {true, false}) {
    c.in.silent = silent;
    c.bench.step();
    EXPECT_EQ(c.value(status), silent ? 8u : 0u);
  }
}

TEST(ControlRegisters, RaisesTheInterruptOfWhatIsEnabled) {
  ControlBench c;
  const int status = c.offset("IRQ_STATUS"), enable = c.offset("IRQ_ENABLE");
  const auto raise = [&](uint32_t bit) {
    if (bit == kFrameDone) c.event(true, 0);
    if (bit == kErrorIrq) c.event(false, 1);
    if (bit == kQueueFree) {
      ASSERT_TRUE(c.write(c.offset("CONTROL"), kStart));
      c.event(false, 0, true);
    }
    c.bench.step();
    c.bench.step();
  };
  for (const uint32_t bit : {kFrameDone, kQueueFree, kErrorIrq}) {
    for (uint32_t enabled = 0; enabled < 8; ++enabled) {
      ASSERT_TRUE(c.write(enable, enabled));
      raise(bit);
      ASSERT_EQ(c.value(status), bit);
      ASSERT_EQ(c.bench.dut.irq_o, (enabled & bit) != 0) << "bit " << bit << ", enabled " << enabled;
      ASSERT_TRUE(c.write(status, 7 ^ bit));
      c.bench.step();
      ASSERT_EQ(c.bench.dut.irq_o, (enabled & bit) != 0) << "another bit was cleared";
      ASSERT_TRUE(c.write(status, bit));
      c.bench.step();
      ASSERT_EQ(c.bench.dut.irq_o, 0);
    }
  }
}

TEST(ControlRegisters, KeepsTheAddressOfTheFirstError) {
  ControlBench c;
  const auto first = [&] {
    return std::pair{
        c.value(c.offset("ERROR_FIRST")),
        static_cast<uint64_t>(c.value(c.offset("ERROR_ADDRESS_HIGH"))) << 32 | c.value(c.offset("ERROR_ADDRESS_LOW"))};
  };
  for (int i = 0; i < 300; ++i) {
    for (uint64_t& line : c.in.error_lines) line = c.bench.rng() >> (64 - c.config.address_w());
    const std::array<uint64_t, kErrorCauses> lines = c.in.error_lines;
    const uint32_t errors = 1 + static_cast<uint32_t>(c.bench.rng()) % kGivingUp;
    const int lowest = __builtin_ctz(errors);
    c.in.located = static_cast<uint32_t>(c.bench.rng()) & kGivingUp;
    c.event(false, errors);
    const bool located = c.in.located >> lowest & 1;  // of what is not known where it was, no address is shown
    const std::pair expected{1u | (located ? 2u : 0) | static_cast<uint32_t>(lowest) << 8,
                             located ? lines[static_cast<size_t>(lowest)] * 64 : 0};
    ASSERT_EQ(first(), expected) << c.at();
    for (uint64_t& line : c.in.error_lines) line = c.bench.rng() >> (64 - c.config.address_w());
    c.in.located ^= kGivingUp;
    c.event(false, kGivingUp);  // later ones do not replace it
    ASSERT_EQ(first(), expected) << c.at();
    ASSERT_TRUE(c.write(c.offset("ERROR"), kGivingUp - 1));
    ASSERT_EQ(first(), expected) << "one cause is left";
    ASSERT_TRUE(c.write(c.offset("ERROR"), 1));
    ASSERT_EQ(first().first & 3, 0u);
  }
}

TEST(ControlRegisters, ReadsBothWordsOfACounterOfOneMoment) {
  ControlBench c;
  c.before_edge = [&] {
    for (uint64_t& count : c.in.counters) ++count;
  };
  const uint64_t limit = uint64_t{1} << 32;
  size_t there = 0;
  for (const Slot& slot : c.model.map.block("counters").slots) {
    for (int i = 0; i < 12; ++i) {
      set_paces(c, i);
      const uint64_t begin = limit * (1 + c.bench.rng() % 200) - c.bench.rng() % 8;  // about to carry
      for (size_t j = 0; j < c.in.counters.size(); ++j) c.in.counters[j] = begin + limit * j;
      const uint64_t low = c.value(slot.offset);
      for (uint64_t wait = c.bench.rng() % 20; wait > 0; --wait) c.bench.step();
      const uint64_t found = static_cast<uint64_t>(c.value(slot.offset + 4)) << 32 | low;
      if (slot.width == 0) {
        ASSERT_EQ(found, 0u) << slot.name;
        continue;
      }
      ASSERT_GE(found, begin + limit * there) << slot.name << ", " << c.at();
      ASSERT_LE(found, c.in.counters[there]) << slot.name << ", " << c.at();
    }
    there += slot.width > 0;
  }
  ASSERT_EQ(there, c.in.counters.size());
}

// What the core shows while its reset may fall in any cycle reaches no register.
TEST(ControlRegisters, ReadsNoCounterOfACoreThatIsKeptApart) {
  ControlBench c;
  for (uint64_t& count : c.in.counters) count = c.bench.rng() >> (64 - c.config.perf_w());
  c.in.apart = true;
  for (const Slot& slot : c.model.map.block("counters").slots) {
    ASSERT_EQ(c.value(slot.offset), 0u) << slot.name;
    ASSERT_EQ(c.value(slot.offset + 4), 0u) << slot.name;
  }
}

TEST(ControlRegisters, TakesOneWriteAndOneReadPerTwoCycles) {
  ControlBench c;
  const uint64_t begin = c.bench.cycle;
  for (int i = 0; i < 100; ++i) {
    c.push_write(c.offset("IRQ_ENABLE"), static_cast<uint32_t>(i));
    c.push_read(c.offset("IRQ_ENABLE"));
  }
  c.finish();
  EXPECT_LE(c.bench.cycle - begin, 203u);
}

// Everything at once: writes and reads of all kinds, events, takes, and a reset now and then.
TEST(ControlRegisters, EqualsItsModelWhateverComes) {
  for (int pace = 0; pace < 9; ++pace) {
    ControlBench c(test_seed() + 100 + static_cast<uint64_t>(pace));
    set_paces(c, pace);
    const auto one_in = [&](uint64_t n) { return c.bench.rng() % n == 0; };
    const auto some_offset = [&] {
      const uint64_t kind = c.bench.rng() % 4;
      const uint64_t word = kind == 0   ? c.bench.rng() % 1024
                            : kind == 1 ? 128 + c.bench.rng() % 168
                                        : 4 + c.bench.rng() % 11;  // CONTROL and those behind it, most of the time
      return static_cast<int>(4 * word + c.bench.rng() % 4);
    };
    c.before_edge = [&] {
      c.in.frame_ready = one_in(pace % 2 == 0 ? 6 : 200), c.in.busy = one_in(2), c.in.frame_done = one_in(5);
      c.in.apart = one_in(9);
      c.in.errors =
          one_in(12) ? static_cast<uint32_t>(c.bench.rng()) & static_cast<uint32_t>(c.bench.rng()) & kGivingUp : 0;
      c.in.located = static_cast<uint32_t>(c.bench.rng()) & kGivingUp, c.in.silent = one_in(3);
      for (uint64_t& line : c.in.error_lines) line = c.bench.rng() >> (64 - c.config.address_w());
      for (uint64_t& count : c.in.counters) count = c.bench.rng() >> (64 - c.config.perf_w());
    };
    for (int round = 0; round < 20 && !testing::Test::HasFailure(); ++round) {
      for (int i = 0; i < 60; ++i) {
        c.push_write(some_offset(), static_cast<uint32_t>(c.bench.rng()), static_cast<uint32_t>(c.bench.rng()) & 15);
        c.push_read(some_offset());
      }
      if (round % 5 == 4) {
        for (uint64_t i = c.bench.rng() % 200; i > 0; --i) c.bench.step();
        c.reset();
      } else {
        c.finish();
      }
    }
  }
}

}  // namespace
}  // namespace pipegs
