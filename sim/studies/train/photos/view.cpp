// SPDX-License-Identifier: Apache-2.0
// view: see view.hpp.
#include "sim/studies/train/photos/view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "cpp_model/float/truth.hpp"
#include "scenes/check/view_check.hpp"
#include "scenes/percentile.hpp"
#include "sim/photos/photograph.hpp"

namespace pipegs {
namespace {

void add(TrainingViews& views, bool held_out, TrainingView view) {
  (held_out ? views.held_out : views.trained).push_back(std::move(view));
}

// INRIA's getNerfppNorm, of the cameras that are trained on.
double extent_of(const std::vector<TrainingView>& views) {
  glm::dvec3 middle(0);
  for (const TrainingView& view : views) middle += view.camera.position / static_cast<double>(views.size());
  double farthest = 0;
  for (const TrainingView& view : views) farthest = std::max(farthest, glm::length(view.camera.position - middle));
  return farthest > 0 ? 1.1 * farthest : 1;  // cameras in one point say nothing of the scene
}

}  // namespace

std::vector<glm::vec3> TrainingView::picture() const {
  if (codes.empty()) return computed;
  std::vector<glm::vec3> pixels(codes.size() / 3);
  for (std::size_t i = 0; i < pixels.size(); ++i)
    pixels[i] = glm::vec3(codes[i * 3], codes[i * 3 + 1], codes[i * 3 + 2]) / 255.0f;
  return pixels;
}

Image TrainingView::image() const {
  Image image(camera.width, camera.height);
  const std::vector<glm::vec3> pixels = picture();
  std::copy(pixels.begin(), pixels.end(), image.rgb.begin());
  std::fill(image.transmittance.begin(), image.transmittance.end(), 0.0);
  return image;
}

double near_plane_of(const ColmapFolder& folder, Findings& findings) {
  std::vector<glm::dvec3> points;
  for (const ScenePoint& point : folder.points) points.push_back(point.position);
  const Findings before = check_views(points, folder.cameras, kNearPlane);
  if (before.empty()) return kNearPlane;
  std::vector<double> depths;
  const std::size_t step = points.size() / 2000 + 1;
  for (const Camera& camera : folder.cameras) {
    for (std::size_t i = 0; i < points.size(); i += step) {
      const double depth = (camera.world_to_camera * (points[i] - camera.position)).z;
      if (depth > 0) depths.push_back(depth);
    }
  }
  const double near = std::min(kNearPlane, percentile(std::move(depths), 0.01) / 2);
  if (!(near < kNearPlane)) {  // they show nothing for another reason
    findings.insert(findings.end(), before.begin(), before.end());
    return kNearPlane;
  }
  findings.emplace_back("near_chosen",
                        fmt::format("points lie nearer to the cameras than the near plane of {:g} of the "
                                    "scene's unit: {:.3g} is taken (--near sets it; whoever draws the "
                                    "scene needs the same)",
                                    kNearPlane, near));
  return near;
}

TrainingViews views_of_photographs(const ColmapFolder& folder, int downscale, double near_plane, const Advance& advance,
                                   Findings& findings) {
  TrainingViews views;
  PhotographFindings found;
  const std::set<std::string> held_out(folder.held_out.begin(), folder.held_out.end());
  for (std::size_t i = 0; i < folder.cameras.size(); ++i) {
    advance(static_cast<double>(i) / static_cast<double>(folder.cameras.size()));
    const std::string& name = folder.cameras[i].name;
    const Photograph photograph = read_photograph(folder.images / name, folder.cameras[i]);
    TrainingView view{scaled_camera(photograph.camera, 1.0 / downscale), {}, {}, near_plane};
    view.codes = shrunk(photograph.picture, view.camera.width, view.camera.height).data;
    found.add(name, photograph);
    add(views, held_out.empty() ? i % kHeldOutEvery == 0 : held_out.contains(name), std::move(view));
  }
  const Findings of_photographs = found.all();
  findings.insert(findings.end(), of_photographs.begin(), of_photographs.end());
  views.extent = extent_of(views.trained);
  return views;
}

TrainingViews views_of_scene(const Scene& scene, std::vector<Camera> cameras, int downscale, unsigned threads,
                             const Advance& advance, double near_plane) {
  std::stable_sort(cameras.begin(), cameras.end(), [](const Camera& a, const Camera& b) { return a.name < b.name; });
  TrainingViews views;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    TrainingView view{scaled_camera(cameras[i], 1.0 / downscale), {}, {}, near_plane};
    TruthOptions options;
    options.near_plane = near_plane;
    options.threads = threads;
    options.progress = [&](double share) {
      advance((static_cast<double>(i) + share) / static_cast<double>(cameras.size()));
    };
    const Image image = render_truth(scene, view.camera, options);
    view.computed.assign(image.rgb.begin(), image.rgb.end());
    add(views, i % kHeldOutEvery == 0, std::move(view));
  }
  views.extent = extent_of(views.trained);
  return views;
}

}  // namespace pipegs
