// SPDX-License-Identifier: Apache-2.0
// compare: how far two scenes with the same Gaussians in the same order lie apart, field by field.
//
// Idea    Fields in the units in which formats cut them: positions as they are, scales by their logarithm, opacity from
//         0 to 1, rotations in degrees. An ellipsoid is the same after half a turn about an axis of its own, and q and
//         -q are the same rotation, so the smallest angle of the eight counts.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scenes/formats/read_scene.hpp"
#include "scenes/packed/unpack.hpp"
#include "scenes/ply/ply.hpp"
#include "verif/scenes/scratch_folder.hpp"

namespace pipegs {

inline std::filesystem::path own_formats() {
  return std::filesystem::path(PIPEGS_SOURCE_DIR) / "verif" / "formats" / "own";
}

// The files of an archive of sog/ in a folder of their own.
class Unpacked {
 public:
  Unpacked(const std::string& archive, const std::vector<std::string>& metas) {
    const InputFile packed(own_formats() / "sog" / archive);
    for (const std::string& name : metas) {
      const std::string meta = unpack_zip(packed, name).text();
      const std::string inside = name.substr(0, name.rfind('/') + 1);
      std::filesystem::create_directories(folder_ / inside);
      folder_.write(name, meta);
      const auto json = nlohmann::json::parse(meta);
      for (const auto& part : json) {
        if (!part.is_object() || !part.contains("files")) continue;
        for (const std::string file : part["files"])
          folder_.write(inside + file, unpack_zip(packed, inside + file).text());
      }
    }
  }
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

 private:
  ScratchFolder folder_;
};

// scene.sog as a folder, and the streamed scene of two levels.
inline std::filesystem::path own_sog() {
  static const Unpacked folder("scene.sog", {"meta.json"});
  return folder / "";
}
inline std::filesystem::path own_streamed() {
  static const Unpacked folder("streamed.zip", {"lod-meta.json", "0_0/meta.json", "1_0/meta.json"});
  return folder / "";
}

struct Difference {
  double position = 0, scale = 0, alpha = 0, color = 0, rotation = 0, rest = 0;
};

inline double angle_between(const glm::vec4& a, const glm::vec4& b) {
  const glm::dvec4 p = glm::normalize(glm::dvec4(a));
  const glm::dquat q = glm::normalize(glm::dquat(b[0], b[1], b[2], b[3]));
  double nearest = 2;
  for (const glm::dquat& turn :
       {glm::dquat(1, 0, 0, 0), glm::dquat(0, 1, 0, 0), glm::dquat(0, 0, 1, 0), glm::dquat(0, 0, 0, 1)}) {
    const glm::dquat turned = q * turn;
    const glm::dvec4 v(turned.w, turned.x, turned.y, turned.z);
    nearest = std::min({nearest, glm::length(p - v), glm::length(p + v)});
  }
  return 4 * std::asin(nearest / 2) * 180 / std::numbers::pi;
}

inline double alpha_of(const Gaussian& g) { return 1 / (1 + std::exp(-static_cast<double>(g.opacity_logit))); }

// SH up to the lower of the two degrees. Positions beyond 1 by their share.
inline Difference difference(const Scene& a, const Scene& b) {
  Difference most;
  const auto raise = [](double& value, double to) { value = to > value || std::isnan(to) ? to : value; };
  const int rest = 3 * sh_rest_count(std::min(a.sh_degree, b.sh_degree));
  for (std::size_t i = 0; i < std::min(a.gaussians.size(), b.gaussians.size()); ++i) {
    const Gaussian &p = a.gaussians[i], &q = b.gaussians[i];
    for (int k = 0; k < 3; ++k) {
      raise(most.position, std::abs(p.mean[k] - q.mean[k]) / std::max(1.0f, std::abs(q.mean[k])));
      raise(most.scale, std::abs(p.log_scale[k] - q.log_scale[k]));
      raise(most.color, std::abs(p.sh_dc[k] - q.sh_dc[k]));
    }
    raise(most.alpha, std::abs(alpha_of(p) - alpha_of(q)));
    raise(most.rotation, angle_between(p.rotation, q.rotation));
    for (int k = 0; k < rest; ++k) raise(most.rest, std::abs(sh_rest_of(a, i)[k] - sh_rest_of(b, i)[k]));
  }
  return most;
}

}  // namespace pipegs
