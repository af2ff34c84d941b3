// SPDX-License-Identifier: Apache-2.0
// driver_test: cpp_model/driver/pipegs.c on the model of the registers: identity, every slot, the queue, waiting by
// polls and by interrupt, abort, errors and their text, counters.
#include "verif/control/driver_bus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "verif/support/config.hpp"

namespace pipegs {
namespace {

uint64_t seed() {
  const char* text = std::getenv("PIPEGS_SEED");
  return text != nullptr ? std::strtoull(text, nullptr, 0) : 1;
}

struct Driver : testing::Test {
  Config config = test_config();
  DriverBus machine{config, seed()};
  pipegs_device device{};

  void SetUp() override { identify(false); }
  void identify(bool with_idle) {
    const pipegs_bus bus = machine.bus(with_idle);
    ASSERT_EQ(pipegs_identify(&device, &bus), PIPEGS_OK);
  }
  // Values that the slots can hold: what is written is what is read.
  pipegs_job random_job() {
    pipegs_job job{};
    auto* const words = reinterpret_cast<uint64_t*>(&job);
    const std::vector<Slot> slots = machine.model.map.shadow();
    EXPECT_EQ(slots.size(), size_t{PIPEGS_JOB_SLOTS});
    for (size_t i = 0; i < slots.size(); ++i) {
      const Slot& slot = slots[i];
      if (slot.width == 0) continue;
      const int unused = 64 - slot.width;
      const uint64_t value = machine.rng();
      words[i] =
          slot.is_signed ? static_cast<uint64_t>(static_cast<int64_t>(value) >> unused) : value >> unused << slot.shift;
    }
    return job;
  }
  // What the machine took, as the slots hold it.
  void expect_taken(const pipegs_job& job, const std::vector<uint64_t>& taken) {
    const auto* const words = reinterpret_cast<const uint64_t*>(&job);
    const std::vector<Slot> slots = machine.model.map.shadow();
    ASSERT_EQ(taken.size(), slots.size());
    for (size_t i = 0; i < slots.size(); ++i) {
      const uint64_t bits = slots[i].width == 0 ? 0 : ~uint64_t{0} >> (64 - slots[i].width);
      ASSERT_EQ(taken[i], (words[i] >> slots[i].shift) & bits) << slots[i].name << ", seed " << seed();
    }
  }
};

TEST_F(Driver, ReadsTheConfigurationOfTheMachine) {
  std::vector<std::pair<std::string, uint32_t>> found;
#define FOUND(name, offset, low, width) found.emplace_back(#name, device.config.name);
  PIPEGS_CONFIGURATION(FOUND)
#undef FOUND
  size_t i = 0;
  for (const Register& reg : machine.model.map.registers) {
    if (reg.name.rfind("CONFIG_", 0) != 0) continue;
    for (const RegisterField& field : reg.fields) {
      ASSERT_LT(i, found.size());
      EXPECT_EQ(found[i].first, reg.name == "CONFIG_HASH" ? "config_hash" : field.name);
      EXPECT_EQ(found[i].second, field.value) << reg.name << "." << field.name;
      ++i;
    }
  }
  EXPECT_EQ(i, found.size());
  EXPECT_EQ(device.config.world_w, static_cast<uint32_t>(config.world_w));
  EXPECT_EQ(device.config.window, static_cast<uint32_t>(config.window));
}

TEST_F(Driver, RefusesAnotherMachine) {
  struct Other {
    DriverBus& machine;
    uint32_t offset, flip;
  } other{machine, PIPEGS_ID, 1};
  const pipegs_bus bus = {[](void* self, uint32_t offset) {
                            Other& o = *static_cast<Other*>(self);
                            return o.machine.read(offset) ^ (offset == o.offset ? o.flip : 0);
                          },
                          [](void*, uint32_t, uint32_t) { ADD_FAILURE() << "an unknown machine was written to"; },
                          nullptr, &other};
  EXPECT_EQ(pipegs_identify(&device, &bus), PIPEGS_NO_MACHINE);
  other.offset = PIPEGS_LAYOUT, other.flip = 1u << 31;
  EXPECT_EQ(pipegs_identify(&device, &bus), PIPEGS_OTHER_LAYOUT);
  other.offset = PIPEGS_VERSION, other.flip = 1u << 16;
  EXPECT_EQ(pipegs_identify(&device, &bus), PIPEGS_OTHER_LAYOUT);
  other.flip = 1;  // something was added
  EXPECT_EQ(pipegs_identify(&device, &bus), PIPEGS_OK);
}

TEST_F(Driver, ReachesMemoryMappedRegisters) {
  std::vector<uint32_t> memory(1024);
  const pipegs_bus bus = pipegs_memory_mapped(memory.data());
  for (uint32_t offset = 0; offset < 4096; offset += 4) bus.write(bus.context, offset, offset * 77);
  for (uint32_t offset = 0; offset < 4096; offset += 4) {
    ASSERT_EQ(memory[offset / 4], offset * 77);
    ASSERT_EQ(bus.read(bus.context, offset), offset * 77);
  }
  EXPECT_EQ(bus.idle, nullptr);
}

TEST_F(Driver, WritesAndReadsBackEverySlot) {
  for (int round = 0; round < 20; ++round) {
    const pipegs_job job = random_job();
    pipegs_write(&device, &job, round % 2 == 0);
    const auto* const words = reinterpret_cast<const uint64_t*>(&job);
    const std::vector<Slot> slots = machine.model.map.shadow();
    for (size_t i = 0; i < slots.size(); ++i) {
      ASSERT_EQ(pipegs_counter(&device, static_cast<uint32_t>(slots[i].offset)), words[i]) << slots[i].name;
    }
  }
}

TEST_F(Driver, WritesOnlyTheWordsThatChanged) {
  pipegs_job job = random_job();
  const auto written = [&](bool all) {
    machine.writes.clear();
    pipegs_write(&device, &job, all);
    return machine.writes;
  };
  EXPECT_EQ(written(false).size(), size_t{2 * PIPEGS_JOB_SLOTS}) << "nothing is known of a new device";
  EXPECT_TRUE(written(false).empty());
  EXPECT_EQ(written(true).size(), size_t{2 * PIPEGS_JOB_SLOTS});
  job.frame.camera_position_y ^= 1;
  job.areas.overflow ^= uint64_t{1} << 32;
  job.picture.stride ^= 64;
  EXPECT_EQ(written(false),
            (std::vector<uint32_t>{PIPEGS_FRAME_CAMERA_POSITION_Y, PIPEGS_AREAS_OVERFLOW + 4, PIPEGS_PICTURE_STRIDE}));
  machine.model.reset();
  identify(false);
  EXPECT_EQ(written(false).size(), size_t{2 * PIPEGS_JOB_SLOTS}) << "a reset cleared the slots";
}

// Many frames, one queued while one runs; each is taken as it was given, and its ticket tells when it is done.
TEST_F(Driver, RendersFramesOneAfterTheOther) {
  for (const bool with_idle : {false, true}) {
    identify(with_idle);
    pipegs_enable(&device, PIPEGS_IRQ_ENABLE_FRAME_DONE | PIPEGS_IRQ_ENABLE_QUEUE_FREE | PIPEGS_IRQ_ENABLE_ERROR);
    machine.frames.clear();
    machine.idles = 0;
    std::vector<pipegs_job> jobs;
    std::vector<uint32_t> tickets;
    for (int i = 0; i < 40; ++i) {
      jobs.push_back(random_job());
      if (i % 5 == 4) jobs.back() = jobs[jobs.size() - 2];
      tickets.emplace_back();
      ASSERT_EQ(pipegs_queue(&device, &jobs.back(), PIPEGS_NO_LIMIT, &tickets.back()), PIPEGS_OK);
      if (i % 3 == 2) {
        ASSERT_EQ(pipegs_wait(&device, tickets[tickets.size() - 2], PIPEGS_NO_LIMIT), PIPEGS_OK);
        ASSERT_EQ(pipegs_done(&device, tickets[0]), PIPEGS_OK);
      }
    }
    ASSERT_EQ(pipegs_wait(&device, tickets.back(), PIPEGS_NO_LIMIT), PIPEGS_OK);
    ASSERT_EQ(machine.done, tickets.back());
    ASSERT_EQ(machine.frames.size(), jobs.size());
    for (size_t i = 0; i < jobs.size(); ++i) expect_taken(jobs[i], machine.frames[i]);
    EXPECT_EQ(machine.idles > 0, with_idle);
    EXPECT_LE(machine.idles, 120) << "three events a frame: each is cleared, else there is nothing to sleep for";
    EXPECT_EQ(pipegs_get_error(&device).causes, 0u);
  }
}

TEST_F(Driver, TellsThatTheQueueIsFull) {
  machine.takes = false;
  const pipegs_job job = random_job();
  uint32_t ticket = 0, other = 77;
  EXPECT_TRUE(pipegs_queue_free(&device));
  ASSERT_EQ(pipegs_queue(&device, &job, 1, &ticket), PIPEGS_OK);
  EXPECT_FALSE(pipegs_queue_free(&device));
  machine.writes.clear();
  const int before = machine.reads;
  ASSERT_EQ(pipegs_queue(&device, &job, 5, &other), PIPEGS_FULL);
  EXPECT_EQ(machine.reads - before, 5);
  EXPECT_TRUE(machine.writes.empty()) << "a queued frame was touched";
  EXPECT_EQ(other, 77u);
  EXPECT_EQ(pipegs_done(&device, ticket), PIPEGS_PENDING);
  EXPECT_EQ(pipegs_wait(&device, ticket, 3), PIPEGS_TIMEOUT);
  machine.takes = true;
  EXPECT_EQ(pipegs_wait(&device, ticket, PIPEGS_NO_LIMIT), PIPEGS_OK);
  pipegs_start(&device);
  machine.takes = false;
  pipegs_start(&device);
  pipegs_start(&device);  // one of the three finds the queue full
  EXPECT_EQ(pipegs_get_error(&device).causes, PIPEGS_ERROR_START_FULL);
  EXPECT_EQ(pipegs_queue(&device, &job, 5, &other), PIPEGS_FAILED);
}

TEST_F(Driver, TellsAHandlerWhatHappened) {
  pipegs_enable(&device, PIPEGS_IRQ_ENABLE_FRAME_DONE);
  EXPECT_EQ(pipegs_interrupt(&device), 0u);
  const pipegs_job job = random_job();
  uint32_t ticket = 0;
  ASSERT_EQ(pipegs_queue(&device, &job, PIPEGS_NO_LIMIT, &ticket), PIPEGS_OK);
  machine.idle();
  EXPECT_EQ(pipegs_interrupt(&device), PIPEGS_IRQ_STATUS_FRAME_DONE | PIPEGS_IRQ_STATUS_QUEUE_FREE);
  EXPECT_EQ(pipegs_done(&device, ticket), PIPEGS_OK);
  EXPECT_EQ(pipegs_interrupt(&device), 0u);
  EXPECT_FALSE(machine.model.outputs().irq);
  pipegs_enable(&device, PIPEGS_IRQ_ENABLE_ERROR);
  machine.errors = PIPEGS_ERROR_AREA_FULL;
  machine.idle();
  EXPECT_EQ(pipegs_interrupt(&device), PIPEGS_IRQ_STATUS_ERROR);
}

TEST_F(Driver, AbortsWhatRunsAndWhatIsQueued) {
  for (int round = 0; round < 30; ++round) {
    const pipegs_job job = random_job();
    uint32_t ticket = 0;
    for (int i = 0; i < 1 + round % 3; ++i) {
      ASSERT_EQ(pipegs_queue(&device, &job, PIPEGS_NO_LIMIT, &ticket), PIPEGS_OK);
    }
    for (uint64_t wait = machine.rng() % 50; wait > 0; --wait) machine.step();
    ASSERT_EQ(pipegs_abort(&device, PIPEGS_NO_LIMIT), PIPEGS_OK);
    ASSERT_EQ(machine.aborts, round + 1);
    ASSERT_FALSE(machine.in.busy);
    ASSERT_TRUE(pipegs_queue_free(&device));
    // The next frame counts from here.
    const uint32_t done = machine.done;
    ASSERT_EQ(pipegs_queue(&device, &job, PIPEGS_NO_LIMIT, &ticket), PIPEGS_OK);
    ASSERT_EQ(ticket, done + 1);
    ASSERT_EQ(pipegs_wait(&device, ticket, PIPEGS_NO_LIMIT), PIPEGS_OK);
  }
  // Another's abort, of which this driver knows nothing.
  const pipegs_job job = random_job();
  uint32_t ticket = 0;
  machine.takes = false;
  ASSERT_EQ(pipegs_queue(&device, &job, PIPEGS_NO_LIMIT, &ticket), PIPEGS_OK);
  machine.write(PIPEGS_CONTROL, PIPEGS_CONTROL_ABORT_ALL);
  EXPECT_EQ(pipegs_wait(&device, ticket, PIPEGS_NO_LIMIT), PIPEGS_GIVEN_UP);
}

// As many looks as were granted, then the caller has it back; later it can try again.
TEST_F(Driver, AnAbortThatDoesNotEndTimesOut) {
  const pipegs_job job = random_job();
  uint32_t ticket = 0;
  machine.answers = false;
  ASSERT_EQ(pipegs_queue(&device, &job, PIPEGS_NO_LIMIT, &ticket), PIPEGS_OK);
  while (!machine.in.busy) machine.step();
  for (const uint32_t polls : {1u, 2u, 50u}) {
    const int before = machine.reads;
    ASSERT_EQ(pipegs_abort(&device, polls), PIPEGS_TIMEOUT);
    ASSERT_EQ(machine.reads - before, static_cast<int>(polls));
  }
  machine.answers = true;
  ASSERT_EQ(pipegs_abort(&device, PIPEGS_NO_LIMIT), PIPEGS_OK);
  ASSERT_EQ(pipegs_queue(&device, &job, PIPEGS_NO_LIMIT, &ticket), PIPEGS_OK);
  ASSERT_EQ(pipegs_wait(&device, ticket, PIPEGS_NO_LIMIT), PIPEGS_OK);
}

// No wait is without an end when memory falls silent, by polls or by interrupt, and the frame behind it is rendered.
TEST_F(Driver, GetsOverAMemoryThatFallsSilent) {
  const pipegs_job job = random_job();
  for (int round = 0; round < 20; ++round) {
    identify(round % 2 != 0);
    const uint32_t limit = 1 + static_cast<uint32_t>(machine.rng() % 2000);
    pipegs_set_timeout(&device, limit);
    pipegs_enable(&device, PIPEGS_IRQ_ENABLE_FRAME_DONE | PIPEGS_IRQ_ENABLE_QUEUE_FREE | PIPEGS_IRQ_ENABLE_ERROR);
    ASSERT_FALSE(pipegs_silent(&device));
    machine.answers = false;
    uint32_t ticket = 0;
    ASSERT_EQ(pipegs_queue(&device, &job, PIPEGS_NO_LIMIT, &ticket), PIPEGS_OK);
    ASSERT_EQ(pipegs_wait(&device, ticket, PIPEGS_NO_LIMIT), PIPEGS_FAILED);
    ASSERT_TRUE(pipegs_silent(&device));
    pipegs_error error = pipegs_get_error(&device);
    ASSERT_EQ(error.causes, PIPEGS_ERROR_READ_TIMEOUT);
    ASSERT_FALSE(error.has_address);
    ASSERT_EQ(pipegs_abort(&device, PIPEGS_NO_LIMIT), PIPEGS_OK) << "nobody waits for what a silent memory owes";
    pipegs_clear_error(&device, error.causes);
    // A frame that is queued in the silence fails, too.
    if (pipegs_queue(&device, &job, PIPEGS_NO_LIMIT, &ticket) == PIPEGS_OK) {
      ASSERT_EQ(pipegs_wait(&device, ticket, PIPEGS_NO_LIMIT), PIPEGS_FAILED);
    }
    ASSERT_EQ(pipegs_abort(&device, PIPEGS_NO_LIMIT), PIPEGS_OK);
    machine.answers = true;
    while (pipegs_silent(&device)) {}
    pipegs_clear_error(&device, pipegs_get_error(&device).causes);
    ASSERT_EQ(pipegs_queue(&device, &job, PIPEGS_NO_LIMIT, &ticket), PIPEGS_OK);
    ASSERT_EQ(pipegs_wait(&device, ticket, PIPEGS_NO_LIMIT), PIPEGS_OK);
  }
}

// Without a time-out of the bus only the caller's limit ends a wait.
TEST_F(Driver, WaitsForEverWithoutATimeOut) {
  const pipegs_job job = random_job();
  pipegs_set_timeout(&device, 0);
  uint32_t ticket = 0;
  machine.answers = false;
  ASSERT_EQ(pipegs_queue(&device, &job, PIPEGS_NO_LIMIT, &ticket), PIPEGS_OK);
  ASSERT_EQ(pipegs_wait(&device, ticket, 2000), PIPEGS_TIMEOUT);
  ASSERT_EQ(pipegs_abort(&device, 2000), PIPEGS_TIMEOUT);
  ASSERT_FALSE(pipegs_silent(&device));
}

TEST_F(Driver, TellsErrorsWithTheirFirstAddress) {
  char text[400];
  pipegs_error error = pipegs_get_error(&device);
  EXPECT_EQ(error.causes, 0u);
  pipegs_error_text(&error, text, sizeof text);
  EXPECT_STREQ(text, "no error");
  for (uint32_t first = 0; first < kErrorCauses; ++first) {
    const uint64_t line = machine.rng() >> (64 - config.address_w());
    machine.in.error_lines.fill(0);
    machine.in.error_lines[first] = line;
    const bool located = first > 1;  // the line of a read that fails is not known
    machine.in.located = located ? 1u << first : 0;
    machine.errors = 1u << first;
    machine.step();
    machine.errors = PIPEGS_ERROR_WRITE_DECERR;
    machine.step();
    uint32_t ticket = 0;
    const pipegs_job job = random_job();
    ASSERT_EQ(pipegs_queue(&device, &job, PIPEGS_NO_LIMIT, &ticket), PIPEGS_FAILED);
    ASSERT_EQ(pipegs_wait(&device, ticket, PIPEGS_NO_LIMIT), PIPEGS_FAILED);
    error = pipegs_get_error(&device);
    EXPECT_EQ(error.causes, 1u << first | PIPEGS_ERROR_WRITE_DECERR);
    ASSERT_EQ(error.has_address, located);
    EXPECT_EQ(error.first, first);
    EXPECT_EQ(error.address, located ? line * 64 : 0);
    const std::string whole =
        "; first: " + std::string(pipegs_cause_text(first)) + (located ? fmt::format(", at {:#x}", line * 64) : "");
    const size_t length = pipegs_error_text(&error, text, sizeof text);
    EXPECT_EQ(length, std::strlen(text));
    EXPECT_NE(std::string(text).find(whole), std::string::npos) << text;
    EXPECT_EQ(std::string(text).find(", at ") != std::string::npos, located) << text;
    EXPECT_NE(std::string(text).find(pipegs_cause_text(3)), std::string::npos) << text;
    for (const size_t size : {size_t{0}, size_t{1}, size_t{20}, length, length + 1}) {
      std::string cut(size + 1, '#');
      ASSERT_EQ(pipegs_error_text(&error, cut.data(), size), length);
      ASSERT_EQ(cut[size], '#') << "written beyond the end";
      if (size > 0) ASSERT_STREQ(cut.c_str(), std::string(text).substr(0, std::min(size - 1, length)).c_str());
    }
    ASSERT_EQ(pipegs_abort(&device, PIPEGS_NO_LIMIT), PIPEGS_OK);
    pipegs_clear_error(&device, error.causes);
    EXPECT_EQ(pipegs_get_error(&device).causes, 0u);
    EXPECT_EQ(pipegs_interrupt(&device) & PIPEGS_IRQ_STATUS_ERROR, 0u);
    ASSERT_EQ(pipegs_queue(&device, &job, PIPEGS_NO_LIMIT, &ticket), PIPEGS_OK);
    ASSERT_EQ(pipegs_wait(&device, ticket, PIPEGS_NO_LIMIT), PIPEGS_OK);
  }
  for (const Register& reg : machine.model.map.registers) {
    if (reg.name != "ERROR") continue;
    for (const RegisterField& field : reg.fields) {
      EXPECT_EQ(pipegs_cause_text(static_cast<uint32_t>(field.low)), field.what);
    }
  }
  EXPECT_STREQ(pipegs_cause_text(31), "an error that this driver does not know");
}

// A counter of which the low word is about to carry is read whole; one that the machine has not reads 0.
TEST_F(Driver, ReadsCountersOf64Bits) {
  const std::vector<Slot>& slots = machine.model.map.block("counters").slots;
  for (int round = 0; round < 50; ++round) {
    for (size_t i = 0; i < machine.in.counters.size(); ++i) {
      machine.in.counters[i] = ((round + i + 1) << 32) - machine.rng() % 2000;
    }
    const std::vector<uint64_t> before = machine.in.counters;
    pipegs_counters counters;
    pipegs_get_counters(&device, &counters);
    const auto* const found = reinterpret_cast<const uint64_t*>(&counters);
    ASSERT_EQ(slots.size(), size_t{PIPEGS_COUNTERS_SLOTS});
    for (size_t i = 0, there = 0; i < slots.size(); ++i) {
      if (slots[i].width == 0) {
        ASSERT_EQ(found[i], 0u) << slots[i].name;
        continue;
      }
      ASSERT_GT(found[i], before[there]) << slots[i].name;
      ASSERT_LT(found[i], machine.in.counters[there]) << slots[i].name;
      ++there;
    }
  }
}

}  // namespace
}  // namespace pipegs
