// dopu.hpp: the DOPU in the timing model: the walk of the windows, slab by slab, from cells down to chunks.
//
// RTL     rtl/dopu/: dopu_windows, dopu_cells, dopu_descend, dopu_test, dopu_origin, dopu_emit.
// Idea    Which nodes pass is in the trace; here is only when. The unit plays its registers cycle by cycle while something in it
//         moves. The box test takes a node in every third cycle of the unit's own clock, which stops after 127 quiet cycles,
//         so the phase of the test depends on how long the unit has slept.
#pragma once

#include <array>

#include "sim/timing/cycle.hpp"
#include "sim/timing/line_reader.hpp"
#include "sim/timing/perf.hpp"
#include "sim/timing/trace.hpp"

namespace pipegs::timing {

struct Machine;

// A chunk on its way to a PU, or an end.
struct ChunkBeat {
  Beat end = 0;
  uint32_t slot = 0, count = 0;
  uint32_t first = 0;      // its first survivor
  uint64_t survivors = 0;
};

class Dopu {
 public:
  explicit Dopu(const Machine& machine);

  void step(Machine& m, Cycle now);

  // For the PUs.
  bool chunk_shown(int lane, Cycle now) const { return (emit_valid_ >> lane & 1) != 0 && emit_from_ <= now; }
  const ChunkBeat& take_chunk(Machine& m, int lane);
  bool has_chunk() const { return emit_valid_ != 0 || shifting_; }
  bool busy() const { return busy_; }
  Perf perf;

 private:
  static constexpr int kLevels = 3, kResults = 8;

  // A node on one of the levels (cell, group, chunk), or an end.
  struct Item {
    Beat end = 0;
    uint8_t set = 0;
    bool last = false;  // the end of the frame's last window
    uint32_t node = 0;
    const TimingChunk* chunk = nullptr;  // of a chunk that passed
    bool data() const { return !is_end(end); }
  };
  struct Tag {
    Beat end = 0;
    uint8_t set = 0;
    bool last = false;
  };
  using Reader = LineReader<Tag, 8>;
  struct Set {
    bool valid = false, fresh = false, last = false;
    size_t window = 0;
    size_t chunk = 0;  // of the window's chunks that pass, the next one to enter the test
  };

  bool set_done(uint8_t set) const { return done_[set] && sets_[set].valid; }
  bool drops(const Item& item) const { return item.data() && set_done(item.set); }
  uint32_t ready_pus(const Machine& m, Cycle now) const;
  bool passes(const Machine& m, int level, Item& item);
  void emit(Machine& m, Cycle now);
  void origin(Cycle now);
  void test(Machine& m, Cycle now, bool phase);
  void read(Machine& m, Cycle now);
  void cells(const Machine& m, Cycle now);
  void windows(const Machine& m, Cycle now);
  void ask(Machine& m);

  const int units_, grid_;
  std::array<int, 16> slabs_{};  // of each step; -1 outside the grid
  int axis_;
  size_t windows_;

  // clock
  bool busy_ = true, moved_ = false, woken_ = false, level_ = false, changed_ = false;
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
  Item multiplied_, shifted_;
  bool window_sent_ = false;

  // dopu_descend
  std::array<FallQueue<Item, kResults>, kLevels> results_;
  std::array<int, kLevels> reserved_{};
  struct InTest {
    Cycle due = 0;
    Item item;
    uint8_t level = 0;
    bool pass = false;
  };
  FallQueue<InTest, 8> in_test_;
  Reader groups_, chunks_;
  bool cell_taken_ = false;

  // memory port: 0 groups, 1 chunks, 2 cells
  FallQueue<uint8_t, 64> asked_;
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
  Item item_;
  bool window_walked_ = false;

  // dopu_windows
  std::array<Set, 2> sets_;
  std::array<bool, 2> done_{}, done_next_{};
  uint8_t fill_ = 0, oldest_ = 0;
  size_t next_window_ = 0;
  enum Planes { kPlanesIdle, kPlanesBusy, kPlanesReady } planes_ = kPlanesIdle;
  Cycle planes_at_ = 1;
};

}  // namespace pipegs::timing
