// SPDX-License-Identifier: Apache-2.0
// pu_box.cpp: see pu_axes.hpp, pu_box.hpp.
#include "cpp_model/pu/box/pu_box.hpp"

#include <algorithm>

#include "cpp_model/fixed.hpp"
#include "cpp_model/lib/math/recip.hpp"
#include "cpp_model/lib/math/rsqrt.hpp"
#include "cpp_model/pu/box/pu_axes.hpp"

namespace pipegs {
namespace {

constexpr int kGuard = 8;     // bits below the last place of the larger variance
constexpr int kLead = 20;     // leading bits of d and 2b that are squared
constexpr int kRound = 18;    // d and 2b have no more bits: the covariance counts as round
constexpr int kMostSum = 26;  // bits of A + C + r

}  // namespace

Axes pu_axes(const Config& config, const Frame&, const Covariance& in) {
  Axes out;
  out.kind = in.kind;
  if (in.kind != kData) return out;
  const int bits = config.mantissa_w;

  const bool swap = in.a_e > in.c_e || (in.a_e == in.c_e && in.a_m > in.c_m);
  const uint64_t larger_m = swap ? in.a_m : in.c_m, smaller_m = swap ? in.c_m : in.a_m;
  const int64_t larger_e = swap ? in.a_e : in.c_e, smaller_e = swap ? in.c_e : in.a_e;

  // All in the unit 2^(larger_e - kGuard). b comes in 26 bits and a sign with at most the larger variance's exponent.
  const uint64_t larger = larger_m << kGuard;
  const uint64_t smaller =
      shift_floor(smaller_m << kGuard, static_cast<int>(std::min<int64_t>(larger_e - smaller_e, 63)));
  const int64_t b_shift = std::clamp<int64_t>(larger_e - in.b_e + bits - (config.slope_w() - 1), 0, 63);
  const uint64_t b_size = static_cast<uint64_t>(in.b_m < 0 ? -in.b_m : in.b_m);
  const uint64_t d = larger - smaller,
                 b2 = shift_floor(b_size << (bits + kGuard + 1 - (config.slope_w() - 1)), static_cast<int>(b_shift));

  const int length = bit_length(d | b2);
  const bool round = length <= kRound;
  const int by = round ? 0 : length - (kLead - 1);
  const uint64_t x = round ? 0 : (d << 1) >> by, y = round ? 0 : (b2 << 1) >> by;  // unit 2^(by - 1)

  // r and d + r with two fraction bits.
  const uint64_t z = x * x + y * y;
  const int high = static_cast<int>(z >> (2 * kLead)) != 0;
  const auto u = static_cast<int64_t>(round ? uint64_t{1} << kRsqrtInF : z >> (kLead + 2 * high));
  const auto inverse_r = static_cast<uint64_t>(rsqrt(u));
  const uint64_t r = round ? 0 : (static_cast<uint64_t>(u) * inverse_r) >> (15 - high);
  const uint64_t g = round ? uint64_t{1} << (kAxisM - 1) : (x << 2) + r;
  const int g_up = kAxisM - bit_length(g);
  const uint64_t inverse_g = recip(kAxisM, g << g_up);

  const auto one = [](int fraction) { return uint64_t{1} << fraction; };
  const uint64_t slope = std::min(one(kTiltF), shift_round(y * inverse_g, 29 - g_up));
  out.swap = swap;
  out.tilt = static_cast<int64_t>(round ? 0 : slope) * ((in.b_m < 0) == swap ? -1 : 1);
  out.stretch = round ? one(kShareF - 1) : std::min(one(kShareF), shift_round(r * inverse_g, 29 - g_up));
  out.shrink = round ? one(kShareF) : std::min(one(kShareF), (g * inverse_r) >> (22 + high));

  // Twice the larger eigenvalue, unit 2^(larger_e - kGuard + bits - 15).
  const uint64_t sum = ((larger + smaller) >> (bits - 15)) + shift_floor(r << 3, bits - 9 - by);
  const int sum_up = kMostSum - bit_length(sum);
  out.long_m = (sum << sum_up) >> (kMostSum - kAxisM);
  out.long_e = larger_e + bits - 22 - sum_up;
  out.inverse_m = recip(kAxisM, out.long_m);

  out.mean_x = in.mean_x, out.mean_y = in.mean_y;
  out.a_m = in.a_m, out.a_e = in.a_e, out.b_m = in.b_m, out.b_e = in.b_e, out.c_m = in.c_m, out.c_e = in.c_e;
  out.det_m = in.det_m, out.det_e = in.det_e, out.sharp_m = in.sharp_m, out.sharp_e = in.sharp_e;
  out.opacity = in.opacity;
  return out;
}

namespace {

constexpr int kTop = kAxisM + kShareF;  // most bits of a product of mantissa and share, which has 2^(kTop-2) at least

// 3 sqrt(product * 2^e) in units of 2^-kSideF pixel, rounded up; saturates at `width` bits.
uint64_t three_roots(uint64_t product, int64_t e, int width) {
  const bool odd = (e & 1) != 0, large = (product >> (kTop - 1)) != 0;
  const int shift = kTop - 20 + (odd ? (large ? 1 : -1) : 0);
  const auto u = static_cast<int64_t>(product >> shift);
  const uint64_t root = (static_cast<uint64_t>(u) * static_cast<uint64_t>(rsqrt(u))) >> 17;  // u1.19
  const int64_t up = (e + shift + kRsqrtInF) / 2 - 19 + kSideF;
  const uint64_t three = 3 * root + 1, most = (uint64_t{1} << width) - 1;
  if (up >= width) return most;
  return up >= 0 ? std::min(most, three << up) : shift_floor(three, static_cast<int>(std::min<int64_t>(-up, 63))) + 1;
}

}  // namespace

Covariance pu_box(const Config& config, const Frame&, const Axes& in) {
  Covariance out;
  out.kind = in.kind;
  if (in.kind != kData) return out;
  const int bits = config.mantissa_w, width = config.side_w();

  // The smaller eigenvalue, det / larger.
  const uint64_t det = bits > kAxisM ? in.det_m >> (bits - kAxisM) : in.det_m << (kAxisM - bits);
  const uint64_t ratio = det * in.inverse_m;
  const int top = static_cast<int>(ratio >> (2 * kAxisM - 1));
  const uint64_t short_m = ratio >> (kAxisM - 1 + top);
  const int64_t short_e = in.det_e + bits - kAxisM - (2 * kAxisM - 1) - in.long_e + kAxisM - 1 + top;

  // times 2 stretch = 1 + tilt^2
  const uint64_t length = three_roots(in.long_m * in.stretch, in.long_e + 1 - kShareF, width),
                 breadth = three_roots(short_m * in.stretch, short_e + 1 - kShareF, width);
  const uint64_t growth = (length >> kBoxGrowth) + 1, most = (uint64_t{1} << width) - 1;
  const uint64_t side_long = std::min(most, length + growth), side_short = std::min(most, breadth + growth);

  const uint64_t slope = static_cast<uint64_t>(in.tilt < 0 ? -in.tilt : in.tilt);
  const auto extent = [&](uint64_t whole, uint64_t part) {
    const uint64_t sum = whole + ((part * slope) >> kTiltF) + 1;
    return std::min((uint64_t{1} << config.extent_w()) - 1, ((sum * in.shrink) >> (kShareF + kSideF - 4)) + 1);
  };
  const uint64_t along = extent(side_long, side_short), across = extent(side_short, side_long);

  out.mean_x = in.mean_x, out.mean_y = in.mean_y;
  out.a_m = in.a_m, out.a_e = in.a_e, out.b_m = in.b_m, out.b_e = in.b_e, out.c_m = in.c_m, out.c_e = in.c_e;
  out.det_m = in.det_m, out.det_e = in.det_e, out.sharp_m = in.sharp_m, out.sharp_e = in.sharp_e;
  out.opacity = in.opacity;
  out.tilt = in.tilt;
  out.box_x = in.swap ? along : across;
  out.box_y = in.swap ? across : along;
  out.side_u = in.swap ? side_long : side_short;
  out.side_v = in.swap ? side_short : side_long;
  return out;
}

}  // namespace pipegs
