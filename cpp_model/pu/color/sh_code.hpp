// SPDX-License-Identifier: Apache-2.0
// sh_code: the SH coefficients of a Gaussian as codes (record = 48), and the mantissas that they stand for.
//
// Layout  exponent (ShEW bits) | above degree 1: drop of band 1, 2, 3 (ShDropW each) | coefficients in the order of
//         f_rest, 6 bits each of band 1, 5 of the others: 248 bits at degree 3, half a line; 59 at degree 1, an eighth
// Idea    A band's code is the upper part of a mantissa that lies `drop` bits below the exponent of all:
//           mantissa = code * 2^(ShMW - bits - drop)
//         so the sum is that of whole mantissas, and a band of small coefficients keeps its precision.
// RTL     rtl/pu/color/pu_color_codes.sv
#pragma once

#include <array>
#include <cstdint>

#include "cpp_model/config.hpp"
#include "cpp_model/memory_line.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

constexpr int sh_first(int band) { return 3 * sh_rest_count(band - 1); }  // coefficient of a band
constexpr int sh_code_w(int band) { return band == 1 ? Config::sh_band1_w() : Config::sh_band2_w(); }
inline int sh_most_drop(const Config& config, int band) { return config.sh_m_w - sh_code_w(band); }
inline int sh_drop_at(const Config& config, int band) { return config.sh_e_w + Config::sh_drop_w() * (band - 1); }
inline int sh_code_at(const Config& config, int degree, int coefficient) {
  const int first = degree == 1 ? config.sh_e_w : sh_drop_at(config, kMaxShDegree + 1), band1 = sh_first(2);
  if (coefficient < band1) return first + sh_code_w(1) * coefficient;
  return first + sh_code_w(1) * band1 + sh_code_w(2) * (coefficient - band1);
}

struct ShMantissas {
  int exponent = 0;
  std::array<int64_t, 3 * sh_rest_count(kMaxShDegree)> of{};  // signed, ShMW bits
};

// Of the Gaussian whose coefficients, codes or mantissas, begin at bit `at` of a line.
inline ShMantissas sh_mantissas(const Config& config, int degree, const uint32_t* line, int at) {
  ShMantissas found;
  const auto field = [&](int place, int width) { return get_bits(line, at + place, width); };
  const auto extended = [&](int place, int width) {
    return static_cast<int64_t>(field(place, width) << (64 - width)) >> (64 - width);
  };
  found.exponent = static_cast<int>(field(0, config.sh_e_w));
  if (!config.coded()) {
    for (int i = 0; i < sh_first(degree + 1); ++i)
      found.of[static_cast<size_t>(i)] = extended(config.sh_e_w + i * config.sh_m_w, config.sh_m_w);
    return found;
  }
  for (int band = 1; band <= degree; ++band) {
    const int width = sh_code_w(band), most = sh_most_drop(config, band);
    const int drop = degree == 1 ? 0 : static_cast<int>(field(sh_drop_at(config, band), Config::sh_drop_w()));
    const int up = drop > most ? 0 : most - drop;  // no packer makes a larger drop
    for (int i = sh_first(band); i < sh_first(band + 1); ++i) {
      found.of[static_cast<size_t>(i)] = extended(sh_code_at(config, degree, i), width) * (int64_t{1} << up);
    }
  }
  return found;
}

}  // namespace pipegs
