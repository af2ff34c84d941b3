// SPDX-License-Identifier: Apache-2.0
// rtl_model.hpp: the Verilated machine as the rest of the program sees it: run frames, watch its streams.
//
// Each configuration is a shared library of its own (librtl.so, built by sim/rtl/build_rtl.sh) that exports
// `pipegs_rtl_create`; the program itself holds no Verilated code. Records cross as packed 32-bit words.
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cpp_model/config.hpp"
#include "cpp_model/records.hpp"
#include "cpp_model/driver/pipegs.h"
#include "sim/memory/external_memory.hpp"
#include "sim/rtl/rtl_fault.hpp"

namespace pipegs {

// What stands at the borders of the units in a cycle: of each, one bit for each unit of its kind (nodes: bit 0), in the
// order of tap_border_o in pipegs_sim. `Shows`: the valid of a stream; `Takes`: valid and ready.
enum RtlBorder : uint8_t {
  kDopuBusy,
  kNodeAsks,
  kNodeAsked,
  kNodeLine,
  kChunkShows,
  kChunkRoom,
  kPuBusy,
  kVisibleTakes,
  kCulledShows,
  kGeometryAsks,
  kGeometryLine,
  kSplatShows,
  kSplatReady,
  kSuTakes,
  kSuActive,
  kOrderedShows,
  kOrderedReady,
  kSortAsks,
  kSpilling,
  kRuTakes,
  kRuAsks,
  kRuAsked,
  kRuWrites,
  kRtlBorders
};

// What the machine shows while it runs. All words are packed records, valid during the call only.
class RtlTaps {
 public:
  virtual ~RtlTaps() = default;
  virtual void on_splat(int /*unit*/, const uint32_t* /*splat*/) {}  // PU -> SU
  virtual void on_sorted(const uint32_t* /*sorted*/) {}              // su_merge -> RUs
  // Alphas that a lane of an RU's taps starts to blend, and the window in which it does: a line, or with quads the four
  // of row `quarter` of the region's quads that its group of lanes owns. Lanes count through all RUs.
  virtual void on_alphas(int /*lane*/, uint64_t /*window_x*/, uint64_t /*window_y*/, uint32_t /*index*/, int /*region*/,
                         int /*quarter*/, const uint32_t* /*line*/) {}
  // T and RGB, written back.
  virtual void on_pixels(int /*lane*/, int /*region*/, int /*quarter*/, const uint32_t* /*word*/) {}
  virtual void on_frame_left() {}  // the RUs have given away its last pixel: what they show now is of the next frame
  virtual void on_frame_done() {}  // the last pixel of the oldest frame inside is in memory; without taps too
  virtual void on_give_up() {}     // no frame inside counts any more: those that are not done begin anew
  int64_t cycle = 0;               // of what is shown: counted as RtlResult::cycles, 1 is the first one that counts
  uint64_t wave_time = 0;          // of the same in waves, kWaveTime for a cycle

