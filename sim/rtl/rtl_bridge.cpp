// SPDX-License-Identifier: Apache-2.0
// rtl_bridge.cpp: the loop that clocks the Verilated machine, compiled once for each configuration into librtl.so.
//
// In each cycle the external memory shows its answer and its readiness while the clock is low; the machine settles; the
// taps and the memory side are sampled; the clock rises. Above that loop stands the driver of cpp_model/driver: each
// of its accesses to a register is as many cycles as the bus takes. Time of the memory begins with the first frame.
#include <verilated.h>

#include <stdexcept>
#include <tuple>

#include "Vpipegs_sim.h"
#include "cpp_model/records.hpp"
#include "sim/rtl/pins/axi_pins.hpp"
#include "sim/rtl/pins/control_pins.hpp"
#include "sim/rtl/pins/ports.hpp"
#include "sim/rtl/rtl_fault.hpp"
#include "sim/rtl/rtl_model.hpp"
#include "sim/rtl/wave_file.hpp"

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
        index(c.shown_index_w()),
        window(c.window_w()),
        line(c.tap_line_w()),
        pixels(c.tap_word_w()),
        address(c.address_w()),
        tag(c.tag_w()),
        burst(c.burst_w()),
        bus(c.bus_w),
        axi(c),
        pixel_lines(c.region_lines() * c.regions()),
        raster_rows(8 * c.regions()),
        aovs(static_cast<uint64_t>(c.aovs_built())),
        taps(c.taps != 0) {}
  int units, tap_lanes, splat, sorted, request, kind, region, index, window, line, pixels, address, tag, burst, bus;
  AxiWidths axi;
  int pixel_lines, raster_rows;  // what is written of a window inside the image, in either format of the picture
  uint64_t aovs;
  bool taps;                     // the streams show
};

constexpr uint64_t kResetCycles = 4;
constexpr int kMemoryAhead = 5;  // cycles of the memory before the first one of the first frame

class VerilatedMachine final : public RtlModel {
 public:
  explicit VerilatedMachine(const Config& config) : w_(config) {}
  RtlResult run(const std::vector<pipegs_job>& frames, ExternalMemory& memory, const RtlOptions& options, RtlTaps* taps,
                const Progress& progress) override;
  RtlResult drive(const std::function<void(const pipegs_bus&)>& program, ExternalMemory& memory,
                  const RtlOptions& options, RtlTaps* taps, const Progress& progress) override;

 private:
  void begin();
  void render(const std::vector<pipegs_job>& frames);
  void cycle();
  void drive_memory();
  void observe_memory();
  void tap(RtlTaps& taps);
  void tap_cycle(RtlTaps& taps);
  uint32_t access(bool write, uint32_t offset, uint32_t value);
  void idle();
  bool due() const;
  void disturb();
  void give_up();
  void resume();
  [[noreturn]] void fail(const pipegs_error& error) const;
  int64_t counted() const { return taken_ > 0 ? static_cast<int64_t>(cycle_) - origin_ : 0; }
  std::string position() const { return "cycle " + std::to_string(cycle_); }

  const Widths w_;
  std::unique_ptr<VerilatedContext> context_;
  std::unique_ptr<Vpipegs_sim> dut_;
  std::unique_ptr<WaveFile<Vpipegs_sim>> waves_;
  ControlPins<Vpipegs_sim> control_;
  pipegs_device device_{};  // of `render`

  ExternalMemory* memory_ = nullptr;
  const RtlOptions* options_ = nullptr;
  RtlTaps* taps_ = nullptr;
  const Progress* progress_ = nullptr;
  bool streams_ = false, cycles_ = false;  // the taps see streams, and each cycle

  uint64_t cycle_ = 0, windows_ = 0, pixel_lines_ = 0, last_request_ = 0;
  uint64_t window_lines_ = 1;  // that the RUs write of a window
  int64_t origin_ = 0;         // the first cycle of the first frame; it restarts the counters
  uint64_t taken_ = 0;         // frames
  uint64_t taken_cycle_ = 0;   // of the latest of them
  size_t disturbed_ = 0;       // disturbances that have come
  uint64_t silent_until_ = 0;  // the memory
  uint32_t errors_ = 0;        // told until now
  bool reset_ = false;         // the core was in reset in the cycle before
  bool mute_ = false;          // what the machine shows is of frames that are given up
  bool running_ = false;       // the machine was busy in the cycle before; its first cycle restarts the counters
  uint64_t counted_ = 0;       // cycles that they have counted
  uint64_t sorted_cycle_ = 0;  // of the latest beat that the RUs took
  bool left_ = false;          // the next one is of another frame
  std::vector<uint64_t> ends_, gaps_;
};

