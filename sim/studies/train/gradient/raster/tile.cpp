// SPDX-License-Identifier: Apache-2.0
// tile: see tile.hpp.
#include "sim/studies/train/gradient/raster/tile.hpp"

#include <algorithm>

#include "cpp_model/float/projection.hpp"

namespace pipegs {
namespace {

constexpr double kLeastPower = -7.9943534368588580;  // log2(1/255)
constexpr double kMargin = 1e-3;                     // of a row's test; the pixel's own compares alpha itself
constexpr std::size_t kLookEvery = 8;                // splats between two looks which rows have stopped

// Of one splat, by row of the tile.
template <class Scalar>
struct TileRows {
  Scalar dy[kTile];       // mean - row
  Scalar start[kTile];    // u at the row's first pixel, times steep
  Scalar highest[kTile];  // power where u = 0, opacity included
  Scalar reach[kTile];    // below 0: no pixel of the row reaches 1/255

  PIPEGS_INLINED TileRows(const DrawnSplat<Scalar>& splat, const TileArea& area) {
    Lanes<Scalar> row;
    count_lanes<Scalar>(row);
    const auto mean_x = static_cast<Scalar>(splat.mean.x - area.x), mean_y = static_cast<Scalar>(splat.mean.y - area.y);
    const Lanes<Scalar> away = mean_y - row, top = splat.log2_opacity - splat.tall * away * away;
    const Lanes<Scalar> center = mean_x - splat.slope * away;
    Lanes<Scalar> nearest = center < Scalar{0} ? Lanes<Scalar>{} : center;
    nearest = nearest > Scalar{kTile - 1} ? Lanes<Scalar>{} + Scalar{kTile - 1} : nearest;
    const Lanes<Scalar> u = splat.steep * (center - nearest), left = top - u * u - Scalar{kLeastPower - kMargin};
    const Lanes<Scalar> begin = splat.steep * center;
    std::memcpy(dy, &away, sizeof(away));
    std::memcpy(start, &begin, sizeof(begin));
    std::memcpy(highest, &top, sizeof(top));
    std::memcpy(reach, &left, sizeof(left));
  }
};

template <class Scalar>
PIPEGS_INLINED void blend(const TileArea& area, std::span<const DrawnSplat<Scalar>> splats,
                          std::span<const TilePair> list, TileState<Scalar>& state, TileColors<Scalar>& colors) {
  constexpr auto kCap = static_cast<Scalar>(kMaxAlpha), kCut = static_cast<Scalar>(kMinAlpha),
                 kStop = static_cast<Scalar>(kMinTransmittance);
  using L = Lanes<Scalar>;
  using M = Masks<Scalar>;
  L lane;
  count_lanes<Scalar>(lane);
  M open[kTile];
  bool row_open[kTile];
  for (int y = 0; y < kTile; ++y) {
    row_open[y] = y < area.rows;
    open[y] = lane < static_cast<Scalar>(row_open[y] ? area.columns : 0);
    state.transmittance[y] = L{} + Scalar{1};
    state.last[y] = M{};
    for (auto& channel : colors.rgb) channel[y] = L{};
  }
  for (std::size_t n = 0; n < list.size(); ++n) {
    const DrawnSplat<Scalar>& splat = splats[list[n].splat];
    const TileRows<Scalar> rows(splat, area);
    const L step = splat.steep * lane;
    for (int y = 0; y < kTile; ++y) {
      if (!(rows.reach[y] >= 0) || !row_open[y]) continue;
      const L u = rows.start[y] - step;
      L alpha = rows.highest[y] - u * u;
      exp2_lanes<Scalar>(alpha);
      alpha = alpha > kCap ? L{} + kCap : alpha;
      const L before = state.transmittance[y], next = before * (Scalar{1} - alpha);
      const M counts = (alpha >= kCut) & open[y], stops = counts & (next < kStop), takes = counts & ~stops;
      open[y] &= ~stops;
      const L weight = takes ? alpha * before : L{};
      state.transmittance[y] = takes ? next : before;
      state.last[y] = takes ? M{} + static_cast<typename LanesOf<Scalar>::Integer>(n + 1) : state.last[y];
      for (int channel = 0; channel < 3; ++channel) colors.rgb[channel][y] += weight * splat.rgb[channel];
    }
    if ((n + 1) % kLookEvery != 0) continue;
    bool some = false;
    for (int y = 0; y < kTile; ++y) some |= row_open[y] = row_open[y] && any<Scalar>(open[y]);
    if (!some) break;
  }
}

template <class Scalar>
PIPEGS_INLINED void unblend(const TileArea& area, std::span<const DrawnSplat<Scalar>> splats,
                            std::span<const TilePair> list, const TileState<Scalar>& state,
                            const TileColors<Scalar>& gradient, const glm::vec3& background, PairSums<Scalar>* sums) {
  constexpr auto kCap = static_cast<Scalar>(kMaxAlpha), kCut = static_cast<Scalar>(kMinAlpha);
  using Integer = typename LanesOf<Scalar>::Integer;
  using L = Lanes<Scalar>;
  using M = Masks<Scalar>;
  L lane, transmittance[kTile], behind[kTile];
  count_lanes<Scalar>(lane);
  Integer row_last[kTile], last = 0;
  for (int y = 0; y < kTile; ++y) {
    transmittance[y] = state.transmittance[y];
    behind[y] = L{};
    for (int channel = 0; channel < 3; ++channel) {
      behind[y] += gradient.rgb[channel][y] * static_cast<Scalar>(background[channel]);
    }
    row_last[y] = 0;
    for (int x = 0; x < kTile; ++x) row_last[y] = std::max<Integer>(row_last[y], state.last[y][x]);
    last = std::max(last, row_last[y]);
  }
  for (auto n = static_cast<Integer>(list.size()); n > 0; --n) {
    const TilePair& pair = list[static_cast<std::size_t>(n - 1)];
    PairSums<Scalar>& out = sums[pair.number];
    out = {};
    if (n > last) continue;
    const DrawnSplat<Scalar>& splat = splats[pair.splat];
    const TileRows<Scalar> rows(splat, area);
    const L step = splat.steep * lane;
    L power[6] = {}, color[3] = {};
    bool touched = false;
    for (int y = 0; y < kTile; ++y) {
      if (!(rows.reach[y] >= 0) || row_last[y] < n) continue;
      touched = true;
      const L u = rows.start[y] - step;
      L free = rows.highest[y] - u * u;
      exp2_lanes<Scalar>(free);
      L alpha = free > kCap ? L{} + kCap : free;
      const M takes = (alpha >= kCut) & (state.last[y] >= n);
      alpha = takes ? alpha : L{};
      const L before = transmittance[y] / (Scalar{1} - alpha), weight = alpha * before;
      transmittance[y] = before;
      L ahead = -behind[y];  // g.c - b
      for (int channel = 0; channel < 3; ++channel) {
        const L& g = gradient.rgb[channel][y];
        ahead += splat.rgb[channel] * g;
        color[channel] += weight * g;
      }
      behind[y] += alpha * ahead;
      L change = weight * ahead;
      change = free < kCap ? change : L{};
      const Scalar dy = rows.dy[y];
      const L change_u = change * u, change_y = change * dy;
      power[0] += change;
      power[1] += change_u;
      power[2] += change_y;
      power[3] += change_u * u;
      power[4] += change_u * dy;
      power[5] += change_y * dy;
    }
    if (!touched) continue;
    for (int k = 0; k < 6; ++k) out.power[k] = sum<Scalar>(power[k]);
    for (int channel = 0; channel < 3; ++channel) out.color[channel] = sum<Scalar>(color[channel]);
  }
}

// Specialisations cannot be compiled for several levels, plain functions can.
PIPEGS_LEVELS void blend_floats(const TileArea& area, std::span<const DrawnSplat<float>> splats,
                                std::span<const TilePair> list, TileState<float>& state, TileColors<float>& colors) {
  blend<float>(area, splats, list, state, colors);
}

PIPEGS_LEVELS void unblend_floats(const TileArea& area, std::span<const DrawnSplat<float>> splats,
                                  std::span<const TilePair> list, const TileState<float>& state,
                                  const TileColors<float>& gradient, const glm::vec3& background,
                                  PairSums<float>* sums) {
  unblend<float>(area, splats, list, state, gradient, background, sums);
}

}  // namespace

template <class Scalar>
void blend_tile(const TileArea& area, std::span<const DrawnSplat<Scalar>> splats, std::span<const TilePair> list,
                TileState<Scalar>& state, TileColors<Scalar>& colors) {
  if constexpr (sizeof(Scalar) == 4) blend_floats(area, splats, list, state, colors);
  else blend<Scalar>(area, splats, list, state, colors);
}

template <class Scalar>
void unblend_tile(const TileArea& area, std::span<const DrawnSplat<Scalar>> splats, std::span<const TilePair> list,
                  const TileState<Scalar>& state, const TileColors<Scalar>& gradient, const glm::vec3& background,
                  PairSums<Scalar>* sums) {
  if constexpr (sizeof(Scalar) == 4) unblend_floats(area, splats, list, state, gradient, background, sums);
  else unblend<Scalar>(area, splats, list, state, gradient, background, sums);
}

template void blend_tile(const TileArea&, std::span<const DrawnSplat<float>>, std::span<const TilePair>,
                         TileState<float>&, TileColors<float>&);
template void blend_tile(const TileArea&, std::span<const DrawnSplat<double>>, std::span<const TilePair>,
                         TileState<double>&, TileColors<double>&);
template void unblend_tile(const TileArea&, std::span<const DrawnSplat<float>>, std::span<const TilePair>,
                           const TileState<float>&, const TileColors<float>&, const glm::vec3&, PairSums<float>*);
template void unblend_tile(const TileArea&, std::span<const DrawnSplat<double>>, std::span<const TilePair>,
                           const TileState<double>&, const TileColors<double>&, const glm::vec3&, PairSums<double>*);

}  // namespace pipegs
