// SPDX-License-Identifier: Apache-2.0
// stream_check.hpp: holds every stream of the RTL against the golden model while the machine runs.
//
// Idea    The golden window is computed when the RTL first shows something of it and dropped when it has left it.
//           DOPU -> PU    every chunk equals the one of the bit-accurate model and comes once; all come unless the
//                         whole walk is done, or with Occlusion every region of each of its Gaussians was done before
//                         that one's turn
//           PU -> SU      (with lists: list -> SU) every splat equals the golden one and comes in a walk of its part;
//                         regions may be missing only where the window is done there; every walk ends
//           merge -> RU   the order equals the golden order, layer by layer
//           alphas        the line (or quad) that an RU starts to blend equals the golden codes of that Gaussian there;
//                         each line of the sorted stream comes once, in its order
//           pixels        T and RGB that an RU writes back equal the golden blend of it; when the window is left, what
//                         was blended in all its regions equals the golden window, every bit of T and RGB
//         What the RTL leaves out because a region (or quad) was done must have been done in the golden model too.
// Result  The number of mismatches, and the first one: stream, unit, cycle, Gaussian, pixel, field, both values.
#pragma once

#include <algorithm>
#include <array>
#include <deque>
#include <optional>
#include <string>
#include <unordered_map>

#include "cpp_model/areas/frame_areas.hpp"
#include "cpp_model/golden.hpp"
#include "cpp_model/pu/rows/pu_rows.hpp"
#include "cpp_model/ru/ru_quads.hpp"
#include "sim/compare/chunk_set.hpp"
#include "sim/rtl/rtl_model.hpp"

namespace pipegs {

// What showed a mismatch: a stream, the picture in memory, what a unit says that it does, what it asks of memory, or
// the time of gates.
enum class Tap { kChunk, kSplat, kSorted, kAlphas, kPixels, kMemory, kState, kRequest, kTime };

struct Mismatch {
  Tap tap;
  std::optional<int> unit;  // PU or RU
  std::string who = "";     // that says it, "SU 1"
  std::optional<uint64_t> gaussian, layer;
  std::optional<int> region;
  std::optional<std::array<int, 2>> pixel;
  std::string field = "", expected = "", found = "";  // without a field all of it; without `found` the opposite
  uint64_t window_x = 0, window_y = 0;
  int64_t cycle = 0;      // as RtlTaps counts
  std::string what = "";  // one line of all but window and cycle

  std::string stream() const;  // "PU 1 -> SU"
  std::string signal() const;  // that shows it in waves; of memory none
  std::string line() const;    // with window and cycle
};

class StreamCheck final : public RtlTaps {
 public:
  explicit StreamCheck(const GoldenInput& input);

  bool wants_cycles() const override { return true; }  // chunks come with them
  void on_chunk(int unit, int kind, const uint32_t* chunk) override;
  void on_splat(int unit, const uint32_t* splat) override;
  void on_sorted(const uint32_t* sorted) override;
  void on_alphas(int lane, uint64_t window_x, uint64_t window_y, uint32_t index, int region, int quarter,
                 const uint32_t* line) override;
  void on_pixels(int lane, int region, int quarter, const uint32_t* word) override;

  // After the run: all that was owed has come.
  void finish();

  // A stream has shown the frame's last window.
  bool chunks_over(int unit) const {
    return chunk_window_[static_cast<size_t>(unit)] == (config_.has_lists() ? 1 : frame_windows(input_.frame));
  }
  bool splats_over(int unit) const {
    return splat_place_[static_cast<size_t>(unit)].window == frame_windows(input_.frame);
  }
  bool sorted_over() const { return sorted_place_.window == frame_windows(input_.frame); }
  // A pixel of the picture in memory differs.
  void fail_pixel(int x, int y, const std::string& expected, const std::string& found);
  // What belongs to no beat, while the RUs are in some window.
  void fail_beside(Mismatch mismatch) { fail(ru_window_.front(), std::move(mismatch)); }

  uint64_t mismatches() const { return mismatches_; }
  const std::optional<Mismatch>& first() const { return first_; }
  uint64_t beats() const { return beats_; }  // beats compared
  // What the RTL showed for one pixel, for `explain`, of each Gaussian in its order: alpha code, state after it.
  struct Seen {
    uint32_t index, code;
    PixelState after;
  };
  void watch(int x, int y) { watched_ = {x, y}; }
  const std::vector<Seen>& seen() const { return seen_; }

