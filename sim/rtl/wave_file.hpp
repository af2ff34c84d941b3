// SPDX-License-Identifier: Apache-2.0
// wave_file.hpp: the waves of a Verilated module, of all cycles, of a range or of samples of them.
//
// Errors  OwnFailure when the disk does not take them (wave_disk.cpp): with the next cycle, or when the file is closed.
#pragma once

#include <verilated.h>
#if VM_TRACE
#include <verilated_fst_c.h>
#endif

#include <cstring>
#include <memory>
#include <stdexcept>

#include "scenes/own_failure.hpp"
#include "sim/rtl/rtl_model.hpp"

namespace pipegs {

inline int wave_error = 0;  // the first one, of errno

// The file of waves; nothing without a path, and in a variant that has no waves only that.
template <class Dut>
class WaveFile {
 public:
#if VM_TRACE
  WaveFile(Dut& top, const RtlOptions& options) : options_(options) {
    if (options.waves.empty()) return;
    wave_error = 0;
    file_ = std::make_unique<VerilatedFstC>();
    top.trace(file_.get(), 99);
    file_->open(options.waves.c_str());
  }
  // `counted` is the cycle as a range counts it.
  void dump_low(uint64_t cycle, int64_t counted) {
    if (file_ && shows(cycle, counted)) dump(cycle * kWaveTime);
  }
  // Of the cycle before a sample too: the change to its first low phase is a part of the sample.
  void dump_high(uint64_t cycle, int64_t counted) {
    if (file_ && (shows(cycle, counted) || shows(cycle + 1, counted + 1))) dump(cycle * kWaveTime + kWaveTime / 2);
  }
  void close() {
    if (file_) file_->close();
    check();
  }

 private:
  bool shows(uint64_t cycle, int64_t counted) const {
    return in_sample(options_, cycle) && (!options_.wave_range || options_.wave_range->holds(counted));
  }
  void dump(uint64_t time) {
    file_->dump(time);
    check();
  }
  static void check() {
    if (wave_error != 0) throw OwnFailure(std::string("the waves cannot be written: ") + std::strerror(wave_error));
  }

  const RtlOptions& options_;
  std::unique_ptr<VerilatedFstC> file_;
#else
  WaveFile(Dut&, const RtlOptions& options) {
    if (!options.waves.empty()) throw std::logic_error("RTL: waves of a variant that was built without them");
  }
  void dump_low(uint64_t, int64_t) {}
  void dump_high(uint64_t, int64_t) {}
  void close() {}
#endif
};

}  // namespace pipegs
