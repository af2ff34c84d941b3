#include "cpp_model/pu/pu_conic.hpp"

#include <algorithm>

#include "cpp_model/fixed.hpp"
#include "cpp_model/lib/recip.hpp"
#include "cpp_model/pu/pu_intersect.hpp"
#include "cpp_model/pu/pu_root.hpp"

namespace pipegs {
namespace {

constexpr int64_t kK32 = 3098164009;  // log2(e)/2 * 2^32, rounded
// 2 ln(2) (1 + 1/64) * 2^8, rounded up. The 1/64 covers what the box's variance may differ from the variance that the
// rounded narrow and wide imply. The rounded slope shifts the far end of a needle by less than its length * 2^-(MantissaW - 1),
// for which each extent grows by the other's 2^-(MantissaW - 4).
constexpr int64_t kMargin = 361;

struct Float {
  uint64_t m;
  int64_t e;
};

// Product of two normalised mantissas, normalised, rounded to nearest.
Float multiply(int bits, Float x, Float y) {
  const uint64_t product = x.m * y.m;  // 2 * MantissaW - 1 or 2 * MantissaW bits
  const int shift = (product >> (2 * bits - 1)) != 0 ? bits : bits - 1;
  const uint64_t rounded = shift_round(product, shift);
  const bool carry = (rounded >> bits) != 0;
  return {carry ? rounded >> 1 : rounded, x.e + y.e + shift + carry};
}

// floor((root + 1) * 2^x) of sqrt(variance * t * 2^-OpacityF) in 1/16 pixel, at most 1 too small.
uint64_t root_pixels(const Config& config, uint64_t m, int64_t e, uint64_t t) {
  // t < 2^OpacityW; shifted to the left end: the product has MantissaW + OpacityW bits or one less.
  const int lead = config.opacity_w() - bit_length(t);
  const int cut = config.mantissa_w + config.opacity_w() - kRadicandW;
  const uint64_t product = m * (t << lead);
  const int64_t exponent = e - config.opacity_f - lead + 8 + cut;
  const int odd = static_cast<int>(exponent & 1);
  const uint64_t up = pu_root(product >> (cut + odd)) + 1;
  const int64_t half = (exponent + odd) >> 1;
  const uint64_t top = (uint64_t{1} << config.extent_w()) - 1;
  return half >= config.extent_w() ? top : half >= 0 ? std::min(top, up << half) : shift_floor(up, static_cast<int>(-half));
}

}  // namespace

Conic pu_conic(const Config& config, const Frame&, const Covariance& in) {
  Conic out;
  out.kind = in.kind;
  if (in.kind != kData) return out;
  const int bits = config.mantissa_w, slope_f = config.slope_w() - 2;

  const bool swap = in.a_e > in.c_e || (in.a_e == in.c_e && in.a_m > in.c_m);
  const Float larger = swap ? Float{in.a_m, in.a_e} : Float{in.c_m, in.c_e};
  const Float k{static_cast<uint64_t>(shift_round(kK32, 32 - bits)), -bits};
  const Float inverse{recip(bits, larger.m), 1 - 2 * bits - larger.e};
  const Float inverse_det{recip(bits, in.det_m), 1 - 2 * bits - in.det_e};
  const Float wide = multiply(bits, inverse, k);
  const Float narrow = multiply(bits, larger, multiply(bits, inverse_det, k));

  // b / larger, at most 1 but for rounding.
  const int64_t product = in.b_m * static_cast<int64_t>(inverse.m);
  const int64_t shift = -(in.b_e + inverse.e + slope_f);
  const int64_t one = int64_t{1} << slope_f;
  const int64_t slope = shift <= 0 ? (product < 0 ? -one : product > 0 ? one : 0)
                                   : std::clamp(shift_round(product, static_cast<int>(std::min<int64_t>(shift, 127))), -one, one);

  const int64_t budget = PuCut(config).budget - static_cast<int64_t>(in.opacity);
  const uint64_t t = static_cast<uint64_t>((std::max<int64_t>(budget, 0) * kMargin) >> 8) + 1;

  out.mean_x = in.mean_x;
  out.mean_y = in.mean_y;
  const uint64_t x = root_pixels(config, in.a_m, in.a_e, t), y = root_pixels(config, in.c_m, in.c_e, t);
  const uint64_t top = (uint64_t{1} << config.extent_w()) - 1;
  out.extent_x = std::min(top, x + (y >> (bits - 4)) + 2);
  out.extent_y = std::min(top, y + (x >> (bits - 4)) + 2);
  out.swap = swap;
  out.slope_m = slope;
  out.narrow_m = narrow.m;
  out.narrow_e = narrow.e;
  out.wide_m = wide.m;
  out.wide_e = wide.e;
  out.opacity = in.opacity;
  out.depth = in.depth;
  out.dir_x = in.dir_x;
  out.dir_y = in.dir_y;
  out.dir_z = in.dir_z;
  out.base_r = in.base_r;
  out.base_g = in.base_g;
  out.base_b = in.base_b;
  out.index = in.index;
  out.slot = in.slot;
  return out;
}

}  // namespace pipegs
