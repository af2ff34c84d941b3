// SPDX-License-Identifier: Apache-2.0
// frame_record.cpp: see frame_record.hpp.
#include "sim/report/html/frame/frame_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "cpp_model/regions.hpp"
#include "sim/compare/simulate.hpp"

namespace pipegs {
namespace {

void join(uint32_t& to, uint32_t more) { to += more; }
void join(FrameRecord::States& to, const FrameRecord::States& more) {
  for (size_t state = 0; state < to.size(); ++state) to[state] += more[state];
}

// Of each two neighbours one.
template <class Piece>
void join_pairs(std::vector<Piece>& pieces) {
  const size_t half = pieces.size() / 2;
  for (size_t i = 0; i < half; ++i) {
    Piece both = pieces[2 * i];
    join(both, pieces[2 * i + 1]);
    pieces[i] = both;
  }
  pieces.resize(half);
}

}  // namespace

FrameRecord::FrameRecord(const Config& config, const PixelRect& pixels)
    : FrameWatch(config),
      units_(static_cast<size_t>(1 + 3 * config.units)),
      lines_(memory_streams(config).size()),
      first_x_(static_cast<uint64_t>(pixels.x0 / config.window)),
      first_y_(static_cast<uint64_t>(pixels.y0 / config.window)),
      columns_(static_cast<uint64_t>((pixels.x1 - 1) / config.window) - first_x_ + 1),
      rows_(static_cast<uint64_t>((pixels.y1 - 1) / config.window) - first_y_ + 1),
      blends_(columns_ * rows_ * static_cast<uint64_t>(config.regions()), 0) {}

void FrameRecord::join_pieces() {
  for (auto& unit : units_) join_pairs(unit);
  for (auto& stream : lines_) join_pairs(stream);
  grain_ *= 2;
  pieces_ /= 2;
}

void FrameRecord::cycle(uint64_t cycle, const uint8_t* states) {
  if (cycle % grain_ == 0) {
    if (pieces_ == kMostPieces && grain_ < kLongestPiece) join_pieces();
    for (auto& unit : units_) unit.emplace_back();
    for (auto& stream : lines_) stream.push_back(0);
    ++pieces_;
  }
  for (size_t unit = 0; unit < units_.size(); ++unit) ++units_[unit].back()[states[unit]];
}

void FrameRecord::layer(UnitKind kind, int k, const FramePlace& place, uint64_t begin, uint64_t end) {
  const int unit = kind == UnitKind::kDopu ? 0 : 1 + (static_cast<int>(kind) - 1) * config().units + k;
  const auto [span, fresh] = spans_.try_emplace({unit, place.window}, Span{begin, end});
  if (!fresh) span->second = {std::min(span->second.begin, begin), std::max(span->second.end, end)};
}

void FrameRecord::on_request(int tag, bool, uint64_t, int lines) {
  auto& stream = lines_[memory_stream(config(), tag)];
  if (!stream.empty()) stream.back() += static_cast<uint32_t>(lines);
}

void FrameRecord::on_alphas(int lane, uint64_t window_x, uint64_t window_y, uint32_t index, int region, int quarter,
                            const uint32_t* line) {
  FrameWatch::on_alphas(lane, window_x, window_y, index, region, quarter, line);
  const auto side = static_cast<uint64_t>(config().window / 8);
  const uint64_t x = (window_x - first_x_) * side + static_cast<uint64_t>(region_x(config(), region)),
                 y = (window_y - first_y_) * side + static_cast<uint64_t>(region_y(config(), region));
  ++blends_.at(y * columns_ * side + x);
}

void FrameRecord::finish(const RtlResult& rtl) {
  std::vector<UnitCycles> counted = rtl.dopu;
  for (const auto* kind : {&rtl.pu, &rtl.su, &rtl.ru}) counted.insert(counted.end(), kind->begin(), kind->end());
  for (size_t unit = 0; unit < units_.size(); ++unit) {
    std::array<uint64_t, 4> sum{};
    for (const States& piece : units_[unit]) {
      for (size_t state = 0; state < 4; ++state) sum[state] += piece[state];
    }
    const UnitCycles& one = counted.at(unit);
    if (sum != std::array<uint64_t, 4>{one.busy, one.starved, one.blocked, one.memory})
      throw std::logic_error(fmt::format("the states of unit {} do not sum to its performance counters", unit));
  }
}

std::vector<uint64_t> FrameRecord::window_cycles() const {
  std::vector<uint64_t> ends(columns_ * rows_, 0), cycles;
  const int first_ru = 1 + 2 * config().units;
  for (const auto& [place, span] : spans_) {
    if (place.first >= first_ru) ends.at(place.second) = std::max(ends.at(place.second), span.end + 1);
  }
  uint64_t before = 0;
  for (const uint64_t end : ends) {
    cycles.push_back(std::max(end, before) - before);
    before = std::max(end, before);
  }
  return cycles;
}

}  // namespace pipegs
