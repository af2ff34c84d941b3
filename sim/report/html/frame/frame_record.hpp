// SPDX-License-Identifier: Apache-2.0
// frame_record.hpp: a running machine as numbers that a page can draw: what each unit did, piece by piece of the frame,
// when each window was in each unit, bytes of each memory stream, and how often each region was blended into.
//
// Idea    Pieces are of equal length. When there are more than kMostPieces of them, two become one, so a record is of
//         one size whatever the frame's length. Cycles by state of all pieces of a unit sum to its performance counters
//         exactly.
// Units   Cycles as the performance counters count them; lines of 64 bytes.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "cpp_model/float/projection.hpp"
#include "sim/compare/frame_watch.hpp"

namespace pipegs {

class FrameRecord final : public FrameWatch {
 public:
  static constexpr size_t kMostPieces = 4096;
  static constexpr uint32_t kLongestPiece = 1u << 15;  // cycles; a frame of more has more pieces
  using States = std::array<uint32_t, 4>;              // cycles by UnitState
  struct Span {                                        // a window in a unit
    uint64_t begin = 0, end = 0;                       // first and last cycle
  };

  // `pixels`: those that were asked for; the windows that hold them run.
  FrameRecord(const Config& config, const PixelRect& pixels);

  void on_request(int tag, bool write, uint64_t line, int lines) override;
  void on_alphas(int lane, uint64_t window_x, uint64_t window_y, uint32_t index, int region, int quarter,
                 const uint32_t* line) override;
  // Ends the last piece. Throws std::logic_error when the states do not sum to the counters of `rtl`.
  void finish(const RtlResult& rtl);

  uint32_t piece_cycles() const { return grain_; }
  size_t pieces() const { return pieces_; }
  const std::vector<std::vector<States>>& units() const { return units_; }      // DOPU, PUs, SUs, RUs; by piece
  const std::vector<std::vector<uint32_t>>& streams() const { return lines_; }  // in the order of memory_streams
  // By unit in the order above, then window.
  const std::map<std::pair<int, uint64_t>, Span>& spans() const { return spans_; }
  // Of each window in its order: cycles from the end of the window before to its own, both in the RUs.
  std::vector<uint64_t> window_cycles() const;
  // Of each 8x8 region, row by row of the windows that run: lines of alphas that the RUs took (with quads: rows of
  // quads that a group of lanes took).
  const std::vector<uint32_t>& blends() const { return blends_; }

 private:
  void cycle(uint64_t cycle, const uint8_t* states) override;
  void layer(UnitKind kind, int k, const FramePlace& place, uint64_t begin, uint64_t end) override;
  void join_pieces();

  uint32_t grain_ = 64;
  size_t pieces_ = 0;
  std::vector<std::vector<States>> units_;
  std::vector<std::vector<uint32_t>> lines_;
  std::map<std::pair<int, uint64_t>, Span> spans_;
  uint64_t first_x_, first_y_, columns_, rows_;  // of the windows that run
  std::vector<uint32_t> blends_;
};

}  // namespace pipegs
