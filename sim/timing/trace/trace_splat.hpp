// SPDX-License-Identifier: Apache-2.0
// trace_splat.hpp: what the trace takes from a Gaussian: its conic, its regions in a window, and when regions are
// opaque.
//
// Idea    The models of the PU one after the other, without colours: these change no cycle.
#pragma once

#include <optional>
#include <vector>

#include "cpp_model/golden.hpp"
#include "cpp_model/pu/rows/pu_rows.hpp"
#include "sim/timing/trace/trace.hpp"

namespace pipegs {

// A splat whose alphas the blend needs.
struct TraceSplat {
  uint64_t key = 0, mask = 0, part = 0;
  RowJob job;
};

struct TracePair {
  TraceSplat splat;  // key is 0 without regions
  uint8_t boxes = 0;
};

// With quads: appends which quads of each region of a splat hold a visible pixel, and where the first of these stands.
void trace_quads(const PuRows& rows, const TraceSplat& splat, std::vector<uint16_t>& quads,
                 std::vector<uint32_t>& first);

// Nothing when the cull drops it; `late`: only pu_reach does. `most`: see pu_cull.
std::optional<GoldenConic> trace_conic(const GoldenInput& input, const Chunk& chunk, uint64_t slot,
                                       bool* late = nullptr, Closed* most = nullptr, int eye = 0);

// A Gaussian in the window, or its part, that the mean is relative to.
TracePair trace_pair(const GoldenInput& input, const Conic& conic, const Payload& payload, uint64_t part);

// Blends T only, layer by layer, as far as it says when a region is opaque. Sorts the layers.
TimingWindow trace_window(const GoldenInput& input, const PuRows& rows, uint64_t x, uint64_t y,
                          std::vector<std::vector<TraceSplat>>& layers);

// Order 1.
void trace_lists(const GoldenInput& input, unsigned threads, TimingTrace& trace);

}  // namespace pipegs
