// SPDX-License-Identifier: Apache-2.0
// dram_place.hpp: where a burst lies: channel, bank, row and column of its byte address.
//
// Idea    The address in bursts is cut into fields from the bottom. Within a channel:
//           RoBaRaCoCh   row | bank | group | rank | column
//           RoBaCoGrCh   row | bank | rank | column high | group | column low (group_bytes); after that bank and group
//                        are XORed with the bits of the row from the bottom up. A stream keeps a row of every group
//                        open, so bursts of other groups fill the gaps of t_ccd_l; streams of equal steps do not meet
//                        in a bank
//           MOP4CLXOR    row | column high | bank | group | rank | column low (2 bits); after that rank, group, bank
//                        and row are XORed with the bits of the column from the bottom up, so that four bursts in a
//                        row lie in different bank groups and the upper part of a column chooses among rows.
//         The channel's bits lie above `interleave_bytes`. Rows beyond the last wrap around: only timing is kept here.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "sim/memory/dram/dram_timing.hpp"

namespace pipegs {

struct DramPlace {
  uint32_t channel;
  uint32_t bank;  // rank, group and bank as one number, the bank lowest
  uint32_t row;
  uint32_t column;  // of bursts
};

class DramPlaces {
 public:
  explicit DramPlaces(const DramTiming& timing)
      : mop4_(timing.mapping == DramMapping::kMop4ClXor),
        groups_(timing.mapping == DramMapping::kRoBaCoGrCh),
        low_bits_(bits(std::max(timing.group_bytes, timing.burst_bytes()) / timing.burst_bytes())),
        channel_bits_(bits(timing.channels)),
        rank_bits_(bits(timing.ranks)),
        group_bits_(bits(timing.bank_groups)),
        bank_bits_(bits(timing.banks)),
        row_bits_(bits(timing.rows)),
        column_bits_(bits(timing.columns / timing.burst_length)),
        interleave_bits_(timing.interleave_bytes == 0 ? 0 : bits(timing.interleave_bytes / timing.burst_bytes())),
        beside_((1u << std::min(interleave_bits_, mop4_     ? 0
                                                  : groups_ ? low_bits_
                                                            : column_bits_)) -
                1) {}

  // `burst`: byte address divided by the bytes of a burst.
  DramPlace operator()(uint64_t burst) const {
    DramPlace place;
    uint64_t rest = burst >> interleave_bits_;
    place.channel = take(rest, channel_bits_);
    rest = rest << interleave_bits_ | (burst & ((uint64_t{1} << interleave_bits_) - 1));
    const int low = mop4_ ? 2 : groups_ ? low_bits_ : column_bits_;
    place.column = take(rest, low);
    uint32_t rank = 0, group = 0, bank = 0;
    if (groups_) {
      group = take(rest, group_bits_);
      place.column |= take(rest, column_bits_ - low) << low;
      rank = take(rest, rank_bits_), bank = take(rest, bank_bits_);
    } else {
      rank = take(rest, rank_bits_), group = take(rest, group_bits_), bank = take(rest, bank_bits_);
      if (mop4_) place.column |= take(rest, column_bits_ - low) << low;
    }
    place.row = take(rest, row_bits_);
    if (groups_) {
      uint64_t row = place.row;
      bank ^= take(row, bank_bits_);
      group ^= take(row, group_bits_);
    }
    if (mop4_) {
      uint64_t column = place.column;
      rank ^= take(column, rank_bits_);
      group ^= take(column, group_bits_);
      bank ^= take(column, bank_bits_);
      place.row ^= take(column, row_bits_);
    }
    place.bank = ((rank << group_bits_) | group) << bank_bits_ | bank;
    return place;
  }

  // Of the burst behind the one at `place`: often only the column differs.
  DramPlace next(const DramPlace& place, uint64_t burst) const {
    if ((burst & beside_) == 0) return (*this)(burst);
    return {place.channel, place.bank, place.row, place.column + 1};
  }

 private:
  static int bits(int value) { return std::bit_width(static_cast<unsigned>(value)) - 1; }
  static uint32_t take(uint64_t& rest, int count) {
    const auto field = static_cast<uint32_t>(rest & ((uint64_t{1} << count) - 1));
    rest >>= count;
    return field;
  }

  bool mop4_, groups_;
  int low_bits_, channel_bits_, rank_bits_, group_bits_, bank_bits_, row_bits_, column_bits_, interleave_bits_;
  uint64_t beside_;  // bits of a burst of which the column has the lowest ones
};

}  // namespace pipegs
