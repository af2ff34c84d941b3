// SPDX-License-Identifier: Apache-2.0
// live.cpp: see live.hpp.
#include "sim/timing/ru/live.hpp"

#include "cpp_model/ru/ru_quads.hpp"
#include "sim/timing/machine.hpp"

namespace pipegs::timing {
namespace {

// The quads of a half by group, in its first and in its second row: ru_quad(group, row) for two rows.
unsigned in_first_row(unsigned half) { return half & 15; }
unsigned in_second_row(unsigned half) { return (half >> 2 & 12) | half >> 6; }

}  // namespace

void Live::start_window(const Config& config, const TimingWindow* window) {
  if (window == nullptr) return;
  left_ = window->quad_done_after;
  stopped_ = window->quads_outside;
  all_stopped_ = {};
  for (int region = 0; region < config.regions(); ++region)
    all_stopped_.add(config, region, stopped_[static_cast<size_t>(region)] == 0xffff);
}

void Live::publish(const Config& config, Cycle now) {
  for (; !stops_.empty() && stops_.front().from <= now; stops_.pop(now)) {
    const int region = stops_.front().quad / kQuads;
    uint16_t& stopped = stopped_[static_cast<size_t>(region)];
    stopped |= static_cast<uint16_t>(1u << stops_.front().quad % kQuads);
    all_stopped_.add(config, region, stopped == 0xffff);
  }
}

void Live::step(Machine& m, Cycle now, int lane, bool job) {
  if (m.events != nullptr) {
    for (const Shown& one : shown_[1]) m.show(now, Border::kLine, one.lane, one.row);
    shown_[1].clear();
    std::swap(shown_[0], shown_[1]);
  }
  // The half that is next leaves when all groups with live quads of it have room.
  const int half = halves_ & 1 ? 0 : 1;
  const unsigned quads = pixels_ >> 8 * half & 0xff, wanted = in_first_row(quads) | in_second_row(quads);
  unsigned full = 0;
  for (unsigned g = 0; g < kGroups; ++g) full |= unsigned{groups_[g].count == kHalves} << g;
  const bool fire = halves_ != 0 && (wanted & full) == 0, pixels_move = halves_ == 0 || (fire && halves_ != 3);
  const bool rows_move = rows_ == 0 || pixels_move;
  moved_ = regions_[3] == 0 || rows_move;
  if (job) last_issue_ = now;
  for (unsigned g = 0; g < kGroups; ++g) {
    Group& group = groups_[g];
    const int quad = job || group.count == group.fresh ? -1 : issue(group, g);
    group.fresh = 0;
    group.recent = group.recent << 16 | static_cast<uint16_t>(quad);
    if (quad < 0) continue;
    last_issue_ = now;
    if (--left_[static_cast<size_t>(quad)] == 0) {
      stops_.push(now, {now + kInside, static_cast<uint16_t>(quad)});
      m.wheel.wake(unit(kPublish), now + kInside);
    }
    if (m.events != nullptr)
      shown_[0].push_back(
          {static_cast<uint8_t>(static_cast<unsigned>(lane) * kGroups + g), static_cast<uint16_t>(quad / 4)});
  }
  if (fire) {
    const unsigned first = in_first_row(quads), second = in_second_row(quads);
    for (unsigned rest = wanted; rest != 0; rest &= rest - 1) {
      const auto g = static_cast<unsigned>(std::countr_zero(rest));
      Group& group = groups_[g];
      group.queue[(group.head + group.count++) % kHalves] = {
          static_cast<uint16_t>(region_of(pixels_)), static_cast<uint8_t>(half),
          static_cast<uint8_t>((first >> g & 1) | (second >> g & 1) << 1)};
      group.fresh = 1;
      ++queued_;
    }
    halves_ &= halves_ - 1;
  }
  if (pixels_move) {
    pixels_ = rows_ == 0 ? 0 : rows_ & ~Stage{stopped_[region_of(rows_)]};
    halves_ = unsigned{(pixels_ & 0xff) != 0} | unsigned{(pixels_ & 0xff00) != 0} << 1;
  }
  if (rows_move) rows_ = regions_[3];
  if (moved_) regions_ = {0, regions_[0], regions_[1], regions_[2]};
}

// A quad is not issued again for four cycles.
int Live::issue(Group& group, unsigned number) {
  const Half& half = group.queue[group.head];
  const bool second = group.second || (half.live & 1) == 0;
  const int row = 2 * half.half + (second ? 1 : 0);
  const int quad = kQuads * half.region + ru_quad(static_cast<int>(number), row);
  const auto same = static_cast<uint16_t>(quad);
  if (same == static_cast<uint16_t>(group.recent) || same == static_cast<uint16_t>(group.recent >> 16) ||
      same == static_cast<uint16_t>(group.recent >> 32))
    return -1;
  group.second = !second && (half.live & 2) != 0;
  if (!group.second) {
    group.head = (group.head + 1) % kHalves;
    --group.count;
    --queued_;
  }
  return quad;
}

void Drain::choose(const Config& config, const RegionSet& wanted) {
  const RegionSet first = held_ & wanted, &from = first != RegionSet{} ? first : held_;
  chosen_ = -1;
  for (size_t i = 0; i < from.mask.size() && chosen_ < 0; ++i) {
    if (from.mask[i] != 0) chosen_ = region_number(config, i, std::countr_zero(from.mask[i]));
  }
}

bool Drain::step(const Config& config, Cycle now, const RegionSet& wanted) {
  if (now < from_) return false;
  const bool room = quiet_ || words.count() + std::popcount(flying_) < Config::ru_drained();
  const bool job = chosen_ >= 0 && room, last = job && row_ == 3;
  if ((flying_ & 4) != 0) words.push(now, coming_[2]);
  coming_ = {Word{chosen_, row_, window_}, coming_[0], coming_[1]};
  const bool written = job && !quiet_ && 8 * region_y(config, chosen_) + 2 * row_ < rows_;
  flying_ = (flying_ << 1 & 7) | (written ? 1u : 0u);
  if (last) {
    held_.mask[static_cast<size_t>(region_part(config, chosen_))] &= ~(uint64_t{1} << region_bit(config, chosen_));
  }
  if (job) row_ = (row_ + 1) % 4;
  if (chosen_ < 0 || last) choose(config, wanted);
  return job;
}

}  // namespace pipegs::timing
