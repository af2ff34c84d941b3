// SPDX-License-Identifier: Apache-2.0
// camera_arguments.hpp: where the views of a scene come from: a file, or a framing of the scene.
//
// Rule    --cameras excludes what frames a scene (--orbit, --from, --look-at, --up, --fov). Without any of them a scene
//         is framed as scenes/cameras/framing.hpp says, and our own scene has its generated cameras. --scale is last.
// Errors  ConfigError of an option, InputError of a file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenes/camera.hpp"
#include "scenes/check/finding.hpp"
#include "scenes/scene.hpp"
#include "sim/command/options.hpp"

namespace pipegs {

struct CameraArguments {
  std::string file, size;
  bool ignore_distortion = false;
  int orbit = 0;
  double fov = 0, scale = 1;
  std::vector<double> from, look_at, up;

  void add(CLI::App& app);
  // The views of the file; nothing without one.
  std::optional<std::vector<Camera>> read(Findings& findings) const;
  // Those, or the views without a file, of a scene that is our own or not, about the origin of the scene.
  std::vector<Camera> views(const std::optional<std::vector<Camera>>& given, const Scene& scene, bool own,
                            const glm::dvec3& origin) const;

 private:
  std::vector<Camera> frame(const Scene& scene, bool own, const glm::dvec3& origin) const;
  CameraReading reading() const;
  std::vector<Camera> scaled(std::vector<Camera> cameras) const;
  bool frames() const { return orbit > 0 || fov > 0 || !from.empty() || !look_at.empty() || !up.empty(); }
};

}  // namespace pipegs
