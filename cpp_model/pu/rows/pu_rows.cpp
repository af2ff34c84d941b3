// SPDX-License-Identifier: Apache-2.0
// pu_rows.cpp: see pu_rows.hpp.
#include "cpp_model/pu/rows/pu_rows.hpp"

namespace pipegs {

void pu_region_line(const PuRows& rows, const RowJob& job, int bit, uint16_t codes[64]) {
  const PuAlpha& alpha = rows.alpha;
  const Region start = pu_region(rows.config, job, bit);
  // First the recurrences in 64 bits, cut to the 28 bits that matter; then the exponentials, which vectorise in 32.
  int32_t power[64];
  for (int dy = 0; dy < 8; ++dy) {
    Row row = pu_row_init(start, dy);
    for (int dx = 0; dx < 8; ++dx) {
      power[8 * dy + dx] = static_cast<int32_t>(std::clamp<int64_t>(row.power, alpha.cut - 1, 0));
      row = pu_row_unit(row, start.curve_x);
    }
  }
  for (int i = 0; i < 64; ++i) codes[i] = static_cast<uint16_t>(alpha.clamped(power[i]));
}

Alphas pu_rows(const Config& config, const RowJob& job, int bit) {
  const Region start = pu_region(config, job, bit);
  Alphas alphas;
  alphas.kind = start.kind;
  alphas.address = start.address;
  alphas.ext = start.ext;
  alphas.index = start.index;
  alphas.region = start.region;
  return alphas;
}

void pack_line(const Config& config, const uint16_t codes[64], uint32_t* words) {
  for (int i = 0; i < 64; ++i) put_bits(words, i * config.alpha_w, config.alpha_w, codes[i]);
}

}  // namespace pipegs
