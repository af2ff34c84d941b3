// SPDX-License-Identifier: Apache-2.0
// flips.cpp: see flips.hpp.
#include "sim/studies/explore/flips.hpp"

#include <algorithm>
#include <cmath>

#include "cpp_model/pu/rows/pu_rows.hpp"

namespace pipegs {
namespace {

PixelRect intersection(const PixelRect& a, const PixelRect& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

uint64_t pixels(const PixelRect& r) {
  return r.empty() ? 0 : static_cast<uint64_t>(r.x1 - r.x0) * static_cast<uint64_t>(r.y1 - r.y0);
}

}  // namespace

bool FlipCounter::Footprint::counts(int x, int y) const {
  const double power = power_at(conic, mean.x - x, mean.y - y);
  return power >= least_power && opacity * std::exp(std::min(power, 0.0)) >= kMinAlpha;
}

FlipCounter::FlipCounter(const Scene& scene, const Camera& camera, double near_plane, const PixelRect& area,
                         int squares) {
  const int columns = (area.x1 - area.x0 + kSquare - 1) / kSquare, rows = (area.y1 - area.y0 + kSquare - 1) / kSquare;
  const int every = std::max(1, columns * rows / squares);
  uint64_t seen = 0;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      if ((x + 5 * y) % every != 0) continue;
      const int x0 = area.x0 + kSquare * x, y0 = area.y0 + kSquare * y;
      squares_.push_back({intersection({x0, y0, x0 + kSquare, y0 + kSquare}, area), {}});
      seen += pixels(squares_.back().pixels);
    }
  }
  sampled_ = static_cast<double>(seen) / static_cast<double>(std::max<uint64_t>(1, pixels(area)));
  const ProjectionOptions options{Semantics::kExact, near_plane, scene.antialiased, 0};
  for (size_t i = 0; i < scene.gaussians.size(); ++i) {
    ActivatedGaussian gaussian;
    if (activate(scene, i, gaussian) != Cull::kNone) continue;
    const TruthProjection p = project_truth(gaussian, scene.gaussians[i].sh_dc, nullptr, 0, camera, options);
    const PixelRect rect = footprint(p, camera, Semantics::kExact);
    for (Square& square : squares_) {
      if (intersection(rect, square.pixels).empty()) continue;
      square.footprints.push_back(
          {p.mean, p.conic, p.opacity, -std::log(255 * p.opacity) - 1e-9, rect, static_cast<uint32_t>(i)});
    }
  }
}

Flips FlipCounter::count(const GoldenInput& input, const std::vector<uint32_t>& rank) const {
  const int side = input.packed->config.window;
  Flips sum;
  for (const Square& square : squares_) {
    for (int y = square.pixels.y0 / side; y * side < square.pixels.y1; ++y) {
      for (int x = square.pixels.x0 / side; x * side < square.pixels.x1; ++x) {
        const Flips flips = count_window(input, rank, square, static_cast<uint64_t>(x), static_cast<uint64_t>(y));
        sum.decisions += flips.decisions;
        sum.flipped += flips.flipped;
      }
    }
  }
  return sum;
}

Flips FlipCounter::count_window(const GoldenInput& input, const std::vector<uint32_t>& rank, const Square& square,
                                uint64_t x, uint64_t y) const {
  const Config& config = input.packed->config;
  const GoldenWindow window = golden_window(input, x, y);
  const PuRows rows(config);
  const BlendConstants constants(config);
  const int x0 = static_cast<int>(x) * config.window, y0 = static_cast<int>(y) * config.window;
  const PixelRect here = intersection(square.pixels, {x0, y0, x0 + config.window, y0 + config.window});

  // Who takes a turn: a Gaussian of the machine with its splats (one for each part), of the truth, or of both.
  struct Turn {
    uint64_t rank;
    std::array<const GoldenSplat*, kParts> splats = {};
    const Footprint* footprint = nullptr;
  };
  std::vector<Turn> turns;
  for (const GoldenLayer& layer : window.layers) {
    for (const GoldenSplat& splat : layer.splats)
      turns.push_back({rank[splat.splat.index]}), turns.back().splats[splat.splat.part] = &splat;
  }
  for (const Footprint& footprint : square.footprints) {
    if (!intersection(footprint.rect, here).empty()) turns.push_back({rank[footprint.index], {}, &footprint});
  }
  std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) { return a.rank < b.rank; });
  size_t kept = 0;
  for (size_t i = 0; i < turns.size(); ++i) {  // ranks are unique: equal ones are one Gaussian
    if (kept > 0 && turns[kept - 1].rank == turns[i].rank) {
      Turn& turn = turns[kept - 1];
      if (turns[i].footprint != nullptr) turn.footprint = turns[i].footprint;
      for (size_t part = 0; part < turn.splats.size(); ++part)
        if (turns[i].splats[part] != nullptr) turn.splats[part] = turns[i].splats[part];
    } else {
      turns[kept++] = turns[i];
    }
  }
  turns.resize(kept);

  Flips flips;
  for (int r = 0; r < config.regions(); ++r) {
    const int rx = x0 + 8 * region_x(config, r), ry = y0 + 8 * region_y(config, r), bit = region_bit(config, r);
    const PixelRect area = intersection(here, {rx, ry, rx + 8, ry + 8});
    if (area.empty()) continue;
    RegionState state = ru_fresh_region(config, input.frame, x, y, r);
    for (const Turn& turn : turns) {
      const GoldenSplat* splat = turn.splats[static_cast<size_t>(region_part(config, r))];
      const bool shown = splat != nullptr && (splat->splat.mask >> bit & 1) != 0;
      alignas(64) uint16_t codes[kRegionPixels] = {};
      if (shown) pu_region_line(rows, splat->job, bit, codes);
      const PixelRect touched = turn.footprint == nullptr ? PixelRect{} : intersection(turn.footprint->rect, area);
      if (!shown && touched.empty()) continue;
      for (int i = 0; i < kRegionPixels; ++i) {
        const int px = rx + i % 8, py = ry + i / 8;
        if (state.done[i] != 0 || px >= area.x1 || py >= area.y1) continue;
        const bool machine = codes[i] != 0;
        const bool truth = px >= touched.x0 && px < touched.x1 && py >= touched.y0 && py < touched.y1 &&
                           turn.footprint->counts(px, py);
        flips.decisions += machine || truth;
        flips.flipped += machine != truth;
      }
      if (!shown) continue;
      const Splat& s = splat->splat;
      const uint32_t color[3] = {static_cast<uint32_t>(s.red), static_cast<uint32_t>(s.green),
                                 static_cast<uint32_t>(s.blue)};
      if (ru_blend_region(constants, state, codes, color)) break;
    }
  }
  return flips;
}

}  // namespace pipegs
