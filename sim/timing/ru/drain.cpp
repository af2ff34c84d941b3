// SPDX-License-Identifier: Apache-2.0
// drain.cpp: see drain.hpp.
#include "sim/timing/ru/drain.hpp"

namespace pipegs::timing {

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