 private:
  struct Line {
    const GoldenSplat* splat;
    uint32_t quads;  // those in which it has an alpha; of the whole region 1
  };
  struct Window {
    GoldenWindow golden;
    std::optional<ChunkSet> chunks;                                         // without lists
    std::vector<std::unordered_map<uint64_t, const GoldenSplat*>> by_name;  // of each layer
    RegionSet done;                                                         // regions done at the end
    std::vector<RegionState> live;                                          // blended line by line as the RTL does
    std::vector<RegionAovs> live_aovs;                                      // likewise, where the machine has AOVs
    std::vector<std::vector<Line>> lines;                                   // of each region, in their order
    std::vector<size_t> shown;                     // of each region: one more than the last line that an RU has shown
    std::vector<std::array<size_t, kQuads>> next;  // of each region and quad (of a whole region the first): next line
  };
  // Where a stream is in the frame.
  struct Place {
    uint64_t window = 0;  // ordinal in the frame
    size_t layer = 0;
    size_t walk = 0;  // walks of the window that have ended, for the streams of splats
    size_t next = 0;  // next splat, for the sorted stream
  };
  struct Pending {  // alphas being blended by a lane of taps, until their words have been written back
    uint32_t index;
    int region;
    int quarter;  // with quads
    std::array<uint16_t, kRegionPixels> codes;
    RegionState after;  // the golden region after this line
    RegionAovs aovs;    // likewise, where the machine has AOVs
    uint64_t window;
    int words;  // to come
  };

  Window& window(uint64_t ordinal);
  std::array<uint16_t, kRegionPixels> codes_of(const GoldenSplat& splat, int region) const;
  bool changes(const Window& window, int region, int quad, const Line& line) const;
  void skip_to(uint64_t ordinal, size_t region, size_t quad, size_t end, const std::string& seen);
  void expect_line(uint64_t ordinal, int lane, size_t region, size_t quad, const GoldenSplat& shown);
  void expect_chunks(uint64_t ordinal, const ChunkSet& chunks, const std::function<bool(const Chunk& chunk)>& needed);
  bool closed_before(const Window& window, uint64_t index, uint64_t walk) const;
  bool has_region(const Chunk& chunk, uint64_t slot) const;
  const Chunk* beside(uint64_t ordinal, ChunkSet& chunks, const Chunk& found);
  void expect_all(uint64_t ordinal);
  // Regions of a splat that the stream before the RUs may leave out. Lists are made before anything is done: they are
  // complete.
  uint64_t may_miss(const Window& window, const Splat& splat) const {
    return config_.has_lists() ? 0 : window.done.mask[splat.part];
  }
  // With layers and with lists a window has one, too.
  static size_t walks_of(const Window& window) { return std::max<size_t>(window.golden.walks.size(), 1); }
  void release();
  void fail(uint64_t window, Mismatch mismatch);
  void fail(uint64_t window, Mismatch mismatch, std::string expected, std::string found = "");
  void end(Place& place, uint64_t kind);
  void expect_mask(const Place& place, const Mismatch& where, const Splat& expected, uint64_t found);
  void on_mark(int unit, const Place& place, const Splat& mark);
  int unit_of(int lane) const { return lane / config_.tap_lanes(); }
  std::array<int, 2> pixel_at(uint64_t window, int region, int pixel) const;  // of the image
  void expect_walk(const Place& place, uint64_t kind, const Mismatch& where);
  void expect_end(const Place& place, uint64_t kind, Mismatch where);

  GoldenInput input_;
  const Config& config_;
  BlendConstants constants_;
  PuRows rows_;  // its tables are made once, not for every line
  uint64_t windows_x_;
  std::vector<uint64_t> chunk_window_;  // of each PU
  std::optional<ChunkSet> listed_;      // with lists: the frame's
  std::vector<Place> splat_place_;
  Place sorted_place_;
  std::vector<uint64_t> ru_window_;            // of each lane of taps: the window of its latest alphas
  std::vector<std::deque<Pending>> pending_;   // of each lane of taps
  std::vector<uint64_t> marks_;                // of each PU: the last watermark of its window (order 2)
  std::unordered_map<uint64_t, Window> open_;  // windows that a stream is in
  uint64_t mismatches_ = 0, beats_ = 0;
  std::optional<Mismatch> first_;
  std::array<int, 2> watched_ = {-1, -1};
  std::vector<Seen> seen_;
};

}  // namespace pipegs
