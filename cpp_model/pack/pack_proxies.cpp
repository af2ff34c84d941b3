// SPDX-License-Identifier: Apache-2.0
// pack_proxies: see pack_proxies.hpp.
#include "cpp_model/pack/pack_proxies.hpp"

#include <algorithm>
#include <cmath>

#include "cpp_model/dopu/nearest/dopu_lod.hpp"
#include "cpp_model/pack/pack_error.hpp"
#include "cpp_model/pack/pack_merge.hpp"

namespace pipegs {
namespace {

constexpr double kLoss = 0.02;  // pixels, squared and of full contrast, for each Gaussian saved; docs/units/dopu.md

struct Drawn {
  std::vector<ActivatedGaussian> gaussians;
  std::vector<glm::vec3> dc;

  void add(const Scene& scene, size_t index) {
    activate(scene, index, gaussians.emplace_back());
    dc.push_back(scene.gaussians[index].sh_dc);
  }
};

// A size in world units as the field: its octave, then ErrorBits of mantissa, rounded up.
uint64_t encode_error(const Config& config, double world) {
  if (!(world > 1)) return 0;
  int octave;
  const double mantissa = std::frexp(world, &octave) * 2 - 1,  // 0 to 1
      step = std::ldexp(octave - 1 + mantissa, Config::error_bits());
  return static_cast<uint64_t>(std::min(std::ceil(step), static_cast<double>(dopu_lod_never(config))));
}

}  // namespace

void Proxies::resize(const Scene& of, size_t count) {
  scene.sh_degree = of.sh_degree;
  scene.antialiased = of.antialiased;
  scene.gaussians.resize(count);
  scene.sh_rest.resize(of.sh_degree == 0 ? 0 : count * 3 * static_cast<size_t>(sh_rest_count(of.sh_degree)));
  heaviest.resize(count);
}

size_t chunk_proxies(size_t gaussians) { return std::min(gaussians, static_cast<size_t>(Config::chunk_proxies())); }

uint64_t make_proxies(const Config& config, const Scene& scene, std::span<const std::vector<uint32_t>> chunks,
                      int scene_exponent, size_t first, Proxies& proxies) {
  Drawn whole;
  std::vector<double> sizes;
  for (const std::vector<uint32_t>& chunk : chunks) {
    for (const uint32_t index : chunk) {
      whole.add(scene, index);
      const glm::dvec3& scale = whole.gaussians.back().scale;
      sizes.push_back(std::max({scale.x, scale.y, scale.z}));
    }
  }
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  const size_t rest = scene.sh_degree == 0 ? 0 : 3 * static_cast<size_t>(sh_rest_count(scene.sh_degree));
  size_t next = first;
  for (const std::vector<uint32_t>& chunk : chunks) {
    for (const Merged& merged : merge_parts(scene, chunk, static_cast<int>(chunk_proxies(chunk.size())), *middle)) {
      proxies.scene.gaussians[next] = merged.gaussian;
      std::copy(merged.sh_rest.begin(), merged.sh_rest.end(),
                proxies.scene.sh_rest.begin() + static_cast<std::ptrdiff_t>(next * rest));
      proxies.heaviest[next++] = merged.heaviest;
    }
  }
  const size_t saved = whole.gaussians.size() - (next - first);
  if (saved == 0) return dopu_lod_never(config);
  Drawn few;
  for (size_t i = first; i < next; ++i) few.add(proxies.scene, i);
  const double pixel =
      alike_pixel(whole.gaussians, whole.dc, few.gaussians, few.dc, kLoss * static_cast<double>(saved));
  return pixel == kNeverAlike ? dopu_lod_never(config) : encode_error(config, std::ldexp(pixel, -scene_exponent));
}

}  // namespace pipegs
