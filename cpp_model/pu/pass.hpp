// pass: copies the fields that ride through the projection unchanged. (No RTL module: there each stage copies its
// record.)
#pragma once

namespace pipegs {

template <class In, class Out>
void pass_splat(const In& in, Out& out) {
  out.opacity = in.opacity;
  out.base_r = in.base_r;
  out.base_g = in.base_g;
  out.base_b = in.base_b;
  out.index = in.index;
  out.slot = in.slot;
}

template <class In, class Out>
void pass_projection(const In& in, Out& out) {
  out.mean_x = in.mean_x;
  out.mean_y = in.mean_y;
  out.depth = in.depth;
  out.dir_x = in.dir_x;
  out.dir_y = in.dir_y;
  out.dir_z = in.dir_z;
}

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
