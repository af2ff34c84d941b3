// SPDX-License-Identifier: Apache-2.0
// dopu_lod: whether a group's proxies go in place of its Gaussians, and where they lie.
//
// Paper   None: level of detail.        RTL  rtl/dopu/nearest/dopu_lod.sv
// Idea    The packer stores with each group the side of the pixels from which on its proxies look like its Gaussians
//         (pack_error). At depth z a pixel is z / focal wide, and the frame takes proxies up to lod_pixels of them:
//           error <= lod_pixels z / focal,   in steps of depth:   step(error) + lod <= step of the bucket's edge
//         lod = log2(focal / lod_pixels) in those steps, and no z in the group is nearer than the edge. The chunks of
//         proxies lie behind the group's own: it opens the ones or the others, so never both and never neither.
// Rule    A function of node and frame: all windows, and all walks of a window, take the same.
#pragma once

#include <algorithm>
#include <cmath>

#include "cpp_model/dopu/nearest/dopu_depth.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

// Frame::lod of a focal length and a size, pixels; of no size 0.
inline uint64_t dopu_lod_of(const Config& config, double focal, double pixels) {
  if (!(pixels > 0)) return 0;
  const double steps = std::round(std::ldexp(std::log2(focal / pixels), config.bucket_bits));
  return static_cast<uint64_t>(std::clamp(steps, 1.0, std::ldexp(1.0, config.lod_w()) - 1));
}

// The size of which a level is, and 0 of none.
inline double dopu_lod_pixels(const Config& config, double focal, uint64_t lod) {
  return lod == 0 ? 0 : focal / std::exp2(std::ldexp(static_cast<double>(lod), -config.bucket_bits));
}

// Chunks of proxies behind a group with so many chunks of its own: each of these has ChunkProxies of them at most.
inline uint64_t dopu_lod_chunks(const Config& config, uint64_t chunks) {
  const int shift = clog2(config.chunk) - clog2(Config::chunk_proxies());
  return (chunks + (uint64_t{1} << shift) - 1) >> shift;
}

// A group's error if no proxies are to stand for it.
inline uint64_t dopu_lod_never(const Config& config) { return (uint64_t{1} << config.error_w()) - 1; }

inline bool dopu_lod_coarse(const Config& config, const Frame& frame, const Node& group, int bucket) {
  if (frame.lod == 0 || group.error == dopu_lod_never(config)) return false;
  const auto step = static_cast<int>(group.error << (config.bucket_bits - Config::error_bits()));
  return step + static_cast<int>(frame.lod) <= dopu_depth_edge(config, frame, bucket);
}

// The group with the children that are opened.
inline Node dopu_lod(const Config& config, const Frame& frame, Node group, int bucket) {
  if (!config.lod || !dopu_lod_coarse(config, frame, group, bucket)) return group;
  group.first += group.count;
  group.count = dopu_lod_chunks(config, group.count);
  return group;
}

}  // namespace pipegs
