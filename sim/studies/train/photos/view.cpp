// SPDX-License-Identifier: Apache-2.0
// view: see view.hpp.
#include "sim/studies/train/photos/view.hpp"

#include <algorithm>

#include "cpp_model/float/truth.hpp"
#include "sim/photos/photograph.hpp"

namespace pipegs {
namespace {

void add(TrainingViews& views, std::size_t number, TrainingView view) {
  (number % kHeldOutEvery == 0 ? views.held_out : views.trained).push_back(std::move(view));
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

TrainingViews views_of_photographs(const ColmapFolder& folder, int downscale, const Advance& advance) {
  TrainingViews views;
  for (std::size_t i = 0; i < folder.cameras.size(); ++i) {
    advance(static_cast<double>(i) / static_cast<double>(folder.cameras.size()));
    const Camera& camera = folder.cameras[i];
    TrainingView view{scaled_camera(camera, 1.0 / downscale), {}, {}};
    view.codes =
        shrunk(read_photograph(folder.images / camera.name, camera), view.camera.width, view.camera.height).data;
    add(views, i, std::move(view));
  }
  views.extent = extent_of(views.trained);
  return views;
}

TrainingViews views_of_scene(const Scene& scene, std::vector<Camera> cameras, int downscale, unsigned threads,
                             const Advance& advance) {
  std::stable_sort(cameras.begin(), cameras.end(), [](const Camera& a, const Camera& b) { return a.name < b.name; });
  TrainingViews views;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    TrainingView view{scaled_camera(cameras[i], 1.0 / downscale), {}, {}};
    TruthOptions options;
    options.threads = threads;
    options.progress = [&](double share) {
      advance((static_cast<double>(i) + share) / static_cast<double>(cameras.size()));
    };
    const Image image = render_truth(scene, view.camera, options);
    view.computed.assign(image.rgb.begin(), image.rgb.end());
    add(views, i, std::move(view));
  }
  views.extent = extent_of(views.trained);
  return views;
}

}  // namespace pipegs
