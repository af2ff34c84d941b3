// SPDX-License-Identifier: Apache-2.0
// frame_page_argument.cpp: see frame_page_argument.hpp.
#include "sim/command/page/frame_page_argument.hpp"

#include <fmt/format.h>

#include "sim/command/page/study_output.hpp"
#include "sim/command/replay.hpp"
#include "sim/report/html/template.hpp"
#include "sim/photos/photograph.hpp"

namespace pipegs {
namespace {

// `pipegs explain` of the same view: what of the command line it takes, too.
std::string explain_line(const CLI::App& sim) {
  const CLI::App* explain = sim.get_parent()->get_subcommand("explain");
  std::set<std::string> without;
  for (const CLI::Option* option : sim.get_options()) {
    if (explain->get_option_no_throw(option->get_name()) == nullptr || option->get_name() == "--window")
      without.insert(option->get_name());
  }
  std::string line = given_again(sim, without);
  const std::string word = " sim", other = " explain";
  line.replace(line.find(word), word.size(), other);
  return line + " --pixel ";
}

}  // namespace

void FramePageArgument::add(CLI::App& app) {
  CLI::Option* page = app.add_flag("--page", wanted_, "page.html: the frame's pictures and maps, where cycles went");
  app.add_option("--against", against_, "with --page: a photograph of this view (PNG, JPEG), beside the others")
      ->needs(page);
}

void FramePageArgument::check() const {
  if (wanted_) try_page();
}

std::optional<Rgb8> FramePageArgument::read(const Camera& camera, const SimulateOptions& options) const {
  if (!wanted_) return std::nullopt;
  const PixelRect asked = asked_pixels(camera.width, camera.height, options);
  check_page_picture("--page", asked);
  if (against_.empty()) return std::nullopt;
  return cropped(read_photograph(against_, camera), asked);
}

void FramePageArgument::write(const CLI::App& command, const std::string& out, FramePage page,
                              const Simulation& simulation, const SimulateOptions& options) const {
  const auto& report = page.report;
  page.title = fmt::format("{}, view {}, {}", report["scene"]["name"].get<std::string>(),
                           report["camera"]["name"].get<std::string>(), machine_name(options.config));
  page.command = given_again(command, {"--json"});
  page.explain = explain_line(command);
  page.against_name = against_;
  HtmlDocument document = frame_document(page, simulation, options);
  document.data["version"] = page_version();
  write_text(out + "/page.html", document.text(html_template("page")));
}

}  // namespace pipegs