void VerilatedMachine::tap(RtlTaps& taps) {
  const Vpipegs_sim& top = *dut_;
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
    if (left_) gaps_.push_back(cycle_ - sorted_cycle_);
    left_ = false;
    sorted_cycle_ = cycle_;
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
  const Vpipegs_sim& top = *dut_;
  if (running_ && top.tap_busy_o) {
    uint8_t states[1 + 3 * kMostUnits];
    for (int unit = 0; unit < 1 + 3 * w_.units; ++unit)
      states[unit] = static_cast<uint8_t>(top.tap_state_o >> (2 * unit) & 3);
    taps.on_cycle(counted_++, states);
    uint8_t border[kRtlBorders];
    PortReader reader(top.tap_border_o);
    for (uint8_t& one : border) one = static_cast<uint8_t>(reader.next(w_.units));
    taps.on_border(border);
  }
  running_ = top.tap_busy_o;
  const int kind = static_cast<int>(get_bits(top.tap_chunk_o.data(), 0, w_.kind));
  for (int unit = 0; unit < w_.units; ++unit) {
    if (top.tap_chunk_valid_o >> unit & 1) taps.on_chunk(unit, kind, top.tap_chunk_o.data());
    if (top.tap_line_free_o >> unit & 1) taps.on_line_free(unit);
    if (top.tap_layer_done_o >> unit & 1) taps.on_layer_done(unit, top.tap_window_done_o >> unit & 1);
  }
}

// --- one cycle -------------------------------------------------------------------------------------------------------
void VerilatedMachine::begin() {
  waves_.reset();  // of a run before, as long as their context is there
  dut_.reset();
  context_ = std::make_unique<VerilatedContext>();
  context_->randReset(2);
  context_->randSeed(static_cast<int>(options_->seed % 0x7ffffffe) + 1);
  context_->traceEverOn(!options_->waves.empty());
  Verilated::threadContextp(context_.get());  // that of units which are libraries of their own
  dut_ = std::make_unique<Vpipegs_sim>(context_.get());
  waves_ = std::make_unique<WaveFile<Vpipegs_sim>>(*dut_, *options_);
  control_ = {};
  cycle_ = windows_ = pixel_lines_ = last_request_ = taken_ = taken_cycle_ = disturbed_ = counted_ = silent_until_ = 0;
  errors_ = 0;
  running_ = reset_ = mute_ = left_ = false;
  ends_.clear();
  gaps_.clear();
  // Before the reset everything is noise: it falls once, and assertions count from its end on.
  context_->assertOn(false);
  dut_->aclk = 0;
  dut_->aresetn = 1;
  control_.drive(*dut_);
  dut_->eval();
  while (cycle_ < kResetCycles) cycle();
  context_->assertOn(true);
}

void VerilatedMachine::drive_memory() {
  Vpipegs_sim& top = *dut_;
  if (w_.bus != 0) {
    write_subordinate_side(top.m_axi_i, w_.axi, taken_ > 0 ? memory_->bus()->step() : AxiSubordinateSide{});
    return;
  }
  top.mem_ready_i = 0;
  top.mem_rsp_valid_i = 0;
  if (taken_ == 0) return;
  memory_->step();
  top.mem_ready_i = memory_->ready();
  const ExternalMemory::Answer* answer = memory_->answer();
  if (answer == nullptr) return;
  top.mem_rsp_valid_i = 1;
  top.mem_rsp_tag_i = static_cast<uint8_t>(answer->tag);
  write_port(top.mem_rsp_data_i, answer->data.data());
}

void VerilatedMachine::observe_memory() {
  const Vpipegs_sim& top = *dut_;
  if (w_.bus != 0 && taken_ > 0) memory_->bus()->observe(axi_manager_side(top.m_axi_o, w_.axi));
  if (w_.bus != 0 && top.tap_reset_o) memory_->forget();
  if (w_.bus != 0 && top.tap_answer_valid_o && !top.tap_reset_o) memory_->answered(top.tap_answer_tag_o);
  if (!top.mem_valid_o || !top.mem_ready_o) return;
  uint32_t request[2];
  slice(top.mem_request_o, 0, w_.request, request);
  const bool write = request[0] & 1;
  const int tag = static_cast<int>(get_bits(request, 1 + w_.address, w_.tag));
  const uint64_t line = get_bits(request, 1, w_.address);
  const int halves = static_cast<int>(get_bits(request, 1 + w_.address + w_.tag, 2));
  const int lines = 1 + static_cast<int>(get_bits(request, 1 + w_.address + w_.tag + 2, w_.burst));
  try {
    if (w_.bus != 0) memory_->accept(write, line, tag, lines, halves);
    if (w_.bus == 0) memory_->request(write, line, tag, top.mem_data_o.data(), lines, halves);
  } catch (const MemoryFault& fault) { throw RtlFault("RTL: " + position() + ": " + fault.what()); }
  if (cycles_ && !mute_) taps_->on_request(tag, write, line, lines);
  // Without taps what the RUs have written tells how far the frame is.
  if (!w_.taps && write && tag / w_.units == 2) windows_ = ++pixel_lines_ / window_lines_;
  last_request_ = cycle_;
}

