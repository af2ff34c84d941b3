// SPDX-License-Identifier: Apache-2.0
// dopu.hpp: the DOPU in the timing model: the walks of the windows, from cells down to chunks.
//
// RTL     rtl/dopu/: dopu_windows, dopu_cells, dopu_origin, dopu_emit; descend.hpp, nearest.hpp.
// Idea    Which nodes pass, and which windows go by parts, is in the trace; here is only when. The unit plays its
//         registers cycle by cycle while something in it moves. The box test takes a node in every third cycle of the
//         unit's own clock, which stops after 127 quiet cycles, so the phase of the test depends on how long the unit
//         has slept.
#pragma once

#include <memory>

#include "sim/timing/dopu/descend.hpp"
#include "sim/timing/dopu/nearest.hpp"

namespace pipegs::timing {

struct Machine;

// A chunk on its way to a PU, or an end.
struct ChunkBeat {
  Beat end = 0;
  uint32_t slot = 0, count = 0;
  uint32_t first = 0;  // its first survivor
  uint64_t survivors = 0;
  uint32_t mark = 0;  // watermark of a layer's end
  uint32_t walk = 0;  // of TimingTrace::walks
};

class Dopu {
 public:
  explicit Dopu(const Machine& machine);

  void step(Machine& m, Cycle now);

  // For the PUs.
  bool chunk_shown(int lane, Cycle now) const { return (emit_valid_ >> lane & 1) != 0 && emit_from_ <= now; }
  const ChunkBeat& chunk() const { return emit_chunk_; }
  const ChunkBeat& take_chunk(Machine& m, int lane);
  bool has_chunk() const { return emit_valid_ != 0 || shifting_; }
  bool busy() const { return busy_; }

 private:
  uint32_t ready_pus(const Machine& m, Cycle now) const;
  const DopuItem* node(Cycle now) { return nearest_ ? nearest_->shown(now, sets_) : descend_->shown(now, sets_); }
  void emit(Machine& m, DopuCycle& cycle);
  void origin(const Machine& m, DopuCycle& cycle);
  void port(Machine& m, DopuCycle& cycle);
  void cells(const Machine& m, DopuCycle& cycle);
  void windows(const Machine& m, DopuCycle& cycle);
  bool all_done(const Machine& m, size_t walk) const;
  Closed closed(const Machine& m, size_t set, Cycle now) const;
  bool refit(const Machine& m, Cycle now);
  void ask(Machine& m);
  uint64_t line(int level) const { return nearest_ ? nearest_->line(level) : descend_->line(level); }
  int lines(int level) const { return nearest_ ? nearest_->lines(level) : descend_->lines(level); }
  int table_lines() const { return std::min(table_left_, 8 - static_cast<int>(table_line_ & 7)); }

  const int units_, slabs_, slab_cells_;
  std::array<int, 16> slab_of_step_{};  // -1 outside the grid
  const int axis_;
  const size_t walks_;
  const bool judges_;  // there are trials
  DopuSets sets_;
  std::unique_ptr<Descend> descend_;  // one of these
  std::unique_ptr<Nearest> nearest_;

  // clock
  bool busy_ = true, woken_ = false, level_ = false;
  Cycle stepped_ = -1, frozen_ = 0;
  int quiet_ = 0;
  bool acted_ = false;  // in the cycle stepped last

  // dopu_emit
  uint32_t emit_valid_ = 0, emit_taken_ = 0;
  Cycle emit_from_ = 0;
  ChunkBeat emit_chunk_;
  int emit_last_ = 0;
  bool had_chunk_ = false, origin_taken_ = false, last_sent_ = false;

  // dopu_origin
  bool multiplying_ = false, shifting_ = false;
  Cycle multiplied_at_ = 0, shifted_at_ = 0;
  DopuItem multiplied_, shifted_;
  bool window_sent_ = false;

  // memory port: 0 groups, 1 chunks, 2 cells
  struct Asked {
    int level = 0, lines = 0;
  };
  const int most_asked_;
  FallQueue<Asked, 32> asked_;
  int port_last_ = 0, port_shown_ = 0;
  bool port_locked_ = false;

  // dopu_cells
  int table_left_, table_coming_;
  uint64_t table_line_;
  bool walking_ = true;
  uint8_t walk_set_ = 0;
  int walk_step_ = 0, walk_layer_ = 0, walk_number_ = 0;
  bool end_next_ = false;
  bool item_valid_ = false, item_shown_ = false;  // shown: not an empty cell
  DopuItem item_;
  bool window_walked_ = false;

  // dopu_windows
  std::array<bool, 2> done_{};  // of the set's walk, whether or not it is still needed
  uint8_t fill_ = 0, oldest_ = 0;
  size_t next_walk_ = 0;
  enum Planes { kPlanesIdle, kPlanesBusy, kPlanesReady } planes_ = kPlanesIdle;
  Cycle planes_at_ = 1;
  bool refit_ = false;  // they are made anew for a set that has some (Occlusion)
  size_t refit_set_ = 0;
  Closed refit_closed_;
};

}  // namespace pipegs::timing
