// SPDX-License-Identifier: Apache-2.0
// gaze_views.cpp: see gaze_views.hpp.
#include "sim/command/sequence/gaze_views.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <limits>

namespace pipegs {
namespace {

// One eye's picture of a pair.
Image half_of(const Image& pair, int eye, int eyes) {
  const int width = pair.width / eyes;
  return cropped(pair, {eye * width, 0, (eye + 1) * width, pair.height});
}

double squared(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 d = glm::clamp(a, 0.0, 1.0) - glm::clamp(b, 0.0, 1.0);
  return glm::dot(d, d);
}

// The mean of the pixels of a sample, of those that lie in the picture.
glm::dvec3 mean_of(const Image& image, int x, int y, int side) {
  glm::dvec3 sum(0);
  int count = 0;
  for (int j = y - y % side; j < std::min(image.height, y - y % side + side); ++j) {
    for (int i = x - x % side; i < std::min(image.width, x - x % side + side); ++i, ++count)
      sum += glm::clamp(image.rgb[image.at(i, j)], 0.0, 1.0);
  }
  return sum / static_cast<double>(count);
}

// Sums of squared errors of a ring.
struct Errors {
  uint64_t pixels = 0;
  double repeated = 0, smooth = 0, mean = 0;
  double db(double sum) const {
    if (sum == 0) return std::numeric_limits<double>::infinity();
    return -10 * std::log10(sum / (3 * static_cast<double>(pixels)));
  }
};

void hold(const GazePicture& picture, const Image& truth, std::array<Errors, 3>& rings) {
  for (int y = 0; y < truth.height; ++y) {
    for (int x = 0; x < truth.width; ++x) {
      const size_t at = truth.at(x, y);
      Errors& ring = rings[static_cast<size_t>(picture.pitch[at])];
      ring.repeated += squared(picture.repeated.rgb[at], truth.rgb[at]);
      ring.smooth += squared(picture.smooth.rgb[at], truth.rgb[at]);
      ring.mean += squared(picture.repeated.rgb[at], mean_of(truth, x, y, 1 << picture.pitch[at]));
    }
  }
}

}  // namespace

std::vector<FrameRow> rows_of_parts(const std::vector<FrameRow>& views, const Gaze& gaze) {
  std::vector<FrameRow> rows;
  for (const FrameRow& view : views) {
    for (const GazePart& part : gaze_parts(view.camera, gaze)) {
      rows.push_back(view);
      rows.back().camera = part.camera;
      rows.back().sample = part.side();
    }
  }
  return rows;
}

GazeViews::GazeViews(const Scene& scene, const std::vector<FrameRow>& views, const Gaze& gaze,
                     const SimulateOptions& options, const glm::dvec3& background, const std::string& folder,
                     bool truth)
    : scene_(scene),
      views_(cameras_of(views)),
      gaze_(gaze),
      options_(options),
      background_(background),
      folder_(folder),
      truth_(truth) {}

void GazeViews::add(const Image& part) {
  const Camera& whole = views_.at(done_.size());
  if (images_.empty()) parts_ = gaze_parts(whole, gaze_);
  images_.push_back(part);
  if (images_.size() < parts_.size()) return;
  done_.push_back(finish(whole, parts_));
  images_.clear();
}

GazeView GazeViews::finish(const Camera& whole, const std::vector<GazePart>& parts) const {
  const int eyes = images_[0].width / parts[0].camera.width;
  Image truth;
  if (truth_) truth = simulate_float("truth", scene_, whole, options_, Semantics::kInria);
  std::array<Errors, 3> rings;
  for (int eye = 0; eye < eyes; ++eye) {
    std::vector<Image> images;
    for (const Image& image : images_) images.push_back(half_of(image, eye, eyes));
    const GazePicture picture = join_gaze(whole, parts, images);
    for (const int pitch : picture.pitch) ++rings[static_cast<size_t>(pitch)].pixels;
    if (truth_) hold(picture, half_of(truth, eye, eyes), rings);
    if (folder_.empty()) continue;
    const std::string name = fmt::format("gaze_{:04}{}.png", done_.size(), eye == 0 ? "" : "_right");
    write_png(std::filesystem::path(folder_) / name, picture.smooth, background_);
  }
  GazeView view{.parts = parts.size(), .rings = {}};
  const int edges[] = {0, gaze_.full, gaze_.half};
  for (size_t pitch = 0; pitch < rings.size(); ++pitch) {
    const Errors& sums = rings[pitch];
    if (sums.pixels == 0) continue;
    GazeRing& ring = view.rings.emplace_back();
    ring.sample = 1 << pitch;
    ring.pixels = sums.pixels;
    ring.from_degrees = std::atan(edges[pitch] / whole.fx) * 180 / M_PI;
    if (truth_) ring.db = {sums.db(sums.repeated), sums.db(sums.smooth), sums.db(sums.mean)};
  }
  return view;
}

}  // namespace pipegs
