// SPDX-License-Identifier: Apache-2.0
// narrow_table: many records of one kind in half the memory: each field in 32 bits instead of 64.
//
// Idea    A record is a row of (u)int64_t (records.hpp). A scene has millions of Gaussians, and none of their fields
//         has more than 31 bits and a sign; so a row is kept as int32_t and widened when it is read.
// Rule    A value that does not fit throws std::logic_error: nothing ever wraps silently.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace pipegs {

template <class Record>
class NarrowTable {
 public:
  void resize(std::size_t rows) { rows_.resize(rows); }  // new ones are all zero
  std::size_t size() const { return rows_.size(); }

  Record operator[](std::size_t i) const {
    Wide wide;
    for (std::size_t f = 0; f < kFields; ++f) wide[f] = rows_[i][f];
    return std::bit_cast<Record>(wide);
  }
  void set(std::size_t i, const Record& record) {
    const Wide wide = std::bit_cast<Wide>(record);
    bool fits = true;
    for (std::size_t f = 0; f < kFields; ++f) {
      fits = fits && std::in_range<std::int32_t>(wide[f]);
      rows_[i][f] = static_cast<std::int32_t>(wide[f]);
    }
    if (!fits) throw std::logic_error("narrow_table: a field does not fit 32 bits");
  }

 private:
  static constexpr std::size_t kFields = sizeof(Record) / sizeof(std::int64_t);
  using Wide = std::array<std::int64_t, kFields>;

  std::vector<std::array<std::int32_t, kFields>> rows_;
};

}  // namespace pipegs
