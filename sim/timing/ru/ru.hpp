// SPDX-License-Identifier: Apache-2.0
// ru.hpp: a Rasterization Unit in the timing model, and the alpha stores.
//
// RTL     rtl/ru/: ru_walk, ru_fetch or ru_rows, ru_lanes ru_resolve (with quads ru_live, ru_drain), ru_memory;
//         rtl/buf/pipegs_alpha_store.sv, rtl/pipegs_layer_free.sv.
// Idea    A line of alphas keeps the lanes for four cycles; the trace says with which line a region becomes opaque.
//         What a unit reports to others (done regions, finished windows and layers) is kept back until publish() of the
//         cycle in which they see it.
#pragma once

#include <algorithm>
#include <array>

#include "cpp_model/config.hpp"
#include "cpp_model/regions.hpp"
#include "sim/timing/cycle.hpp"
#include "sim/timing/pu/rows.hpp"
#include "sim/timing/ru/live.hpp"

namespace pipegs::timing {

struct Machine;

// A splat on its way from a PU to the RUs.
struct Splat {
  Beat beat = 0;
  uint32_t address = 0;  // in external memory, of its first line, when ext
  uint64_t mask = 0;
  uint8_t unit = 0;  // whose PU made it
  bool ext = false;
  uint8_t part = 0;  // of the window
};

class Ru {
 public:
  Ru(const Machine& machine, int lane);

  void lanes(Machine& m, Cycle now);
  void source(Machine& m, Cycle now);
  void memory(Machine& m, Cycle now);
  void walk(Machine& m, Cycle now);
  void fire(Machine& m, Cycle now);  // the region at the walk's output is asked for

  // What others see in this cycle. publish() makes what happened before visible.
  void publish(Machine& m, Cycle now);
  uint64_t own() const { return own_; }  // in each part
  const RegionSet& done() const { return done_; }
  bool all_done() const { return done_ == owned_; }
  size_t window() const { return window_; }  // number in the frame

  SramQueue<Splat, 256> queue;
  // The last cycle in which a window ended or, with quads, a job was inside: those below the picture write nothing.
  Cycle last_busy() const { return std::max(window_done_at_, last_job_ + Live::kInside - 1); }
  bool written() const { return lines_left_ == 0 && drain_.empty() && !memory_valid_; }

 private:
  struct Fetch {
    Beat beat;
    uint16_t region;
    uint8_t unit;
    bool ext, skip;
    uint32_t address;
  };
  struct Record {
    Beat beat;
    uint16_t region;
    bool ext;
  };

  void queued(Machine& m, Cycle from, bool line);
  void consume(Machine& m, Cycle now);
  void end(Machine& m, Cycle now, Beat beat);
  void rows_source(Machine& m, Cycle now);
  void live_source(Machine& m, Cycle now);
  void next_splat(Machine& m, Cycle now);
  void set_window(const Machine& m, size_t window);
  bool read(Machine& m, Cycle now, uint64_t line);
  // In raster order rows leave together with those of the RU that shares their lines, which is also at its window's
  // end then (with quads), and hands over regions in the same order.
  struct Seen {  // at the beginning of a cycle
    Cycle at = kLongAgo;
    bool at_end = false;
    RegionSet wanted;
  };
  static bool joined(const Machine& m);
  Ru& other(Machine& m) const;
  const Seen& seen(Cycle now);
  RegionSet unwritten(const Machine& m) const;  // of the owned regions
  void written_line(Machine& m, Cycle now);
  void write(Machine& m, size_t window, int region, uint64_t line, uint64_t ahead = 0);
  int rows_written(const Machine& m, size_t window) const;
  int requests(const Machine& m, size_t window, int region, int first_row, int rows) const;
  void drained(Machine& m, Cycle now);
  uint64_t live() const { return ends_ == 0 ? rest_ & ~done_.mask[splat_.part] : rest_; }
  uint64_t walked() const { return stores_ && !splat_.ext ? rest_ : live(); }

  const int lane_, port_;
  Seen seen_;
  const bool late_, quads_, stores_;
  const int fetch_lines_, parts_;

  // ru_walk; splat, rest and ends also of ru_rows
  bool splat_valid_ = false, pick_valid_ = false;
  Splat splat_;
  uint64_t rest_ = 0;
  int ends_ = 0;
  Fetch pick_{};
  Output<Fetch> out_;

  // ru_fetch
  SramQueue<Record, 256> records_;
  SramQueue<uint8_t, 128> external_;
  Queue<uint8_t, Config::ru_local_lines(), 3> local_;  // from the cycle on that asks the store
  int local_out_ = 0, external_out_ = 0;               // lines asked for and not blended yet
  Cycle local_pop_ = kLongAgo, external_pop_ = kLongAgo;
  bool ask_part_ = false, answer_part_ = false;

  Rows rows_;  // when late
  FallQueue<RowLine, Config::ru_row_lines()> row_lines_;

  Live live_;  // with quads, instead of the above and of ru_lanes
  Drain drain_;
  Cycle last_job_ = kLongAgo;

  // ru_lanes
  Cycle start_ = kNever;  // of the line in the lanes
  Cycle last_issue_ = kLongAgo;
  std::array<uint32_t, kRegions> lines_{};  // of the window, blended
  Cycle window_done_at_ = kLongAgo;

  // what others will see
  struct Done {
    Cycle from;
    uint16_t region;
  };
  FallQueue<Done, 4> done_coming_;
  bool window_coming_ = false;
  const uint64_t own_;
  RegionSet owned_, outside_, blended_, done_;  // owned: own in all parts
  size_t window_ = 0;

  // ru_resolve, ru_memory
  bool memory_valid_ = false;
  Cycle read_at_ = kLongAgo;
  int lines_left_ = 0;
  Cycle line_from_ = 0, resolved_from_ = 0;
  uint64_t line_ = 0;
  std::vector<uint64_t> ahead_;  // lines from the pixels to what is written of a word in turn: colours, then AOVs
  size_t turn_ = 0;
  RegionSet regions_left_;
  size_t window_written_ = 0;
};

// One alpha store of each unit: all RUs read, one at a time.
class AlphaStores {
 public:
  void want(Machine& m, int store, int ru);
  void step(Machine& m, Cycle now, int store);

 private:
  std::array<uint32_t, kMostUnits> wanted_{};
  std::array<int, kMostUnits> last_{};
};

// A layer is free when every RU has finished it.
struct LayerFree {
  void done(Machine& m, Cycle now, int ru);
  void publish(Machine& m, Cycle now);

  std::array<int, kMostUnits> count{};
  std::array<bool, kMostUnits> coming{};
};

}  // namespace pipegs::timing
