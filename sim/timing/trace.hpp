// trace.hpp: what a frame asks of the machine, without pixels and numbers: the input of the timing model.
//
// Idea    One pass of the golden model's twins over all windows leaves what control needs: which nodes pass the DOPU's
//         test, which Gaussians of a chunk survive the cull, how many regions their boxes have and which they keep, their
//         sort keys and slots; and after how many lines of alphas a region is opaque, which makes the done feedback.
// Reuse   A trace depends on scene, camera and on all of the configuration but the entries that timing_config() names: those
//         may be varied from run to run on the same trace.
// Threads Windows are independent; the trace does not depend on their number.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cpp_model/golden.hpp"

namespace pipegs {

// A cell, group or chunk: its children, or its Gaussians.
struct TimingNode {
  uint32_t first = 0, count = 0;
};

// A chunk that passes in a window, in the order of the walk.
struct TimingChunk {
  uint32_t chunk = 0;       // number of the node
  uint32_t first = 0;       // its first survivor
  uint64_t survivors = 0;   // which of its Gaussians the cull keeps
};

struct TimingWindow {
  static constexpr uint32_t kNotDone = ~uint32_t{0};
  uint64_t outside = 0;                  // regions without a pixel inside the image
  size_t first_chunk = 0, chunks = 0;    // of TimingTrace::chunks_sent
  std::vector<uint64_t> cells, groups;   // bits of the nodes that pass, by node
  std::array<uint32_t, 64> done_after{};  // lines of a region until it is opaque, or kNotDone
};

struct TimingTrace {
  Config config;
  Frame frame;
  std::vector<TimingNode> cells, groups, chunks;
  std::vector<TimingWindow> windows;      // row by row from frame.first to frame.last
  std::vector<TimingChunk> chunks_sent;
  // Survivors of the cull: (Gaussian, window) pairs.
  std::vector<uint64_t> mask, key;  // regions; depth key above index
  std::vector<uint32_t> slot;       // of the Gaussian in packed memory
  std::vector<uint8_t> boxes;       // regions of the box that pu_intersect walks; 0: it has none
  Work work;                        // as far as the trace knows it: without alphas blended
};

// Throws std::invalid_argument for a rung of which there is no trace.
TimingTrace timing_trace(const GoldenInput& input, unsigned threads = 0);

// `config` with every entry set back that a run may vary on one trace: units, pixels_per_row, alpha_lines, ...
Config timing_config(Config config);

}  // namespace pipegs
