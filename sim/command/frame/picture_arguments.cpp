// SPDX-License-Identifier: Apache-2.0
// picture_arguments.cpp: see picture_arguments.hpp.
#include "sim/command/frame/picture_arguments.hpp"

#include <algorithm>

#include "sim/design/config_file.hpp"

namespace pipegs {
namespace {

// Whether --config or --set names this entry.
bool is_set(const ViewArguments& view, const std::string& entry) {
  const auto names = [&](const std::string& setting) { return setting.starts_with(entry + "="); };
  if (std::any_of(view.settings.begin(), view.settings.end(), names)) return true;
  if (view.config.empty()) return false;
  const std::vector<ConfigLine> lines = read_config_file(view.config);
  return std::any_of(lines.begin(), lines.end(), [&](const ConfigLine& line) { return names(line.setting); });
}

}  // namespace

void PictureArguments::add(CLI::App& app) {
  add_color(app, "--background", background,
            "what lies behind the scene in the 8-bit picture, R,G,B of 0 to 255 or '#rrggbb'; black without it");
  add_rectangle(app, "--crop", crop, "only these pixels, as they are in the whole picture", kMaxImageSide)
      .excludes("--window");
}

bool PictureArguments::is_black() const {
  return std::all_of(background.begin(), background.end(), [](int code) { return code == 0; });
}

void PictureArguments::apply(const ViewArguments& view, bool machine, SimulateOptions& options) const {
  if (!crop.empty()) options.crop = PixelRect{crop[0], crop[1], crop[0] + crop[2], crop[1] + crop[3]};
  if (is_black() || !machine) return;
  if (options.raster)
    throw ConfigError("--background: found --picture raster, whose pixels hold no T, expected windows");
  if (options.config.eyes > 1 || options.config.has_aovs())
    throw ConfigError(
        "--background: found a machine of two eyes or with AOVs, whose pixels hold no T, expected neither");
  if (options.config.pixel_w == 32 && is_set(view, "pixel_w"))
    throw ConfigError("--background: found pixel_w=32, whose pixels hold no T, expected 64");
  options.config.pixel_w = 64;
}

Background PictureArguments::color() const {
  Background color = {};
  std::copy(background.begin(), background.end(), color.begin());
  return color;
}

Rgb8 PictureArguments::picture(const Simulation& simulation, const SimulateOptions& options) const {
  if (is_black()) return to_rgb8(picture_of(simulation, options), glm::dvec3(0));
  const Image& image = simulation.golden.image;
  const std::vector<uint64_t>& pixels =
      simulation.written.pixels.empty() ? simulation.golden.pixels : simulation.written.pixels;
  return over_background(pixels, image.width, asked_pixels(image.width, image.height, options), color());
}

}  // namespace pipegs
