// SPDX-License-Identifier: Apache-2.0
// frame_watch.cpp: see frame_watch.hpp.
#include "sim/compare/frame_watch.hpp"

#include <algorithm>
#include <bit>

#include "cpp_model/records.hpp"

namespace pipegs {
namespace {

constexpr uint64_t kNever = ~uint64_t{0};

}  // namespace

FrameWatch::FrameWatch(const Config& config)
    : config_(config),
      pu_(config.units),
      ru_(config.units),
      chunk_ends_(config.units),
      splat_ends_(config.units),
      ru_first_(config.units, kNever),
      alpha_lines_(config.units) {}

void FrameWatch::Stream::end(bool window_end, uint64_t cycle) {
  next = cycle + 1;
  ++place.layer;
  if (window_end) ++place.window, place.layer = 0;
}

void FrameWatch::on_cycle(uint64_t cycle_number, const uint8_t* states) {
  cycle_ = cycle_number;
  cycle(cycle_number, states);
}

void FrameWatch::on_chunk(int unit, int kind, const uint32_t*) {
  if (kind == kData) return;
  chunk_ends_[unit].push_back(kind);
  while (std::all_of(chunk_ends_.begin(), chunk_ends_.end(), [](const auto& ends) { return !ends.empty(); })) {
    const bool window_end = chunk_ends_[unit].front() == kWindowEnd;
    for (auto& ends : chunk_ends_) ends.pop_front();
    layer(UnitKind::kDopu, 0, dopu_.place, dopu_.next, cycle_);
    dopu_.end(window_end, cycle_);
  }
}

void FrameWatch::on_splat(int unit, const uint32_t* words) {
  const auto splat = unpack<Splat>(config_, words);
  if (config_.has_lists() && !listed_) {  // the lists are read: all PUs have finished the frame
    listed_ = true;
    for (int k = 0; k < config_.units; ++k) layer(UnitKind::kPu, k, {}, 0, cycle_ - 1);
  }
  if (splat.kind != kData) {
    if (!config_.has_lists()) layer(UnitKind::kPu, unit, pu_[unit].place, pu_[unit].next, cycle_);
    pu_[unit].end(splat.kind == kWindowEnd, cycle_);
    splat_ends_[unit].push_back({splat.kind, cycle_});
    return;
  }
  peak_records_ = std::max(peak_records_, ++records_);
  if (!has_alpha_stores() || splat.ext != 0) return;
  alpha_lines_[unit] += static_cast<uint64_t>(std::popcount(splat.mask));
  peak_alpha_lines_ = std::max(peak_alpha_lines_, alpha_lines_[unit]);
}

void FrameWatch::on_sorted(const uint32_t* words) {
  const uint64_t kind = get_bits(words, 0, config_.kind_w());
  if (kind == kData) {
    --records_;
    return;
  }
  for (int unit = 0; unit < config_.units; ++unit) {
    // An end leaves the merge when it has come out of every SU, so it has come into every one.
    uint64_t came = cycle_;
    for (bool found = false; !found && !splat_ends_[unit].empty(); splat_ends_[unit].pop_front()) {
      found = splat_ends_[unit].front().kind == kind;  // watermarks and ends of parts before it stay in the merge
      came = splat_ends_[unit].front().cycle;
    }
    layer(UnitKind::kSu, unit, sorted_.place, std::min(std::max(came + 1, sorted_.next), cycle_), cycle_);
  }
  sorted_.end(kind == kWindowEnd, cycle_);
}

void FrameWatch::on_alphas(int lane, uint64_t, uint64_t, uint32_t, int, int, const uint32_t*) {
  first_line_ = std::min(first_line_, cycle_);
  auto& first = ru_first_[lane / config_.tap_lanes()];
  first = std::min(first, cycle_);
}

void FrameWatch::on_layer_done(int unit, bool window_done) {
  Stream& ru = ru_[unit];
  layer(UnitKind::kRu, unit, ru.place, std::min(ru_first_[unit], cycle_), cycle_);
  ru.end(window_done, cycle_);
  ru_first_[unit] = kNever;
}

}  // namespace pipegs