  // What follows is shown only when `wants_cycles` says so, because it costs time in every cycle.
  virtual bool wants_cycles() const { return false; }
  // First in each cycle that the performance counters count, from 0 on: what each unit does (0 busy, 1 starved, 2
  // blocked, 3 memory), in the order DOPU, PUs, SUs, RUs. What else the cycle shows comes after it.
  virtual void on_cycle(uint64_t /*cycle*/, const uint8_t* /*states*/) {}
  virtual void on_border(const uint8_t* /*border*/) {}  // of each RtlBorder, in the same cycles
  virtual void on_chunk(int /*unit*/, int /*kind*/, const uint32_t* /*chunk*/) {}  // DOPU -> PU: a chunk or an end
  virtual void on_line_free(int /*unit*/) {}                         // a line has left the alpha store of `unit`
  virtual void on_layer_done(int /*unit*/, bool /*window_done*/) {}  // RU `unit` has blended a layer
  // A line to external memory, or lines from it, see MemoryRequest.
  virtual void on_request(int /*tag*/, bool /*write*/, uint64_t /*line*/, int /*lines*/) {}
};

// What a run is to survive: it happens `cycle` cycles after the machine has taken its frame number `frame`, counted
// with those that it takes again.
struct RtlDisturbance {
  enum class Kind { kAbort, kFailRead, kFailWrite, kSilence };
  uint64_t frame = 0, cycle = 0;
  Kind kind = Kind::kAbort;
  AxiSilence silence = {};  // kSilence: what memory does not do
  uint64_t lasts = 0;       // for so many cycles
};

// In waves a cycle takes so long; in the first half of it the clock is low.
inline constexpr int kWaveTime = 10;

// The cycles that waves show: so many on both sides of one, counted as RtlTaps::cycle. What comes before the first
// frame is cycle 0.
struct WaveRange {
  int64_t cycle = 0, around = 0;
  bool holds(int64_t other) const { return std::abs(other - cycle) <= around; }
};

struct RtlOptions {
  uint64_t seed = 1;                              // of the random initial values of registers and memories
  std::string waves;                              // FST file, empty for none; needs a variant with waves
  std::optional<WaveRange> wave_range;            // of these cycles only
  uint64_t sample_period = 0, sample_cycles = 0;  // waves of so many cycles in each period only; 0: of all
  bool queued = true;             // a frame is queued while the one before runs; else when the machine is empty
  uint64_t quiet_limit = 200000;  // cycles without a memory request after which the machine counts as hung
  std::vector<RtlDisturbance> disturbances;  // in the order in which they come
  uint32_t bus_timeout = 0;  // cycles of silence of the memory after which frames are given up; 0: as after a reset
};

// Whether waves show this cycle. Where in its period a sample lies is drawn from the period's number, so that samples
// meet no rhythm of the machine.
inline bool in_sample(const RtlOptions& options, uint64_t cycle) {
  if (options.sample_period == 0) return true;
  uint64_t draw = cycle / options.sample_period * 0x9e3779b97f4a7c15ull;  // splitmix64
  draw = (draw ^ draw >> 30) * 0xbf58476d1ce4e5b9ull;
  draw = (draw ^ draw >> 27) * 0x94d049bb133111ebull;
  const uint64_t begin = (draw ^ draw >> 31) % (options.sample_period - options.sample_cycles + 1),
                 at = cycle % options.sample_period;
  return at >= begin && at < begin + options.sample_cycles;
}

struct UnitCycles {
  uint64_t busy = 0, starved = 0, blocked = 0, memory = 0;
};

// What the counters of the machine say: since it was last empty.
struct RtlResult {
  uint64_t cycles = 0;
  uint64_t preprocess_cycles = 0;  // of these, before the first list was read (order 1; else 0)
  std::vector<UnitCycles> dopu, pu, su, ru;
  uint64_t overflow_lines = 0;       // lines of alphas, records and keys that went to external memory
  std::vector<uint64_t> frame_ends;  // cycle in which each frame was complete; 1 is the first one that counts
  // Of each frame behind another: cycles from the last splat or end of the one before that the RUs take to its own
  // first one. Without taps none.
  std::vector<uint64_t> frame_gaps;
  uint32_t errors = 0;  // all that the machine told while it got over its disturbances, as bits of ERROR
};

class RtlModel {
 public:
  using Progress = std::function<bool(uint64_t cycle, uint64_t windows_done)>;

  virtual ~RtlModel() = default;
  // Resets the machine and lets `program` drive it by its registers: each access takes as many cycles as the bus needs,
  // `idle` of the bus returns when the interrupt is high.
  virtual RtlResult drive(const std::function<void(const pipegs_bus&)>& program, ExternalMemory& memory,
                          const RtlOptions& options, RtlTaps* taps, const Progress& progress) = 0;
  // Resets the machine and runs these frames, one after the other, on the scenes that lie in `memory`: the driver of
  // cpp_model/driver writes them to its registers. `progress(cycle, window)` is called every few thousand cycles;
  // returning
  // false stops the run with an exception. Throws std::runtime_error when an assertion fails, the machine hangs or
  // tells of an error that is none of the disturbances: MachineError when an area is full or the scene is bad.
  virtual RtlResult run(const std::vector<pipegs_job>& frames, ExternalMemory& memory, const RtlOptions& options,
                        RtlTaps* taps, const Progress& progress) = 0;
};

// The machine has reported an error and given its frames up: what it is, and the line of memory that it concerns.
struct MachineError : RtlFault {
  enum Cause { kAreaFull, kBadScene };
  MachineError(Cause what, uint64_t at, const std::string& where)
      : RtlFault(std::string("RTL: ") + (what == kAreaFull ? "area_full" : "bad_scene") + " at line " +
                 std::to_string(at) + " of memory, " + where),
        cause(what),
        line(at) {}
  Cause cause;
  uint64_t line;
};

// The RTL of a configuration does not build.
struct RtlBuildError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The kinds of units that can be gates.
inline const std::vector<std::string> kGates = {"dopu", "pu", "su", "ru"};

// How a machine is simulated. It changes neither a cycle nor a bit, only time and what can be seen.
struct RtlVariant {
  bool waves = false;                   // they can be written
  bool asserts = true;                  // the assertions of the RTL are checked
  std::vector<std::string> gates = {};  // which of kGates are gates
};

// The variant that is built for a run. Waves are three quarters of the C++ to compile, so a machine can write them only
// when a run asks for them.
RtlVariant built_variant(RtlVariant variant = {}, const RtlOptions& options = {});

// Loads the machine for a configuration, building it first when this has not been done (see sim/rtl/build_rtl.sh).
std::unique_ptr<RtlModel> load_rtl(const Config& config, const RtlVariant& variant = {});

// That of a library that is built.
std::unique_ptr<RtlModel> open_rtl(const std::string& library, const Config& config);

// Brings its library up to date without loading it and returns its path. Throws RtlBuildError.
std::string build_rtl(const Config& config, const RtlVariant& variant = {});

}  // namespace pipegs

extern "C" pipegs::RtlModel* pipegs_rtl_create(const pipegs::Config* config);
