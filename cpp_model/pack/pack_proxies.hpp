// SPDX-License-Identifier: Apache-2.0
// pack_proxies: the Gaussians that stand for those of a group, and when they do.
//
// Paper   None: level of detail.
// Idea    Of each chunk at most ChunkProxies (pack_merge), in the order of the chunks, for pixels as large as the
//         middle one of the group's Gaussians. Their error is the smallest pixel (pack_error) at which each Gaussian
//         that is saved costs no more than kLoss.
// Rule    A group of one Gaussian has no proxies that save anything: its error is the largest.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cpp_model/config.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

struct Proxies {
  Scene scene;                     // of all groups, one behind the other
  std::vector<uint32_t> heaviest;  // of each the index in the scene of the Gaussian that covers most

  void resize(const Scene& of, size_t count);  // as many, of the degree of that scene
};

// How many a chunk of so many Gaussians has.
size_t chunk_proxies(size_t gaussians);

// Writes those of a group from `first` on; `chunks`: the scene's indices, chunk by chunk. The field `error` of its
// node, of world units.
uint64_t make_proxies(const Config& config, const Scene& scene, std::span<const std::vector<uint32_t>> chunks,
                      int scene_exponent, size_t first, Proxies& proxies);

}  // namespace pipegs
