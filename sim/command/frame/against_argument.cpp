// SPDX-License-Identifier: Apache-2.0
// against_argument.cpp: see against_argument.hpp.
#include "sim/command/frame/against_argument.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cpp_model/float/metrics.hpp"
#include "scenes/input_error.hpp"
#include "sim/photos/photograph.hpp"
#include "sim/progress.hpp"

namespace pipegs {
namespace {

namespace fs = std::filesystem;

constexpr std::array kEndings = {".png", ".PNG", ".jpg", ".JPG", ".jpeg", ".JPEG"};

// The photograph as the view's pixels.
Photograph read(const fs::path& file, const Camera& camera) {
  Photograph photograph = read_photograph(file, camera);
  Rgb8& picture = photograph.picture;
  if (picture.width < camera.width || picture.height < camera.height)
    throw InputError(file.string(), "",
                     fmt::format("found {0}x{1} pixels, fewer than the view's {2}x{3} (--size {0}x{1} draws as many)",
                                 picture.width, picture.height, camera.width, camera.height));
  picture = shrunk(picture, camera.width, camera.height);
  return photograph;
}

Image image_of(const Rgb8& picture) {
  Image image(picture.width, picture.height);
  for (size_t i = 0; i < image.rgb.size(); ++i)
    image.rgb[i] = glm::dvec3(picture.data[3 * i], picture.data[3 * i + 1], picture.data[3 * i + 2]) / 255.0;
  return image;
}

}  // namespace

std::string against_text(const AgainstFigures& figures) {
  const std::string decibels = std::isinf(figures.psnr_db) ? "equal" : fmt::format("{:.2f} dB", figures.psnr_db);
  return fmt::format("against {}: {}{}\n", figures.photograph, decibels,
                     std::isnan(figures.ssim) ? "" : fmt::format(", SSIM {:.4f}", figures.ssim));
}

void AgainstArgument::add(CLI::App& app) {
  add_text(app, "--against", given_,
           "a photograph of this view (PNG, JPEG), or a folder with one for each view, named as its camera or as our "
           "picture: PSNR and SSIM");
}

void AgainstArgument::begin(const LoadedView& loaded, const std::vector<Camera>& cameras,
                            const SimulateOptions& options, bool sequence) {
  if (!wanted()) return;
  if (sequence && fs::is_regular_file(given_))
    throw ConfigError("--against: found a file, expected a folder with a picture of each view");
  PhotographFindings found;
  size_t photographs = 0;
  Progress progress("photographs");
  for (size_t i = 0; i < cameras.size(); ++i) {
    if (interrupted()) throw std::runtime_error("interrupted");
    const Camera& camera = cameras[i];
    View& view = views_.emplace_back(View{camera, asked_pixels(camera.width, camera.height, options),
                                          find(camera, sequence ? fmt::format("frame_{:04}", i) : "frame")});
    if (!view.file) continue;
    Photograph photograph = read(*view.file, camera);
    found.add(view.file->string(), photograph);
    if (cameras.size() == 1) view.picture = std::move(photograph.picture);
    progress.update(static_cast<double>(++photographs) / static_cast<double>(cameras.size()));
  }
  if (photographs == 0)
    throw InputError(
        given_, "",
        fmt::format("found no picture of a view, expected one named as its camera, such as {}, or as ours, "
                    "{}.png",
                    quote(cameras.front().name + ".png"), sequence ? "frame_0000" : "frame"));
  loaded.told->tell(found.all());
}

std::optional<fs::path> AgainstArgument::find(const Camera& camera, const std::string& own) const {
  if (!fs::is_directory(given_)) return given_;
  const fs::path named = fs::path(camera.name).relative_path().lexically_normal();
  for (fs::path name : {named, named.filename(), fs::path(own)}) {
    if (name.empty() || *name.begin() == "..") continue;
    if (std::find(kEndings.begin(), kEndings.end(), name.extension().string()) != kEndings.end())
      name.replace_extension();
    std::vector<fs::path> found;
    for (const char* ending : kEndings) {
      std::error_code none;
      const fs::path file = fs::path(given_) / (name.string() + ending);
      if (fs::is_regular_file(file, none)) found.push_back(file);
    }
    if (found.size() > 1)
      throw InputError(
          given_, "",
          fmt::format("found {} and {}, expected one picture of view {}", quote(found[0].filename().string()),
                      quote(found[1].filename().string()), quote(camera.name)));
    if (!found.empty()) return found.front();
  }
  return std::nullopt;
}

std::optional<Rgb8> AgainstArgument::photograph(size_t view) const {
  if (!wanted() || !views_.at(view).file) return std::nullopt;
  const View& one = views_[view];
  return cropped(one.picture ? *one.picture : read(*one.file, one.camera).picture, one.asked);
}

std::optional<AgainstFigures> AgainstArgument::figures(size_t view, const Rgb8& drawn) const {
  const std::optional<Rgb8> photograph = this->photograph(view);
  if (!photograph) return std::nullopt;
  const Image a = image_of(drawn), b = image_of(*photograph);
  return AgainstFigures{views_[view].file->string(), psnr(a, b), ssim(a, b)};
}

}  // namespace pipegs
