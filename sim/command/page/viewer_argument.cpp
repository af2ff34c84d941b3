// SPDX-License-Identifier: Apache-2.0
// viewer_argument.cpp: see viewer_argument.hpp.
#include "sim/command/page/viewer_argument.hpp"

#include <fmt/format.h>

#include "sim/command/page/study_output.hpp"
#include "sim/command/replay.hpp"
#include "sim/report/html/template.hpp"

namespace pipegs {

void ViewerArgument::add_option(CLI::App& app) {
  add_flag(app, "--viewer", wanted_,
           "viewer.html: the scene in a viewer (Spark) beside the machine's picture, in step");
}

void ViewerArgument::begin(const LoadedView& loaded, const std::vector<Camera>& cameras, const SimulateOptions& options,
                           const Background& background, const CLI::App& command) {
  if (!wanted()) return;
  std::size_t pixels = 0;
  for (const Camera& camera : cameras) {
    const PixelRect part = asked_pixels(camera.width, camera.height, options);
    check_page_picture("--viewer", part);
    pixels += static_cast<std::size_t>(part.x1 - part.x0) * static_cast<std::size_t>(part.y1 - part.y0);
    page_.frames.push_back({.camera = camera, .part = part, .picture = {}});
  }
  check_viewer(loaded.scene, pixels);
  template_ = html_template("viewer");
  page_.title = cameras.size() == 1 ? fmt::format("{}, view {}", loaded.scene.name, cameras[0].name)
                                    : fmt::format("{}, {} frames", loaded.scene.name, cameras.size());
  page_.command = given_again(command, {"--json"});
  page_.version = page_version();
  page_.scene = &loaded.scene;
  page_.machine = machine_name(options.config);
  page_.antialias = options.config.antialias != 0;
  page_.near_plane = options.near_plane;
  page_.background = background;
}

void ViewerArgument::add(const Rgb8& picture) {
  if (wanted()) page_.frames.at(added_++).picture = picture;
}

std::string ViewerArgument::write(const std::string& out) {
  if (!wanted()) return "";
  const ViewerHtml page = viewer_html(page_, template_);
  write_text(out + "/viewer.html", page.html);
  return fmt::format("viewer {}/viewer.html ({:.1f} MB): {}\n", out, static_cast<double>(page.html.size()) / 1e6,
                     page.reduced);
}

}  // namespace pipegs
