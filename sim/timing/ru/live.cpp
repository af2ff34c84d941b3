// SPDX-License-Identifier: Apache-2.0
// live.cpp: see live.hpp.
#include "sim/timing/ru/live.hpp"

#include "cpp_model/ru/ru_quads.hpp"
#include "sim/timing/machine.hpp"

namespace pipegs::timing {
namespace {

constexpr Cycle kAgain = 4;  // cycles until a quad may be issued again

}  // namespace

Live::Live() { last_issue_.fill(kLongAgo); }

void Live::start_window(const TimingWindow* window) {
  window_ = window;
  gaussians_.fill(0);
  if (window != nullptr) stopped_ = window->quads_outside;
}

uint8_t Live::live_of(uint16_t quads, int half, int group) {
  return static_cast<uint8_t>((quads >> ru_quad(group, 2 * half) & 1) | (quads >> ru_quad(group, 2 * half + 1) & 1)
                                                                            << 1);
}

bool Live::regions_empty() const {
  for (const Stage& stage : regions_) {
    if (stage.valid) return false;
  }
  return true;
}

bool Live::idle(Cycle now) const {
  if (!regions_empty() || rows_.valid || halves_ != 0) return false;
  for (const Group& group : groups_) {
    if (!group.queue.empty() || now < group.last_issue + kInside) return false;
  }
  return true;
}

// The half that is next leaves: all groups with live quads of it have room.
bool Live::fires(Cycle now) const {
  if (halves_ == 0) return false;
  for (int g = 0; g < kGroups; ++g) {
    if (live_of(pixels_.quads, halves_ & 1 ? 0 : 1, g) != 0 && !groups_[static_cast<size_t>(g)].queue.room(now))
      return false;
  }
  return true;
}

void Live::issue(Cycle now, int lane, int g, std::vector<Stop>& stops) {
  Group& group = groups_[static_cast<size_t>(g)];
  if (!group.queue.valid(now)) return;
  const Half& half = group.queue.front();
  const bool second = group.second || (half.live & 1) == 0;
  const int row = 2 * half.half + (second ? 1 : 0);
  const auto quad = static_cast<size_t>(kQuads * half.region + ru_quad(g, row));
  if (now < last_issue_[quad] + kAgain) return;
  last_issue_[quad] = group.last_issue = now;
  shown_[0].push_back({static_cast<uint8_t>(lane * kGroups + g), static_cast<uint16_t>(4 * half.region + row)});
  if (++gaussians_[quad] == window_->quad_done_after[quad])
    stops.push_back({now + kInside, static_cast<uint16_t>(quad)});
  group.second = !second && (half.live & 2) != 0;
  if (!group.second) group.queue.pop(now);
}

void Live::step(Machine& m, Cycle now, int lane, bool job, std::vector<Stop>& stops) {
  for (const Shown& one : shown_[1]) m.show(now, Border::kLine, one.lane, one.row);
  shown_[1].clear();
  std::swap(shown_[0], shown_[1]);
  const bool fire = fires(now), pixels_move = halves_ == 0 || (fire && halves_ != 3);
  const bool rows_move = !rows_.valid || pixels_move;
  moved_ = !regions_[3].valid || rows_move;
  for (int g = 0; g < kGroups; ++g) {
    if (job) {
      groups_[static_cast<size_t>(g)].last_issue = now;
    } else {
      issue(now, lane, g, stops);
    }
  }
  if (fire) {
    const int half = halves_ & 1 ? 0 : 1;
    for (int g = 0; g < kGroups; ++g) {
      const uint8_t live = live_of(pixels_.quads, half, g);
      if (live != 0)
        groups_[static_cast<size_t>(g)].queue.push(now, {pixels_.region, static_cast<uint8_t>(half), live});
    }
    halves_ &= halves_ - 1;
  }
  if (pixels_move) {
    pixels_ = rows_;
    if (rows_.valid) pixels_.quads &= static_cast<uint16_t>(~stopped_[rows_.region]);
    halves_ = rows_.valid ? ((pixels_.quads & 0xff) != 0 ? 1u : 0u) | (pixels_.quads >> 8 != 0 ? 2u : 0u) : 0;
  }
  if (rows_move) rows_ = regions_[3];
  if (moved_) {
    for (size_t i = 3; i > 0; --i) regions_[i] = regions_[i - 1];
    regions_[0] = {};
  }
}

void Live::pick(int region, uint16_t quads) { regions_[0] = {true, static_cast<uint8_t>(region), quads}; }

}  // namespace pipegs::timing
