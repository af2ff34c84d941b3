// SPDX-License-Identifier: Apache-2.0
// dopu_load: whether a window holds so much that its eyes, or its parts, are walked one after the other.
//
// Paper   None: the paper's windows are walked whole.        RTL  rtl/dopu/dopu_load.sv
// Idea    What must wait at once lies at about one depth, since a watermark releases all that is nearer. The walk of a
//         whole window opens no group before all of them have come. Each one that passes counts, with as many Gaussians
//         to a chunk as it has room for, in every bucket of depth from its nearest to its farthest corner. If a bucket
//         holds more than walk_most, which the host sets, or there are more groups than half of the places in which
//         nodes wait, the walk is given up, and the window goes by parts. Where both eyes are wanted each Gaussian
//         gives
//         two records: if a bucket holds more than half of walk_most the window goes eye by eye. Any answer gives the
//         same pixels; a wrong one costs nodes that are read again, or a set that spills.
// Rule    A function of scene, camera and walk_most alone, so the streams are, too.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "cpp_model/dopu/dopu_planes.hpp"
#include "cpp_model/dopu/dopu_test.hpp"
#include "cpp_model/dopu/nearest/dopu_depth.hpp"
#include "cpp_model/dopu/nearest/dopu_lod.hpp"
#include "cpp_model/pack/pack.hpp"

namespace pipegs {

enum class Load { kWhole, kByEye, kByPart };

// Of one window, while its groups come; `pair`: both eyes are wanted.
class DopuLoad {
 public:
  DopuLoad(const Config& config, uint64_t most, bool pair)
      : most_(most / static_cast<uint64_t>(config.chunk)),
        together_(pair ? most_ / 2 : most_),
        most_groups_(static_cast<size_t>(config.nearest_nodes / 2)),
        shift_(config.bucket_w() - config.load_w()),
        change_((size_t{1} << config.load_w()) + 1) {}

  // A group that passes, in the DOPU's buckets.
  void add(int near, int far, uint64_t chunks) {
    ++groups_;
    chunks_ += static_cast<int64_t>(chunks);
    change_[static_cast<size_t>(near >> shift_)] += static_cast<int64_t>(chunks);
    change_[static_cast<size_t>(std::max(near, far) >> shift_) + 1] -= static_cast<int64_t>(chunks);
  }
  void clear() {
    groups_ = chunks_ = 0;
    std::fill(change_.begin(), change_.end(), 0);
  }

  bool many_groups() const { return groups_ > most_groups_; }
  // Then no bucket can hold too much either.
  bool fits() const { return chunks_ <= static_cast<int64_t>(together_); }
  // The nearest bucket that holds too much.
  std::optional<int> overfull() const { return beyond(most_); }
  Load verdict() const {
    if (many_groups() || overfull()) return Load::kByPart;
    return beyond(together_) ? Load::kByEye : Load::kWhole;
  }

 private:
  std::optional<int> beyond(uint64_t most) const {
    int64_t held = 0;
    for (size_t bucket = 0; bucket + 1 < change_.size(); ++bucket) {
      held += change_[bucket];
      if (held > static_cast<int64_t>(most)) return static_cast<int>(bucket);
    }
    return {};
  }
  const uint64_t most_, together_;  // chunks
  const size_t most_groups_;
  const int shift_;
  size_t groups_ = 0;
  int64_t chunks_ = 0;
  std::vector<int64_t> change_;  // of what is held, from the bucket before
};

inline Load dopu_load(const Config& config, const Frame& frame, const PackedScene& scene, int window_x, int window_y) {
  if (frame.walk_most == 0) return Load::kWhole;
  const Planes planes = dopu_planes(config, frame, window_x, window_y);
  DopuLoad load(config, frame.walk_most, wanted_eyes(config, frame).size() > 1);
  for (const Node& cell : scene.cells) {
    if (cell.count == 0 || !dopu_test(config, frame, planes, cell, dopu_depth_edge(config, frame, 0))) continue;
    const int bucket = dopu_depth(config, frame, planes, cell, 0);
    for (uint64_t g = cell.first; g < cell.first + cell.count; ++g) {
      const Node& group = scene.groups[g];
      if (!dopu_test(config, frame, planes, group, dopu_depth_edge(config, frame, bucket))) continue;
      const int near = dopu_depth(config, frame, planes, group, bucket);
      load.add(near, dopu_depth_far(config, frame, planes, group, bucket), dopu_lod(config, frame, group, near).count);
    }
  }
  return load.verdict();
}

}  // namespace pipegs
