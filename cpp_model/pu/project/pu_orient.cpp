// SPDX-License-Identifier: Apache-2.0
// pu_orient: see pu_orient.hpp.
#include "cpp_model/pu/project/pu_orient.hpp"

#include "cpp_model/fixed.hpp"
#include "cpp_model/pu/pass.hpp"

namespace pipegs {

Oriented pu_orient(const Config& c, const Frame& frame, const Projected& in) {
  Oriented out;
  out.kind = in.kind;
  if (in.kind != kData) return out;

  const int quat_f = c.quat_w - 1, f = c.rotation_w() - 2;  // fractions of q and of q', R'
  const int64_t cw = frame.camera.quaternion.w, cx = frame.camera.quaternion.x, cy = frame.camera.quaternion.y,
                cz = frame.camera.quaternion.z;
  const auto narrow = [&](int64_t sum) { return saturate(shift_round(sum, quat_f), c.rotation_w()); };
  const int64_t w = narrow(cw * in.qw - cx * in.qx - cy * in.qy - cz * in.qz);
  const int64_t x = narrow(cw * in.qx + cx * in.qw + cy * in.qz - cz * in.qy);
  const int64_t y = narrow(cw * in.qy - cx * in.qz + cy * in.qw + cz * in.qx);
  const int64_t z = narrow(cw * in.qz + cx * in.qy - cy * in.qx + cz * in.qw);

  const int64_t one = int64_t{1} << (2 * f);
  const auto entry = [&](int64_t sum) { return saturate(shift_round(sum, f), c.rotation_w()); };
  out.r00 = entry(one - 2 * (y * y + z * z));
  out.r11 = entry(one - 2 * (x * x + z * z));
  out.r22 = entry(one - 2 * (x * x + y * y));
  out.r01 = entry(2 * (x * y - w * z));
  out.r10 = entry(2 * (x * y + w * z));
  out.r02 = entry(2 * (x * z + w * y));
  out.r20 = entry(2 * (x * z - w * y));
  out.r12 = entry(2 * (y * z - w * x));
  out.r21 = entry(2 * (y * z + w * x));

  out.tan_x = in.tan_x;
  out.tan_y = in.tan_y;
  out.inv_z_m = in.inv_z_m;
  out.inv_z_e = in.inv_z_e;
  pass_scales(in, out);
  return out;
}

}  // namespace pipegs
