// SPDX-License-Identifier: Apache-2.0
// pu.hpp: a Preprocessing Unit in the timing model.
//
// RTL     rtl/pu/pipegs_pu.sv: fetch, cull | (deal.hpp) | project .. coeff, intersect, then pu_cache or pu_late.
// Idea    A stage acts when it takes a record and when it gives one; its phases in between are arithmetic.
#pragma once

#include <array>
#include <vector>

#include "cpp_model/config.hpp"
#include "sim/timing/pu/color.hpp"
#include "sim/timing/cycle.hpp"
#include "sim/timing/pu/expand.hpp"
#include "sim/timing/pu/intersect.hpp"
#include "sim/timing/line_reader.hpp"
#include "sim/timing/pu/phases.hpp"
#include "sim/timing/pu/rows.hpp"

namespace pipegs::timing {

struct Machine;

// pu_conic.sv, pu_coeff.sv, at a pace of eight cycles: slots with a front record.
struct SlotStage {
  bool active = false, fresh = false, front_valid = false;
  Beat front = 0;
  Cycle out_at = 0, free_at = kLongAgo;
  Output<Beat> out;
};

class Pu {
 public:
  Pu(const Machine& machine, int lane);

  void reader(Machine& m, Cycle now);
  void cull(Machine& m, Cycle now);
  void reach(Machine& m, Cycle now);
  void project(Machine& m, Cycle now);
  void conic(Machine& m, Cycle now);
  void expand(Machine& m, Cycle now) { lists_ ? expand_.step(m, now, conic_.out) : parts_.step(m, now, conic_.out); }
  void coeff(Machine& m, Cycle now);
  void intersect(Machine& m, Cycle now);
  void back(Machine& m, Cycle now);
  void rows(Machine& m, Cycle now);

  void line_free(Machine& m, Cycle now);   // a line of the alpha store leaves it
  void layer_free(Machine& m, Cycle now);  // all RUs have finished the oldest layer
  bool front() const { return front_; }    // it fetches and culls
  bool chunk_room(Cycle now) const { return reader_.job_room(now); }
  FallQueue<uint32_t, Config::pu_marks()> marks;  // watermarks of the ends inside (order 2)

  // For the lists: the records that this PU makes, one after the other.
  bool made_shown(Cycle now) const {
    return late_ ? tiles_.shown(now) : splat_valid_ && splat_from_ <= now && (!is_end(splat_.beat) || rows_ended_);
  }
  Beat made() const { return late_ ? tiles_.value : splat_.beat; }
  Splat take_made(Machine& m, Cycle now);

  // For the SU, without lists: what leaves the unit.
  bool splat_shown(Cycle now) const {
    if (!late_) return color.shown(now);
    return queued_.valid(now) && (queued_.front().again || color.shown(now));
  }
  const Splat& splat() const { return late_ ? queued_.front().splat : color.out.value; }
  void take_splat(Machine& m, Cycle now);

  Output<Beat> culled;                               // to pu_deal; with TightCull the head of what is in pu_reach
  SramQueue<Beat, Config::visible_depth()> visible;  // from pu_deal
  Color color;

 private:
  struct Header {
    Beat end = 0;
    uint32_t first = 0;  // survivor
    uint64_t survivors = 0;
    uint32_t walk = 0;
  };
  static constexpr int kMostJobs = 64;  // with one front for eight PUs
  using Reader = LineReader<Header, kMostJobs>;
  enum Allocate { kTake, kDecide, kOffer };

  bool beside(const Machine& m, Cycle now, unsigned place) const;
  bool take_tiles(Machine& m, Cycle now);
  void allocate(Machine& m, Cycle now);
  void late(Machine& m, Cycle now);
  void lines(Machine& m, Cycle now);
  bool show(Phases& phases, bool& shown, Output<Beat>& out, Cycle now);
  void slot(Machine& m, Cycle now, SlotStage& stage, Output<Beat>& in, int giver, int self, int taker, int out_phase,
            int tail);
  uint64_t done_regions(const Machine& m, uint64_t part) const;

  const int lane_;
  const bool front_;
  const bool late_, lists_, has_parts_, tight_, four_;

  Reader reader_;
  bool chunk_room_ = true;  // in the next cycle

  // pu_eyes, pu_cull
  int eye_ = 0;             // of those of its walk, the one for which the next Gaussian comes
  std::vector<Beat> pipe_;  // pu_decode, if coded, and pu_cull
  std::vector<uint32_t> pipe_walk_;
  unsigned pipe_at_ = 0;
  int pipe_count_ = 0;
  Output<Beat> survivor_;  // only with TightCull, to pu_reach

  Queue<Beat, Config::reach_depth(), 12> reach_;
  bool reach_offered_ = false;  // its head is what pu_deal sees

  Phases phases_;        // project to covariance, at a pace of four cycles to conic
  Phases coeff_phases_;  // coeff, at a pace of four cycles
  SlotStage conic_, coeff_;
  bool conic_shown_ = false, coeff_shown_ = false;  // at a pace of four cycles: out is what the phases show
  Expand expand_;                                   // only with lists
  Parts parts_;                                     // only with parts

  SramQueue<Beat, Config::walk_depth()> walks_;  // before pu_intersect
  Intersect intersect_;
  Output<Beat> tiles_;

  // pu_allocate, pu_late
  size_t window_ = 0;  // of the beats
  Allocate allocate_ = kTake;
  Cycle allocate_at_ = kLongAgo;
  Splat splat_;
  int lines_ = 0;
  bool row_valid_ = false, color_valid_ = false;
  struct Layer {
    int lines = 0;         // in the store
    bool spilled = false;  // it has an overflow area
  };
  Layer own_;                                              // the present layer
  FallQueue<Layer, 16> ended_;                             // layers that are not free
  int used_ = 0, held_ = 0, areas_ = 0;                    // slots, addresses, overflow areas that are not
  std::array<Cycle, 2> line_free_at_{kLongAgo, kLongAgo};  // the latest two
  bool area_ = false;                                      // of the present layer
  const int alpha_lines_, alpha_addresses_;
  uint32_t overflow_ = 0;
  Cycle layer_free_at_ = kLongAgo;
  struct Queued {
    Splat splat;
    bool again = false;  // of the same Gaussian as the one before
  };
  Output<uint8_t> late_out_;  // splat_ waits for the colour
  SramQueue<Queued, Config::late_depth()> queued_;
  Beat asked_ = kBubble;  // the survivor whose colour was asked for last, with parts

  // pu_lines
  bool splat_valid_ = false, rows_ended_ = false;
  Cycle splat_from_ = 0;

  SramQueue<RowJob, Config::row_jobs()> jobs_;
  Rows rows_;

  // pu_spill
  const int pieces_;
  int pieces_left_ = 0;
  uint64_t spill_line_ = 0;
};

}  // namespace pipegs::timing
