// SPDX-License-Identifier: Apache-2.0
// drain.cpp: see drain.hpp.
#include "sim/timing/ru/drain.hpp"

namespace pipegs::timing {

void Drain::choose(const Config& config, size_t part, uint64_t wanted) {
  chosen_ = -1;
  if ((held_.mask[part] & wanted) != 0) {
    chosen_ = region_number(config, part, std::countr_zero(held_.mask[part] & wanted));
    return;
  }
  for (size_t i = 0; i < held_.mask.size() && chosen_ < 0; ++i) {
    if (held_.mask[i] != 0) chosen_ = region_number(config, i, std::countr_zero(held_.mask[i]));
  }
}

bool Drain::step(const Config& config, Cycle now, size_t part, uint64_t wanted) {
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
  if (chosen_ < 0 || last) choose(config, part, wanted);
  return job;
}

}  // namespace pipegs::timing
