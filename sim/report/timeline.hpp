// SPDX-License-Identifier: Apache-2.0
// timeline.hpp: a running machine as a trace in the Chrome trace event format (ui.perfetto.dev, chrome://tracing).
//
// Idea    One process for each kind of unit and two tracks for each unit: what it works on (a slice for each layer of
//         each window) and what it does (busy, starved, blocked, memory). The second is cut into pieces of `grain`
//         cycles, named by what the unit did most of the time; neighbours of one name are one slice. Each slice says
//         how many cycles of each state are in it, so those of a unit sum to the performance counters exactly.
//         Counters: bytes of each memory stream in every `sample` cycles, records waiting, lines held in each alpha
//         store.
// Units   A cycle is one nanosecond on the time axis (`ts` and `dur` are microseconds).
// Format  An object with traceEvents; otherData holds the frame's cycles and the performance counters. Events are
//         written as they come, so a long frame needs no memory.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "sim/compare/frame_watch.hpp"

namespace pipegs {

struct TimelineOptions {
  int grain = 16;                                  // cycles of a piece of the state tracks
  int sample = 1000;                               // cycles between two values of a counter
  uint64_t columns = 1, first_x = 0, first_y = 0;  // the frame's windows, for their names
};

class Timeline final : public FrameWatch {
 public:
  Timeline(const Config& config, const TimelineOptions& options, std::ostream& out);

  void on_request(int tag, bool write, uint64_t line, int lines) override;
  // Ends the trace; `rtl` is what the run returned.
  void finish(const RtlResult& rtl);

 private:
  using Counts = std::array<uint64_t, 4>;  // cycles by state
  struct States {                          // the state track of one unit
    Counts piece{}, slice{};
    uint64_t begin = 0;  // of the slice
    int name = -1;       // state that names it
  };
  struct Track {
    int process, thread;
  };

  void cycle(uint64_t cycle, const uint8_t* states) override;
  void layer(UnitKind kind, int k, const FramePlace& place, uint64_t begin, uint64_t end) override;
  void event(const std::string& text);
  void name_tracks();
  void end_piece(int unit, uint64_t end);
  void end_slice(int unit, uint64_t end);
  void counters(uint64_t at);
  Track track(int unit) const;  // of a unit in the order DOPU, PUs, SUs, RUs: the first of its two
  std::string unit_name(int unit) const;

  const TimelineOptions options_;
  std::ostream& out_;
  bool any_ = false;
  uint64_t cycles_ = 0;
  std::vector<States> states_;
  std::vector<Counts> sums_;  // of each unit
  std::vector<std::string> streams_;
  std::vector<uint64_t> bytes_;  // of each stream since the last sample
};

}  // namespace pipegs
