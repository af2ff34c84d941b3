// SPDX-License-Identifier: Apache-2.0
// rtl_bridge.cpp: the loop that clocks the Verilated top level, compiled once for each configuration into librtl.so.
//
// In each cycle the external memory shows its answer and its readiness while the clock is low; the machine settles; the
// taps and the memory port are sampled; the clock rises.
#include <verilated.h>
#if VM_TRACE
#include <verilated_fst_c.h>
#endif

#include <cstring>
#include <stdexcept>

#include "Vpipegs_top.h"
#include "cpp_model/records.hpp"
#include "sim/rtl/ports.hpp"
#include "sim/rtl/rtl_fault.hpp"
#include "sim/rtl/rtl_model.hpp"

namespace pipegs {
namespace {

// The widths and counts that the ports were built with.
struct Widths {
  explicit Widths(const Config& c)
      : units(c.units),
        tap_lanes(c.tap_lanes()),
        splat(record_width<Splat>(c)),
        sorted(record_width<Sorted>(c)),
        request(record_width<MemoryRequest>(c)),
        kind(c.kind_w()),
        region(c.region_w()),
        index(c.tap_index_w()),
        window(c.window_w()),
        line(c.tap_line_w()),
        pixels(c.tap_word_w()),
        address(c.address_w()),
        tag(c.tag_w()),
        perf(c.perf_w()),
        pixel_lines(c.region_lines() * c.regions()),
        taps(c.taps != 0) {}
  int units, tap_lanes, splat, sorted, request, kind, region, index, window, line, pixels, address, tag, perf;
  int pixel_lines;  // in memory, of a window inside the image
  bool taps;        // the streams show
};

constexpr uint64_t kResetCycles = 4;
constexpr int64_t kRestartCycle = kResetCycles + 1;  // a frame is offered with the first cycle behind the reset

// The file of waves; nothing without a path, and in a variant that has no waves only that.
class Waves {
 public:
#if VM_TRACE
  Waves(Vpipegs_top& top, const RtlOptions& options) : options_(options) {
    if (options.waves.empty()) return;
    file_ = std::make_unique<VerilatedFstC>();
    top.trace(file_.get(), 99);
    file_->open(options.waves.c_str());
  }
  void dump_low(uint64_t cycle) {
    if (file_ && in_sample(options_, cycle)) file_->dump(cycle * 10);
  }
  // Of the cycle before a sample too: the change to its first low phase is a part of the sample.
  void dump_high(uint64_t cycle) {
    if (file_ && (in_sample(options_, cycle) || in_sample(options_, cycle + 1))) file_->dump(cycle * 10 + 5);
  }
  void close() {
    if (file_) file_->close();
  }

 private:
  const RtlOptions& options_;
  std::unique_ptr<VerilatedFstC> file_;
#else
  Waves(Vpipegs_top&, const RtlOptions& options) {
    if (!options.waves.empty()) throw std::logic_error("RTL: waves of a variant that was built without them");
  }
  void dump_low(uint64_t) {}
  void dump_high(uint64_t) {}
  void close() {}
#endif
};

class VerilatedMachine final : public RtlModel {
 public:
  explicit VerilatedMachine(const Config& config) : w_(config) {}
  RtlResult run(const std::vector<FrameWords>& frames, ExternalMemory& memory, const RtlOptions& options, RtlTaps* taps,
                const std::function<bool(uint64_t, uint64_t)>& progress) override;

 private:
  void tap(RtlTaps& taps);
  void tap_cycle(RtlTaps& taps);
  RtlResult counters();
  [[noreturn]] void fail() const;
  std::string position() const { return "cycle " + std::to_string(cycle_); }

