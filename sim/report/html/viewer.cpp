// SPDX-License-Identifier: Apache-2.0
// viewer.cpp: see viewer.hpp.
#include "sim/report/html/viewer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "cpp_model/config.hpp"
#include "scenes/packed/write_spz.hpp"
#include "scenes/ply/ply.hpp"
#include "sim/report/html/document.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

// The Gaussians of which `takes` is true.
template <typename Takes>
Scene part_of(const Scene& scene, Takes takes) {
  Scene kept{.name = scene.name, .sh_degree = scene.sh_degree, .antialiased = scene.antialiased};
  const auto rest = static_cast<std::size_t>(3 * sh_rest_count(scene.sh_degree));
  for (std::size_t i = 0; i < scene.gaussians.size(); ++i) {
    if (!takes(i)) continue;
    kept.gaussians.push_back(scene.gaussians[i]);
    const float* sh = sh_rest_of(scene, i);
    kept.sh_rest.insert(kept.sh_rest.end(), sh, sh + rest);
  }
  return kept;
}

Scene drawable(const Scene& scene) {
  ActivatedGaussian ignored;
  return part_of(scene, [&](std::size_t i) { return activate(scene, i, ignored) == Cull::kNone; });
}

// A few Gaussians far out would cost all others the bits of their positions: these go into a file of their own.
std::vector<Scene> near_and_far(Scene scene) {
  constexpr double kNear = 0.98, kFar = 8;  // how many are near; how much farther the others must be
  const auto distance = [&](std::size_t i) {
    const glm::vec3 away = glm::abs(scene.gaussians[i].mean);
    return std::max({away.x, away.y, away.z});
  };
  std::vector<float> distances;
  for (std::size_t i = 0; i < scene.gaussians.size(); ++i) distances.push_back(distance(i));
  std::sort(distances.begin(), distances.end());
  const float limit = distances[static_cast<std::size_t>(kNear * static_cast<double>(distances.size() - 1))];
  std::vector<Scene> parts;
  if (distances.back() < kFar * limit) {
    parts.push_back(std::move(scene));
  } else {
    for (const bool far : {false, true})
      parts.push_back(part_of(scene, [&](std::size_t i) { return (distance(i) > limit) == far; }));
  }
  return parts;
}

std::size_t ply_bytes(const Scene& scene) {
  return scene.gaussians.size() * sizeof(float) * static_cast<std::size_t>(17 + 3 * sh_rest_count(scene.sh_degree));
}

// The scene in the page, and what it has lost there.
std::vector<std::string> add_scene(HtmlDocument& document, const Scene& all) {
  Scene scene = drawable(all);
  std::vector<std::string> reduced;
  Json& json = document.data["scene"];
  const bool exact = ply_bytes(scene) <= kMostPlyBytes;
  json = {{"name", all.name},
          {"gaussians", scene.gaussians.size()},
          {"sh_degree", scene.sh_degree},
          {"form", exact ? "ply" : "spz"},
          {"files", Json::array()}};
  if (const std::size_t out = all.gaussians.size() - scene.gaussians.size(); out > 0)
    reduced.push_back(
        fmt::format("{} Gaussians left out that no renderer draws (not finite, or without a rotation)", out));
  const auto add = [&](const std::string& bytes) {
    document.add_file(fmt::format("scene:{}", json["files"].size()), bytes);
    json["files"].push_back(bytes.size());
  };
  if (exact) {
    std::ostringstream stream;
    write_ply(stream, scene);
    add(stream.str());
  } else {
    std::vector<std::string> steps;
    std::size_t cut = 0, numbers = 0;
    for (const Scene& part : near_and_far(std::move(scene))) {
      const Spz spz = write_spz(part);
      steps.push_back(fmt::format("1/{}{}", std::int64_t{1} << spz.position_bits,
                                  steps.empty() ? "" : fmt::format(" for the {} farthest", part.gaussians.size())));
      cut += spz.cut;
      numbers += spz.numbers;
      add(spz.bytes);
    }
    reduced.push_back(
        fmt::format("numbers rounded to those of .spz: positions to {}, logarithms of scales to 1/16, rotations to 10 "
                    "bits, opacities, colors and SH to 8",
                    fmt::join(steps, ", ")));
    if (cut > 0) reduced.push_back(fmt::format("{} of {} numbers cut to the range of .spz", cut, numbers));
  }
  json["reduced"] = reduced;
  return reduced;
}

Json camera_json(const ViewerFrame& frame) {
  const Camera& camera = frame.camera;
  Json rotation = Json::array();  // camera to world, row by row, as in INRIA's cameras.json
  for (int r = 0; r < 3; ++r) {
    const glm::dvec3 row = camera.world_to_camera[r];
    rotation.push_back({row.x, row.y, row.z});
  }
  const PixelRect& part = frame.part;
  return {{"name", camera.name},     {"width", camera.width},
          {"height", camera.height}, {"position", {camera.position.x, camera.position.y, camera.position.z}},
          {"rotation", rotation},    {"fx", camera.fx},
          {"fy", camera.fy},         {"cx", camera.cx},
          {"cy", camera.cy},         {"part", {part.x0, part.y0, part.x1 - part.x0, part.y1 - part.y0}}};
}

}  // namespace

void check_viewer(const Scene& scene, std::size_t pixels) {
  if (scene.gaussians.size() > kMostViewerGaussians)
    throw ConfigError(fmt::format("--viewer: found {} Gaussians, expected {} at most in a page", scene.gaussians.size(),
                                  kMostViewerGaussians));
  if (pixels > kMostViewerPixels)
    throw ConfigError(
        fmt::format("--viewer: found frames of {} pixels, expected {} at most in a page", pixels, kMostViewerPixels));
}

ViewerHtml viewer_html(const ViewerPage& page, const std::string& html_template) {
  HtmlDocument document("viewer", page.title, page.command);
  const std::vector<std::string> reduced = add_scene(document, *page.scene);
  document.data["version"] = page.version;
  document.data["machine"] = page.machine;
  document.data["antialias"] = page.antialias;
  document.data["near"] = page.near_plane;
  document.data["background"] = page.background;
  for (std::size_t i = 0; i < page.frames.size(); ++i) {
    const ViewerFrame& frame = page.frames[i];
    document.data["frames"].push_back(camera_json(frame));
    document.add_plane(fmt::format("picture:{}", i), frame.picture.width, frame.picture.height, 3, frame.picture.data);
  }
  return {document.text(html_template),
          reduced.empty() ? "the scene is whole, number for number" : fmt::format("{}", fmt::join(reduced, "; "))};
}

}  // namespace pipegs
