// SPDX-License-Identifier: Apache-2.0
// dopu_origin: the centre of a chunk in view space, with the block exponent in which the PU adds the offsets.
//
// Paper   Sec. 4.2 (projection), world to view.        RTL  rtl/dopu/dopu_origin.sv
// Idea    origin = W (centre - camera) exactly, in 2^-24. Every mean of the chunk is origin + W offset with |W offset|
//         < 2^(PosW + offset_exp), so with L = max(bit length of the largest |origin_i|, PosW + offset_exp) the sum is
//         below 2^(L + 1), and view_exp = max(0, L + 2 - ViewW) makes it fit ViewW signed bits.
// Round   To nearest, once: half a unit of 2^view_exp.
#pragma once

#include <algorithm>

#include "cpp_model/fixed.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

inline Chunk dopu_origin(const Config& config, const Frame& frame, const Node& node, int window_x, int window_y) {
  const int64_t dx = node.center_x - frame.camera.position.x, dy = node.center_y - frame.camera.position.y,
                dz = node.center_z - frame.camera.position.z;
  const Int128 origin[3] = {Int128{frame.camera.rotation.w00} * dx + Int128{frame.camera.rotation.w01} * dy +
                                Int128{frame.camera.rotation.w02} * dz,
                            Int128{frame.camera.rotation.w10} * dx + Int128{frame.camera.rotation.w11} * dy +
                                Int128{frame.camera.rotation.w12} * dz,
                            Int128{frame.camera.rotation.w20} * dx + Int128{frame.camera.rotation.w21} * dy +
                                Int128{frame.camera.rotation.w22} * dz};
  Uint128 magnitudes = 0;
  for (const Int128& v : origin) magnitudes |= static_cast<Uint128>(v < 0 ? ~v : v);
  const int length =
      std::max(bit_length(magnitudes) - config.rot_f(), config.pos_w + static_cast<int>(node.offset_exp));
  const int view_exp = std::max(0, length + 2 - config.view_w), shift = view_exp + config.rot_f();
  Chunk chunk;
  chunk.kind = kData;
  chunk.window_x = static_cast<uint64_t>(window_x);
  chunk.window_y = static_cast<uint64_t>(window_y);
  chunk.origin_x = static_cast<int64_t>(shift_round(origin[0], shift));
  chunk.origin_y = static_cast<int64_t>(shift_round(origin[1], shift));
  chunk.origin_z = static_cast<int64_t>(shift_round(origin[2], shift));
  chunk.view_exp = static_cast<uint64_t>(view_exp);
  chunk.offset_exp = node.offset_exp;
  if (config.coded()) chunk.scale_exp = node.scale_max >> config.scale_m_w;
  chunk.slot = node.first;
  chunk.count = node.count;
  return chunk;
}

}  // namespace pipegs