void VerilatedMachine::cycle() {
  Vpipegs_sim& top = *dut_;
  top.aclk = 0;
  top.aresetn = cycle_ >= kResetCycles;
  if (silent_until_ != 0 && cycle_ >= silent_until_) silent_until_ = 0, memory_->bus()->silence = {};
  control_.drive(top);
  drive_memory();
  top.eval();
  waves_->dump_low(cycle_, counted());
  if (cycle_ >= kResetCycles) {
    control_.observe(top);
    if (taps_ != nullptr) taps_->cycle = counted(), taps_->wave_time = cycle_ * kWaveTime;
    if (cycles_ && !mute_) tap_cycle(*taps_);
    observe_memory();
    if (streams_ && !mute_) tap(*taps_);
    if (top.tap_left_o && !mute_ && taps_ != nullptr) {
      left_ = true;
      taps_->on_frame_left();
    }
    if (top.tap_done_o && !mute_) {
      ends_.push_back(static_cast<uint64_t>(static_cast<int64_t>(cycle_) - origin_ - 2));  // so far behind the pixel
      if (taps_ != nullptr) taps_->on_frame_done();
    }
    if (top.tap_reset_o && !reset_ && taken_ > 0) give_up();
    reset_ = top.tap_reset_o;
    if (top.tap_take_o) {
      if (taken_ == 0) {
        origin_ = static_cast<int64_t>(cycle_) + 1;
        for (int i = 0; i < kMemoryAhead; ++i)
          w_.bus != 0 ? static_cast<void>(memory_->bus()->step()) : memory_->step();
      }
      ++taken_;
      taken_cycle_ = cycle_;
    }
  }
  top.aclk = 1;
  top.eval();
  waves_->dump_high(cycle_, counted());
  if (cycle_ - last_request_ > options_->quiet_limit) {
    throw RtlFault("RTL: no memory request for " + std::to_string(options_->quiet_limit) + " cycles, " + position() +
                   ", " + std::to_string(windows_) + " windows sorted: the machine hangs");
  }
  if (cycle_ % 4096 == 0 && *progress_ && !(*progress_)(cycle_, windows_)) throw std::runtime_error("RTL: interrupted");
  ++cycle_;
}

// --- frames ----------------------------------------------------------------------------------------------------------
uint32_t VerilatedMachine::access(bool write, uint32_t offset, uint32_t value) {
  control_.begin(write, offset, value);
  while (control_.open()) cycle();
  return control_.value();
}

bool VerilatedMachine::due() const {
  if (disturbed_ == options_->disturbances.size()) return false;
  const RtlDisturbance& next = options_->disturbances[disturbed_];
  return taken_ > next.frame + 1 || (taken_ == next.frame + 1 && cycle_ >= taken_cycle_ + next.cycle);
}

void VerilatedMachine::idle() {
  while (!dut_->irq && !due()) cycle();
}

void VerilatedMachine::disturb() {
  const RtlDisturbance& now = options_->disturbances[disturbed_++];
  const RtlDisturbance::Kind kind = now.kind;
  if (kind == RtlDisturbance::Kind::kSilence) {
    memory_->bus()->silence = now.silence;
    silent_until_ = cycle_ + now.lasts;
  } else if (kind == RtlDisturbance::Kind::kAbort) {
    pipegs_abort(&device_, PIPEGS_NO_LIMIT);
    if (w_.bus != 0 && silent_until_ == 0 && memory_->bus()->writing()) {
      throw RtlFault("RTL: not busy after an abort, and a write is on its way to memory");
    }
  } else {
    ++(kind == RtlDisturbance::Kind::kFailRead ? memory_->bus()->fail_reads : memory_->bus()->fail_writes);
  }
}

// The core is in reset: from here on nothing that it shows counts, until the driver has begun again.
void VerilatedMachine::give_up() {
  if (mute_) return;
  mute_ = true;
  running_ = false;
}

// All that is not done begins again.
void VerilatedMachine::resume() {
  mute_ = false;
  left_ = !ends_.empty();
  gaps_.resize(std::min(gaps_.size(), left_ ? ends_.size() - 1 : 0));
  if (taps_ != nullptr) taps_->on_give_up();
}

