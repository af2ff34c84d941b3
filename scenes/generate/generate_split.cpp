// SPDX-License-Identifier: Apache-2.0
// generate_split: see generate_split.hpp.
#include "scenes/generate/generate_split.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <stdexcept>

#include "scenes/generate/generate_random.hpp"

namespace pipegs {
namespace {

// One of `parts` parts of Gaussian i.
Gaussian part_of(const Scene& scene, std::size_t i, std::size_t parts, generate::Random random) {
  Gaussian part = scene.gaussians[i];
  ActivatedGaussian parent;
  if (parts == 1 || activate(scene, i, parent) != Cull::kNone) return part;
  const glm::dquat rotation(parent.rotation[0], parent.rotation[1], parent.rotation[2], parent.rotation[3]);
  part.mean = glm::vec3(parent.mean + rotation * (parent.scale * random.normals()));
  part.log_scale -= static_cast<float>(0.5 * std::log(static_cast<double>(parts)));
  return part;
}

}  // namespace

Scene split_scene(const Scene& scene, std::size_t count, int sh_degree, std::uint64_t seed) {
  check_consistent(scene);
  const std::size_t parents = scene.gaussians.size();
  if (parents == 0 || count < parents) {
    throw std::invalid_argument("split_scene: found a count of " + std::to_string(count) + ", expected at least one " +
                                "for each of " + std::to_string(parents) + " Gaussians, and a Gaussian");
  }
  Scene out;
  out.name = scene.name;
  out.sh_degree = std::min(scene.sh_degree, sh_degree);
  out.antialiased = scene.antialiased;
  out.gaussians.reserve(count);
  const auto rest = static_cast<std::size_t>(3 * sh_rest_count(out.sh_degree));
  out.sh_rest.reserve(count * rest);
  for (std::size_t c = 0; c < count; ++c) {
    const std::size_t i = c % parents, parts = (count - i + parents - 1) / parents;
    out.gaussians.push_back(part_of(scene, i, parts, generate::Random(generate::mixed(seed) + c)));
    if (rest > 0) out.sh_rest.insert(out.sh_rest.end(), sh_rest_of(scene, i), sh_rest_of(scene, i) + rest);
  }
  return out;
}

}  // namespace pipegs
