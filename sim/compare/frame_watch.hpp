// SPDX-License-Identifier: Apache-2.0
// frame_watch.hpp: follows a running machine: in which window and layer each unit is, and what each unit does.
//
// Idea    Ends of layers travel with the data, so counting them on each stream tells where it is:
//           DOPU    a layer ends when every PU has taken its end beat
//           PU k    ... when its end beat goes to SU k
//           SU      ... when the end beat leaves the merge; a layer is sorted from the moment its end beat has come in
//           RU k    ... when its last line is blended
//         With Order 2 the ends of layers are watermarks, and ends of parts count with them; neither leaves the merge:
//         behind it a window is one layer. With Order 1 the frame is one layer of the DOPU and the PUs, and each window
//         one of SUs and RUs.
//         Whoever wants to know derives from FrameWatch and fills in the hooks.
// Units   Cycles as the performance counters count them. `window` is an ordinal: row by row of the frame.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "cpp_model/config.hpp"
#include "sim/rtl/rtl_model.hpp"

namespace pipegs {

enum class UnitKind { kDopu, kPu, kSu, kRu };
enum UnitState : uint8_t { kBusy = 0, kStarved = 1, kBlocked = 2, kMemory = 3 };

// Where a unit is: the window and layer that it works on.
struct FramePlace {
  uint64_t window = 0;
  int layer = 0;
};

class FrameWatch : public RtlTaps {
 public:
  explicit FrameWatch(const Config& config);

  bool wants_cycles() const override { return true; }
  void on_cycle(uint64_t cycle, const uint8_t* states) final;
  void on_chunk(int unit, int kind, const uint32_t* chunk) final;
  void on_splat(int unit, const uint32_t* splat) final;
  void on_sorted(const uint32_t* sorted) final;
  void on_alphas(int lane, uint64_t window_x, uint64_t window_y, uint32_t index, int region, int quarter,
                 const uint32_t* line) override;
  void on_line_free(int unit) final { --alpha_lines_[unit]; }
  void on_layer_done(int unit, bool window_done) final;

  // First cycle in which a line of alphas is blended; ~0 when none was.
  uint64_t first_line() const { return first_line_; }
  // Splats that are in the SUs and the merge: those that went in less those that came out.
  uint64_t peak_records() const { return peak_records_; }
  bool has_alpha_stores() const { return config_.has_stores(); }
  // Lines of the fullest alpha store that belong to splats that have left their PU, and are needed.
  uint64_t peak_alpha_lines() const { return peak_alpha_lines_; }

 protected:
  // Called first in each cycle: what unit `index` of the order DOPU, PUs, SUs, RUs does.
  virtual void cycle(uint64_t /*cycle*/, const uint8_t* /*states*/) {}
  // Unit `k` of a kind has finished `place` in cycle `end`, its last one there. It began in `begin`: the first cycle of
  // its own after the layer before; for an SU also after its end beat had come in, for an RU that of its first line.
  virtual void layer(UnitKind /*kind*/, int /*k*/, const FramePlace& /*place*/, uint64_t /*begin*/, uint64_t /*end*/) {}

  uint64_t now() const { return cycle_; }
  const Config& config() const { return config_; }
  // Where a unit is now.
  const FramePlace& su_place() const { return sorted_.place; }
  const FramePlace& ru_place(int unit) const { return ru_[unit].place; }

 private:
  struct Stream {
    FramePlace place;
    uint64_t next = 0;  // first cycle after the last end
    void end(bool window_end, uint64_t cycle);
  };
  const Config config_;
  bool listed_ = false;  // Order 1: the lists are being read
  uint64_t cycle_ = 0, first_line_ = ~uint64_t{0};
  Stream dopu_, sorted_;
  std::vector<Stream> pu_, ru_;
  std::vector<std::deque<int>> chunk_ends_;  // of each PU: kinds of end beats that not all PUs have taken
  struct End {
    uint64_t kind, cycle;
  };
  std::vector<std::deque<End>> splat_ends_;  // of each SU: end beats that came in
  std::vector<uint64_t> ru_first_;           // of each RU: cycle of the layer's first line, ~0 before
  std::vector<uint64_t> alpha_lines_;        // of each store
  uint64_t records_ = 0, peak_records_ = 0, peak_alpha_lines_ = 0;
};

}  // namespace pipegs
