// SPDX-License-Identifier: Apache-2.0
// pass: copies the fields that ride through a stage of the projection unchanged. (No RTL module: there each stage
// copies its record.)
#pragma once

namespace pipegs {

template <class In, class Out>
void pass_scales(const In& in, Out& out) {
  out.scale_0 = in.scale_0;
  out.scale_1 = in.scale_1;
  out.scale_2 = in.scale_2;
}

template <class In, class Out>
void pass_quaternion(const In& in, Out& out) {
  out.qw = in.qw;
  out.qx = in.qx;
  out.qy = in.qy;
  out.qz = in.qz;
}

}  // namespace pipegs