// An error that is none of the disturbances.
void VerilatedMachine::fail(const pipegs_error& error) const {
  const uint64_t line = error.address / 64;
  if (error.has_address && error.first == PIPEGS_ERROR_AREA_FULL_SHIFT)
    throw MachineError(MachineError::kAreaFull, line, position());
  if (error.has_address && error.first == PIPEGS_ERROR_BAD_SCENE_SHIFT)
    throw MachineError(MachineError::kBadScene, line, position());
  char text[200];
  pipegs_error_text(&error, text, sizeof text);
  throw RtlFault("RTL: " + std::string(text));
}

void VerilatedMachine::render(const std::vector<pipegs_job>& frames) {
  if (options_->bus_timeout != 0) pipegs_set_timeout(&device_, options_->bus_timeout);
  window_lines_ = static_cast<uint64_t>(frames.front().picture.format != 0 ? w_.raster_rows : w_.pixel_lines);
  window_lines_ *= 1 + static_cast<uint64_t>(std::popcount(frames.front().frame.raster_aovs_wanted & w_.aovs));
  pipegs_enable(&device_, PIPEGS_IRQ_STATUS_FRAME_DONE | PIPEGS_IRQ_STATUS_QUEUE_FREE | PIPEGS_IRQ_STATUS_ERROR);
  for (size_t next = 0; ends_.size() < frames.size();) {
    while (next < frames.size() && !due() && pipegs_queue_free(&device_) &&
           (options_->queued || next == ends_.size())) {
      pipegs_write(&device_, &frames[next++], false);
      pipegs_start(&device_);
    }
    idle();
    if (due()) disturb();
    const uint32_t events = pipegs_interrupt(&device_);
    if (events & PIPEGS_IRQ_STATUS_ERROR) {
      const pipegs_error error = pipegs_get_error(&device_);
      if (disturbed_ == 0) fail(error);
      errors_ |= error.causes;
      pipegs_abort(&device_, PIPEGS_NO_LIMIT);
      pipegs_clear_error(&device_, error.causes);
    }
    if (mute_) {  // all that is not done is given up and begins anew
      while (dut_->tap_reset_o) cycle();
      next = ends_.size();
      resume();
    }
  }
}

RtlResult VerilatedMachine::run(const std::vector<pipegs_job>& frames, ExternalMemory& memory,
                                const RtlOptions& options, RtlTaps* taps, const Progress& progress) {
  const auto program = [&](const pipegs_bus& bus) {
    if (pipegs_identify(&device_, &bus) != PIPEGS_OK) throw RtlFault("RTL: the registers are not those of the driver");
    render(frames);
  };
  return drive(program, memory, options, taps, progress);
}

RtlResult VerilatedMachine::drive(const std::function<void(const pipegs_bus&)>& program, ExternalMemory& memory,
                                  const RtlOptions& options, RtlTaps* taps, const Progress& progress) {
  memory_ = &memory, options_ = &options, taps_ = taps, progress_ = &progress;
  streams_ = taps != nullptr && w_.taps;
  cycles_ = streams_ && taps->wants_cycles();
  begin();
  const pipegs_bus bus = {
      .read = [](void* self,
                 uint32_t offset) { return static_cast<VerilatedMachine*>(self)->access(false, offset, 0); },
      .write = [](void* self, uint32_t offset,
                  uint32_t value) { static_cast<VerilatedMachine*>(self)->access(true, offset, value); },
      .idle = [](void* self) { static_cast<VerilatedMachine*>(self)->idle(); },
      .context = this};
  program(bus);

  while (access(false, PIPEGS_STATUS, 0) & PIPEGS_STATUS_BUSY) {}
  pipegs_device device{};
  device.bus = bus;
  RtlResult result;
  pipegs_counters counters;
  pipegs_get_counters(&device, &counters);
  waves_->close();
  result.cycles = counters.cycles;
  result.preprocess_cycles = counters.preprocess_cycles;
  result.overflow_lines = counters.overflow_lines;
  for (const auto& [cycles, count, first] :
       {std::tuple{&result.dopu, 1, &counters.dopu_busy}, std::tuple{&result.pu, w_.units, &counters.pu0_busy},
        std::tuple{&result.su, w_.units, &counters.su0_busy}, std::tuple{&result.ru, w_.units, &counters.ru0_busy}}) {
    for (int i = 0; i < count; ++i) {
      const uint64_t* unit = first + 4 * i;
      cycles->push_back({unit[0], unit[1], unit[2], unit[3]});
    }
  }
  result.frame_ends = ends_;
  result.frame_gaps = gaps_;
  result.errors = errors_;
  return result;
}

}  // namespace
}  // namespace pipegs

extern "C" pipegs::RtlModel* pipegs_rtl_create(const pipegs::Config* config) {
  return new pipegs::VerilatedMachine(*config);
}
