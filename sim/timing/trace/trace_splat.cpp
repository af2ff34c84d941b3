// SPDX-License-Identifier: Apache-2.0
// trace_splat.cpp: see trace_splat.hpp.
#include "sim/timing/trace/trace_splat.hpp"

#include <algorithm>
#include <bit>

#include "cpp_model/pu/conic/pu_coeff.hpp"
#include "cpp_model/pu/front/pu_cull.hpp"
#include "cpp_model/pu/conic/pu_intersect.hpp"
#include "cpp_model/pu/front/pu_reach.hpp"
#include "cpp_model/pu/rows/pu_rows.hpp"
#include "cpp_model/ru/ru_quads.hpp"
#include "cpp_model/su/su.hpp"

namespace pipegs {

std::optional<GoldenConic> trace_conic(const GoldenInput& input, const Chunk& chunk, uint64_t slot, bool* late,
                                       Closed* most) {
  const Config& config = input.packed->config;
  const Frame& frame = input.frame;
  Gap gap;
  const std::optional<Visible> visible =
      pu_cull(config, frame, golden_fetched(chunk, input.packed->gaussians[slot], slot), nullptr, &gap, {},
              config.occlusion ? most : nullptr);
  if (!visible) return std::nullopt;
  const bool drop = config.tight_cull && !pu_reach(config, frame, *visible, gap);
  if (late != nullptr) *late = drop;
  if (drop) return std::nullopt;
  return golden_conic(config, frame, *visible);
}

TracePair trace_pair(const GoldenInput& input, const Conic& conic, const Payload& payload, uint64_t part) {
  const Config& config = input.packed->config;
  const Coeff coeff = pu_coeff(config, input.frame, conic);
  const Tiles tiles = pu_intersect(config, input.frame, coeff);
  TracePair pair;
  pair.boxes = static_cast<uint8_t>(pu_intersect_steps(config, coeff));
  if (tiles.mask == 0) return pair;
  pair.splat.mask = tiles.mask;
  pair.splat.part = part;
  pair.splat.key = splat_key(config, payload.depth, payload.index, part);
  RowJob& job = pair.splat.job;
  job.a = tiles.a, job.b = tiles.b, job.c = tiles.c, job.d = tiles.d, job.e = tiles.e, job.f = tiles.f;
  return pair;
}

void trace_quads(const PuRows& rows, const TraceSplat& splat, std::vector<uint16_t>& quads,
                 std::vector<uint32_t>& first) {
  if (!rows.config.quads) return;
  first.push_back(static_cast<uint32_t>(quads.size()));
  for (uint64_t rest = splat.mask; rest != 0; rest &= rest - 1) {
    alignas(64) uint16_t codes[kRegionPixels];
    pu_region_line(rows, splat.job, std::countr_zero(rest), codes);
    quads.push_back(static_cast<uint16_t>(ru_live_quads(codes, 0)));
  }
}

TimingWindow trace_window(const GoldenInput& input, const PuRows& rows, uint64_t x, uint64_t y,
                          std::vector<std::vector<TraceSplat>>& layers) {
  const Config& config = input.packed->config;
  const BlendConstants constants(config, input.frame.raster.rest);
  const uint32_t black[3] = {0, 0, 0};
  TimingWindow window;
  std::vector<RegionState> regions;
  RegionSet done;
  for (int r = 0; r < config.regions(); ++r) {
    regions.push_back(ru_fresh_region(config, input.frame, x, y, r));
    done.add(config, r, regions.back().all_done());
  }
  window.outside = done;
  window.done_after.fill(TimingWindow::kNotDone);
  std::array<uint32_t, kRegions> lines{};
  std::vector<std::array<uint32_t, kQuads>> gaussians;  // of each quad
  if (config.quads) {
    gaussians.resize(regions.size());
    window.quad_done_after.resize(kQuads * regions.size(), TimingWindow::kNotDone);
    for (size_t r = 0; r < regions.size(); ++r)
      window.quads_outside[r] = static_cast<uint16_t>(ru_stopped_quads(regions[r]));
  }
  const auto count_quads = [&](size_t r, uint32_t live) {
    if (live == 0) return;
    const uint32_t stopped = ru_stopped_quads(regions[r]);
    for (; live != 0; live &= live - 1) {
      const auto quad = static_cast<size_t>(std::countr_zero(live));
      ++gaussians[r][quad];
      if (stopped >> quad & 1) window.quad_done_after[kQuads * r + quad] = gaussians[r][quad];
    }
  };
  for (std::vector<TraceSplat>& layer : layers) {
    std::sort(layer.begin(), layer.end(), [](const TraceSplat& a, const TraceSplat& b) { return a.key < b.key; });
    for (const TraceSplat& splat : layer) {
      for (uint64_t rest = splat.mask & ~done.mask[splat.part]; rest != 0; rest &= rest - 1) {
        const int bit = std::countr_zero(rest);
        const auto r = static_cast<size_t>(region_number(config, splat.part, bit));
        alignas(64) uint16_t codes[kRegionPixels];
        pu_region_line(rows, splat.job, bit, codes);
        ++lines[r];
        const uint32_t live = config.quads ? ru_live_quads(codes, ru_stopped_quads(regions[r])) : 0;
        const bool closed = ru_blend_region(constants, regions[r], codes, black);
        count_quads(r, live);
        if (!closed) continue;
        done.add(config, static_cast<int>(r));
        window.done_after[r] = lines[r];
      }
    }
  }
  return window;
}

}  // namespace pipegs
