// SPDX-License-Identifier: Apache-2.0
// frame_page_argument.cpp: see frame_page_argument.hpp.
#include "sim/command/page/frame_page_argument.hpp"

#include <fmt/format.h>

#include "sim/command/page/study_output.hpp"
#include "sim/command/replay.hpp"
#include "sim/report/html/template.hpp"

namespace pipegs {

void FramePageArgument::add(CLI::App& app) {
  add_flag(app, "--page", wanted_, "page.html: pictures and maps, where cycles went; of a sequence sequence.html");
}

void FramePageArgument::check() const {
  if (wanted_) try_page();
}

void FramePageArgument::check(const Camera& camera, const SimulateOptions& options) const {
  if (wanted_) check_page_picture("--page", asked_pixels(camera.width, camera.height, options));
}

void FramePageArgument::write(const CLI::App& command, const std::string& out, FramePage page,
                              const Simulation& simulation, const SimulateOptions& options) const {
  const auto& report = page.report;
  page.title = fmt::format("{}, view {}, {}", report["scene"]["name"].get<std::string>(),
                           report["camera"]["name"].get<std::string>(), machine_name(options.config));
  page.command = given_again(command, {"--json"});
  page.explain = given_to("explain", command, {"--window"}) + " --pixel ";
  HtmlDocument document = frame_document(page, simulation, options);
  document.data["version"] = page_version();
  write_text(out + "/page.html", document.text(html_template("page")));
}

}  // namespace pipegs
