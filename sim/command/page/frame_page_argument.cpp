// SPDX-License-Identifier: Apache-2.0
// frame_page_argument.cpp: see frame_page_argument.hpp.
#include "sim/command/page/frame_page_argument.hpp"

#include <fmt/format.h>

#include "sim/command/page/study_output.hpp"
#include "sim/command/replay.hpp"
#include "sim/report/html/template.hpp"
#include "sim/photos/photograph.hpp"

namespace pipegs {

void FramePageArgument::add(CLI::App& app) {
  add_flag(app, "--page", wanted_, "page.html: the frame's pictures and maps, where cycles went");
  add_text(app, "--against", against_, "with --page: a photograph of this view (PNG, JPEG), beside the others")
      .needs("--page");
}

void FramePageArgument::check() const {
  if (wanted_) try_page();
}

std::optional<Rgb8> FramePageArgument::read(const LoadedView& loaded, const SimulateOptions& options) const {
  if (!wanted_) return std::nullopt;
  const PixelRect asked = asked_pixels(loaded.camera.width, loaded.camera.height, options);
  check_page_picture("--page", asked);
  if (against_.empty()) return std::nullopt;
  const Photograph photograph = read_photograph(against_, loaded.camera, OtherSize::kShrunk);
  PhotographFindings found;
  found.add(against_, photograph);
  loaded.told->tell(found.all());
  return cropped(photograph.picture, asked);
}

void FramePageArgument::write(const CLI::App& command, const std::string& out, FramePage page,
                              const Simulation& simulation, const SimulateOptions& options) const {
  const auto& report = page.report;
  page.title = fmt::format("{}, view {}, {}", report["scene"]["name"].get<std::string>(),
                           report["camera"]["name"].get<std::string>(), machine_name(options.config));
  page.command = given_again(command, {"--json"});
  page.explain = given_to("explain", command, {"--window"}) + " --pixel ";
  page.against_name = against_;
  HtmlDocument document = frame_document(page, simulation, options);
  document.data["version"] = page_version();
  write_text(out + "/page.html", document.text(html_template("page")));
}

}  // namespace pipegs