  const Widths w_;
  std::unique_ptr<VerilatedContext> context_;
  std::unique_ptr<Vpipegs_top> dut_;
  uint64_t cycle_ = 0, windows_ = 0;
  bool running_ = false;  // the machine was busy in the cycle before; its first cycle restarts the counters
  uint64_t counted_ = 0;  // cycles that they have counted
};

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

void VerilatedMachine::tap(RtlTaps& taps) {
  const Vpipegs_top& top = *dut_;
  uint32_t words[64];
  for (int unit = 0; unit < w_.units; ++unit) {
    if (top.tap_splat_valid_o >> unit & 1) {
      slice(top.tap_splat_o, unit * w_.splat, w_.splat, words);
      taps.on_splat(unit, words);
    }
  }
  if (top.tap_sorted_valid_o) {
    slice(top.tap_sorted_o, 0, w_.sorted, words);
    taps.on_sorted(words);
    if (get_bits(words, 0, w_.kind) == kWindowEnd) ++windows_;
  }
  for (int lane = 0; lane < w_.units * w_.tap_lanes; ++lane) {
    // A line is taken with its last quarter, in the cycle in which its first quarter is written back.
    uint32_t region, quarter;
    if (top.tap_alphas_valid_o >> lane & 1) {
      uint32_t index, window_x, window_y;
      slice(top.tap_window_x_o, lane / w_.tap_lanes * w_.window, w_.window, &window_x);
      slice(top.tap_window_y_o, lane / w_.tap_lanes * w_.window, w_.window, &window_y);
      slice(top.tap_alphas_region_o, lane * w_.region, w_.region, &region);
      slice(top.tap_alphas_quarter_o, lane * 2, 2, &quarter);
      slice(top.tap_alphas_index_o, lane * w_.index, w_.index, &index);
      slice(top.tap_alphas_o, lane * w_.line, w_.line, words);
      taps.on_alphas(lane, window_x, window_y, index, static_cast<int>(region), static_cast<int>(quarter), words);
    }
    if (top.tap_pixels_valid_o >> lane & 1) {
      slice(top.tap_pixels_region_o, lane * w_.region, w_.region, &region);
      slice(top.tap_pixels_quarter_o, lane * 2, 2, &quarter);
      slice(top.tap_pixels_o, lane * w_.pixels, w_.pixels, words);
      taps.on_pixels(lane, static_cast<int>(region), static_cast<int>(quarter), words);
    }
  }
}

// What each unit does in this cycle, and the pulses that no stream shows.
void VerilatedMachine::tap_cycle(RtlTaps& taps) {
  const Vpipegs_top& top = *dut_;
  if (running_ && top.busy_o) {
    uint8_t states[1 + 3 * 4];
    for (int unit = 0; unit < 1 + 3 * w_.units; ++unit)
      states[unit] = static_cast<uint8_t>(top.tap_state_o >> (2 * unit) & 3);
    taps.on_cycle(counted_++, states);
  }
  running_ = top.busy_o;
  for (int unit = 0; unit < w_.units; ++unit) {
    if (top.tap_chunk_valid_o >> unit & 1) taps.on_chunk(unit, static_cast<int>(top.tap_chunk_kind_o));
    if (top.tap_layer_done_o >> unit & 1) taps.on_layer_done(unit, top.tap_window_done_o >> unit & 1);
  }
}

RtlResult VerilatedMachine::run(const std::vector<FrameWords>& frames, ExternalMemory& memory,
                                const RtlOptions& options, RtlTaps* taps,
                                const std::function<bool(uint64_t, uint64_t)>& progress) {
  context_ = std::make_unique<VerilatedContext>();
  context_->threads(PIPEGS_THREADS);
  context_->randReset(2);
  context_->randSeed(static_cast<int>(options.seed % 0x7ffffffe) + 1);
  context_->traceEverOn(!options.waves.empty());
  Verilated::threadContextp(context_.get());  // that of units which are libraries of their own
  dut_ = std::make_unique<Vpipegs_top>(context_.get());
  Vpipegs_top& top = *dut_;
  Waves waves(top, options);
  cycle_ = windows_ = counted_ = 0;
  running_ = false;
  const bool streams = taps != nullptr && w_.taps, cycles = streams && taps->wants_cycles();
  uint64_t last_request = 0, pixel_lines = 0;
  size_t taken = 0;
  std::vector<uint64_t> ends;

  top.test_en_i = 0;
  top.frame_valid_i = 0;
  top.mem_ready_i = 0;
  top.mem_rsp_valid_i = 0;
  // Before the reset everything is noise: it falls once, and assertions count from its end on.
  context_->assertOn(false);
  top.clk_i = 0;
  top.rst_ni = 1;
  top.eval();
  for (;; ++cycle_) {
    top.clk_i = 0;
    top.rst_ni = cycle_ >= kResetCycles;
    if (cycle_ == kResetCycles) context_->assertOn(true);
    top.frame_valid_i = cycle_ >= kResetCycles && taken < frames.size() && (options.queued || !top.busy_o);
    if (taken < frames.size()) {
      write_port(top.frame_i, frames[taken].frame.data());
      write_port(top.areas_i, frames[taken].areas.data());
    }
    memory.step();
    top.mem_ready_i = memory.ready();
    const ExternalMemory::Answer* answer = memory.answer();
    top.mem_rsp_valid_i = answer != nullptr;
    if (answer != nullptr) {
      top.mem_rsp_tag_i = static_cast<uint8_t>(answer->tag);
      write_port(top.mem_rsp_data_i, answer->data.data());
    }
    top.eval();
    waves.dump_low(cycle_);
    if (cycle_ >= kResetCycles) {
      if (top.frame_valid_i && top.frame_ready_o) ++taken;
      if (taps != nullptr) taps->cycle = static_cast<int64_t>(cycle_) - kRestartCycle;
      if (cycles) tap_cycle(*taps);
      if (top.mem_valid_o && top.mem_ready_i) {
        uint32_t request[2];
        slice(top.mem_request_o, 0, w_.request, request);
        const bool write = request[0] & 1;
        const int tag = static_cast<int>(get_bits(request, 1 + w_.address, w_.tag));
        const uint64_t line = get_bits(request, 1, w_.address);
        try {
          memory.request(write, line, tag, top.mem_data_o.data());
        } catch (const MemoryFault& fault) { throw RtlFault("RTL: " + position() + ": " + fault.what()); }
        if (cycles) taps->on_request(tag, write, line);
        // Without taps what the RUs have written tells how far the frame is.
        if (!w_.taps && write && tag / w_.units == 2) windows_ = ++pixel_lines / static_cast<uint64_t>(w_.pixel_lines);
        last_request = cycle_;
      }
      if (top.error_o != 0) fail();
      if (streams) tap(*taps);
      if (top.done_o) {
        ends.push_back(cycle_ - kRestartCycle - 1);  // done_o is one cycle behind
        if (taps != nullptr) taps->on_frame_done();
      }
    }
    top.clk_i = 1;
    top.eval();
    waves.dump_high(cycle_);
    if (taken == frames.size() && !top.busy_o && ends.size() == taken) break;
    if (cycle_ - last_request > options.quiet_limit) {
      throw RtlFault("RTL: no memory request for " + std::to_string(options.quiet_limit) + " cycles, " + position() +
                     ", " + std::to_string(windows_) + " windows sorted: the machine hangs");
    }
    if (cycle_ % 4096 == 0 && progress && !progress(cycle_, windows_)) throw std::runtime_error("RTL: interrupted");
  }
  waves.close();
  top.clk_i = 0;  // rtl/perf.sv is one cycle behind
  top.eval();
  top.clk_i = 1;
  top.eval();

  RtlResult result = counters();
  result.frame_ends = std::move(ends);
  return result;
}

// The machine has told an error: of two the first bit's.
void VerilatedMachine::fail() const {
  const auto cause = (dut_->error_o & 1) != 0 ? MachineError::kAreaFull : MachineError::kBadScene;
  uint32_t line[3] = {};
  slice(dut_->error_line_o, cause * w_.address, w_.address, line);
  throw MachineError(cause, get_bits(line, 0, w_.address), position());
}

RtlResult VerilatedMachine::counters() {
  const Vpipegs_top& top = *dut_;
  RtlResult result;
  uint32_t words[2] = {};
  slice(top.cycles_o, 0, w_.perf, words);
  result.cycles = get_bits(words, 0, w_.perf);
  words[1] = 0;
  slice(top.preprocess_cycles_o, 0, w_.perf, words);
  result.preprocess_cycles = get_bits(words, 0, w_.perf);
  words[1] = 0;
  slice(top.overflow_lines_o, 0, w_.perf, words);
  result.overflow_lines = get_bits(words, 0, w_.perf);
  int unit = 0;
  const auto read_units = [&](std::vector<UnitCycles>& units, int count) {
    for (int i = 0; i < count; ++i, ++unit) {
      uint64_t values[4];
      for (int k = 0; k < 4; ++k) {
        slice(top.perf_o, (unit * 4 + k) * w_.perf, w_.perf, words);
        values[k] = get_bits(words, 0, w_.perf);
      }
      units.push_back({values[0], values[1], values[2], values[3]});
    }
  };
  read_units(result.dopu, 1);
  read_units(result.pu, w_.units);
  read_units(result.su, w_.units);
  read_units(result.ru, w_.units);
  return result;
}

}  // namespace
}  // namespace pipegs

extern "C" pipegs::RtlModel* pipegs_rtl_create(const pipegs::Config* config) {
  return new pipegs::VerilatedMachine(*config);
}
