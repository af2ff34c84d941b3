// SPDX-License-Identifier: Apache-2.0
// driver_bus.hpp: the bit-accurate model of the registers as the driver's bus, and a machine behind it.
//
// Each access is a handshake of AXI4-Lite whose pauses are random. The machine takes a queued frame, works for a random
// number of cycles on it, one frame at a time, and gives it up when the registers tell it to, or when its memory is
// silent for too long. A refused access is an error of the driver: the test fails.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <vector>

#include "cpp_model/control/control_registers.hpp"
#include "cpp_model/control/control_watch.hpp"
#include "cpp_model/driver/pipegs.h"

namespace pipegs {

class DriverBus {
 public:
  explicit DriverBus(const Config& config, uint64_t seed) : rng(seed), model(config) {
    in.counters.assign(3 + kUnitStates * static_cast<size_t>(1 + 3 * config.units), 0);
  }

  pipegs_bus bus(bool with_idle) {
    return {[](void* self, uint32_t offset) { return static_cast<DriverBus*>(self)->read(offset); },
            [](void* self, uint32_t offset, uint32_t value) { static_cast<DriverBus*>(self)->write(offset, value); },
            with_idle ? [](void* self) { static_cast<DriverBus*>(self)->idle(); } : nullptr, this};
  }

  uint32_t read(uint32_t offset) {
    ++reads;
    in.ar_valid = pause(), in.ar_address = offset;
    while (!(in.ar_valid && model.outputs().ar_ready)) step(), in.ar_valid = true;
    step(), in.ar_valid = false;
    in.r_ready = pause();
    while (!(in.r_ready && model.outputs().r_valid)) step(), in.r_ready = pause();
    const ControlOutputs out = model.outputs();
    EXPECT_FALSE(out.r_error) << "read of " << std::hex << offset;
    step(), in.r_ready = false;
    return out.r_data;
  }

  void write(uint32_t offset, uint32_t value) {
    writes.push_back(offset);
    in.aw_valid = in.w_valid = true, in.aw_address = offset, in.w_data = value, in.w_strobe = 15;
    while (in.aw_valid || in.w_valid) {
      const ControlOutputs out = model.outputs();
      step();
      if (out.aw_ready) in.aw_valid = false;
      if (out.w_ready) in.w_valid = false;
    }
    in.b_ready = pause();
    while (!(in.b_ready && model.outputs().b_valid)) step(), in.b_ready = pause();
    EXPECT_FALSE(model.outputs().b_error) << "write of " << std::hex << offset;
    step(), in.b_ready = false;
  }

  // Returns when the interrupt is high. One that never comes is a wait without end.
  void idle() {
    ++idles;
    for (int i = 0; i < kNever && !model.outputs().irq; ++i) step();
    ASSERT_TRUE(model.outputs().irq) << "idle, and no interrupt comes";
  }

  void step() {
    const ControlOutputs out = model.outputs();
    const bool gives_up = out.abort || watch_.tell();
    in.silent = watch_.silent();
    in.busy = left_ > 0 || (draining_ > 0 && !watch_.silent());
    in.frame_ready = left_ == 0 && draining_ == 0 && takes && rng() % 4 == 0;
    in.frame_done = left_ == 1 && takes && answers;
    in.errors = errors | (watch_.tell() ? PIPEGS_ERROR_READ_TIMEOUT : 0), errors = 0;
    watch_.step(out.timeout, left_ > 0 || draining_ > 0, answers);
    if (left_ > 0 && (left_ > 1 || takes) && answers) --left_;
    if (out.frame_valid && in.frame_ready) {
      frames.push_back(model.shadow());
      left_ = 1 + static_cast<int>(rng() % 300);
    }
    if (draining_ > 0 && answers) --draining_;
    if (gives_up) {
      if (left_ > 0) draining_ = 1 + static_cast<int>(rng() % 100);  // what was asked of memory still comes
      left_ = 0, in.frame_done = false;
    }
    aborts += out.abort;
    if (in.frame_done) ++done;
    for (uint64_t& count : in.counters) count = (count + 1) & ((uint64_t{1} << 40) - 1);
    if (at_step) at_step();
    model.step(in);
  }

  std::mt19937_64 rng;
  ControlRegisters model;
  ControlInputs in;
  bool takes = true;    // false: it neither takes nor finishes a frame
  bool answers = true;  // false: its memory is silent
  uint32_t errors = 0;  // that come in the next cycle
  std::function<void()> at_step;
  int reads = 0, idles = 0, aborts = 0;
  uint32_t done = 0;
  std::vector<uint32_t> writes;               // offsets
  std::vector<std::vector<uint64_t>> frames;  // what was taken

 private:
  static constexpr int kNever = 100000;
  bool pause() { return rng() % 3 != 0; }
  int left_ = 0, draining_ = 0;
  ControlWatch watch_;
};

}  // namespace pipegs
