// SPDX-License-Identifier: Apache-2.0
// trace.hpp: what a frame asks of the machine, without pixels and numbers: the input of the timing model.
//
// Idea    One pass of the golden model's bit-accurate models over all windows leaves what control needs: which nodes
//         pass the DOPU's test (order 2: and their buckets of depth), which Gaussians of a chunk survive the cull, how
//         many regions their boxes have and which they keep, their sort keys and slots; and after how many lines of
//         alphas a region is opaque, which makes the done feedback.
// Pairs   What is sorted and blended is a (Gaussian, window) pair. A survivor of a window's cull is one; with parts it
//         becomes one in each part of the window, and with lists (order 1), where the DOPU walks once for the frame,
//         one in each window of its box.
// Reuse   A trace depends on scene, camera and on all of the configuration but the entries that timing_config() names:
//         those may be varied from run to run on the same trace.
// Threads Windows are independent; the trace does not depend on their number.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cpp_model/golden.hpp"
#include "cpp_model/open.hpp"
#include "cpp_model/regions.hpp"

namespace pipegs {

// A cell, group or chunk: its children, or its Gaussians.
struct TimingNode {
  uint32_t first = 0, count = 0;
};

// For which rectangles of a walk a node passes: of each side (left, right, top, bottom) 16 bits, bit n with n columns
// or rows of regions of it closed. Without Occlusion bit 0 alone is asked for.
using TimingSides = uint64_t;
inline constexpr TimingSides kWholePasses = 0x0001000100010001;

// A chunk that passes in a walk. In the order of the walk; with order 2 in the order of the table.
struct TimingChunk {
  uint32_t chunk = 0;      // number of the node
  uint32_t first = 0;      // its first survivor
  uint64_t survivors = 0;  // which of its Gaussians pu_cull keeps, one after the other for each eye that is wanted
  uint16_t bucket = 0;     // of depth, order 2
  uint32_t walk = 0;       // of TimingTrace::walks
  TimingSides sides = kWholePasses;
};

// A cell or group that passes, with order 2; in the order of the table.
struct TimingParent {
  uint32_t node = 0;
  uint32_t first = 0;  // the first of its children that pass: of TimingWalk::groups_ranked, or of chunks_sent
  uint16_t bucket = 0;
  TimingSides sides = kWholePasses;
  uint16_t far = 0;   // of a group: bucket of its farthest corner, for dopu_load
  TimingNode opened;  // the children that are read
};

// A walk of the DOPU, or with lists that of the frame. A window that goes by parts has one more before them, which is
// given up before a group of it is opened.
struct TimingWalk {
  size_t window = 0;  // of TimingTrace::windows
  uint64_t walk = kWholeWalk;
  int eyes = 1;  // how many it is for
  bool given_up = false;
  bool ends = true;                                       // its window's last
  size_t first_chunk = 0, chunks = 0;                     // of TimingTrace::chunks_sent
  std::vector<uint64_t> cells, groups;                    // bits of the nodes that pass, by node; orders 0 and 1
  std::vector<TimingParent> cells_ranked, groups_ranked;  // order 2
};

struct TimingWindow {
  static constexpr uint32_t kNotDone = ~uint32_t{0};
  RegionSet outside;                            // regions without a pixel inside the image
  std::array<uint32_t, kRegions> done_after{};  // lines of a region until it is opaque, or kNotDone
  // With quads, by region and quad (row by row): without a pixel inside the image; Gaussians until all of it has
  // stopped.
  std::array<uint16_t, kRegions> quads_outside{};
  std::vector<uint32_t> quad_done_after;
};

// 4 bits a side, left lowest.
inline uint16_t pack_most(const Closed& most) {
  return static_cast<uint16_t>(most.left | most.right << 4 | most.top << 8 | most.bottom << 12);
}
// Whether on some side more is closed.
inline bool beyond(const Closed& closed, uint16_t most) {
  return closed.left > (most & 15u) || closed.right > (most >> 4 & 15u) || closed.top > (most >> 8 & 15u) ||
         closed.bottom > (most >> 12 & 15u);
}

struct TimingTrace {
  Config config;
  Frame frame;
  Picture picture;
  uint64_t slots = 0;  // of the packed scene
  std::vector<TimingNode> cells, groups, chunks;
  std::vector<TimingWalk> walks;  // of each window in turn; one with lists
  std::vector<TimingChunk> chunks_sent;
  std::vector<TimingWindow> windows;  // row by row from frame.first to frame.last
  // By survivor of a cull.
  std::vector<uint32_t> slot;    // in packed memory
  std::vector<uint32_t> pairs;   // parts, lists: its first pair; one more entry at the end
  std::vector<uint16_t> most;    // Occlusion: by pack_most, with how many closed regions it is kept
  std::vector<uint8_t> dropped;  // TightCull: by pu_reach; its pair, if it has one, is never asked for
  // By pair.
  std::vector<uint64_t> mask, key;  // regions of the part; sort key
  std::vector<uint8_t> boxes;       // cycles in which pu_intersect walks its box; 0: it has none
  std::vector<uint16_t> number;     // lists: of its window; parts: of its part
  std::vector<uint8_t> passed;      // lists: pu_expand passes over its window
  std::vector<uint32_t> survivor;   // parts
  // With quads: which are visible in each region of the pair's mask; where the pair's first one lies.
  std::vector<uint16_t> quads;
  std::vector<uint32_t> quads_first;

  uint64_t part(uint32_t pair) const { return config.parts() > 1 ? number[pair] : 0; }
};

TimingTrace timing_trace(const GoldenInput& input, unsigned threads = 0);

// `config` with every entry set back that a run may vary on one trace: units, pixels_per_row, alpha_lines, ...
Config timing_config(Config config);

}  // namespace pipegs
