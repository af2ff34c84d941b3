// SPDX-License-Identifier: Apache-2.0
// campaign.cpp: `pipegs campaign`: writes one command a line for each point of a campaign, and merges what they kept.
//
// Idea    Nothing here runs a point: GNU parallel does. What must be done once for all points is done before:
//         every scene, view and configuration is tried, every machine of the RTL is built.
// Rule    The lines are those whose points are not kept yet. So what was interrupted, or lost since, goes on when the
//         campaign is written again.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "scenes/atomic_file.hpp"
#include "sim/command/campaign/merge.hpp"
#include "sim/command/page/study_output.hpp"
#include "sim/command/replay.hpp"
#include "sim/progress.hpp"

namespace pipegs {
namespace {

struct CampaignArguments {
  std::string file, out;
  bool merge = false, page = false;
};

// Every point, with what is kept of it. Scenes are read one after the other, each once.
std::vector<PointResult> look_up(const std::vector<CampaignPoint>& points, std::set<std::string>* machines) {
  Progress progress("looking at the points");
  std::vector<PointResult> results;
  for (size_t first = 0, next = 0; first < points.size(); first = next) {
    ViewArguments highest = points[first].arguments.view;
    while (next < points.size() && points[next].scene == points[first].scene) {
      highest.view = std::max(highest.view, points[next].arguments.view.view);
      ++next;
    }
    const LoadedView loaded = load_view(highest);  // refuses a view that is not there
    const MeasurementStore store = point_store(points[first].arguments, loaded.scene, loaded.camera);
    for (size_t i = first; i < next; ++i) {
      const PointArguments& arguments = points[i].arguments;
      const Camera& camera = loaded.cameras[arguments.view.view];
      const SimulateOptions options = point_options(arguments, loaded);
      if (machines != nullptr && arguments.engine == "rtl" &&
          machines->insert(config_difference(options.config)).second)
        build_rtl(options.config, built_variant(options.variant, options.rtl));
      const MeasurementStore of_view = store.of(camera);
      results.push_back({.point = points[i],
                         .camera = camera.name,
                         .file = of_view.path(options.config),
                         .kept = kept_point(of_view, options.config)});
      progress.update(static_cast<double>(results.size()) / static_cast<double>(points.size()),
                      fmt::format("{} of {}", results.size(), points.size()));
    }
  }
  return results;
}

size_t count_kept(const std::vector<PointResult>& points) {
  return std::count_if(points.begin(), points.end(), [](const PointResult& one) { return one.kept.has_value(); });
}

int write_lines(const CampaignArguments& arguments, const std::vector<PointResult>& points, size_t machines) {
  const std::filesystem::path out = std::filesystem::absolute(arguments.out).lexically_normal();
  std::string text;
  for (const PointResult& one : points) {
    if (!one.kept) text += one.point.arguments.line() + "\n";
  }
  write_text(out / "lines.txt", text);
  make_folders(out / "points");
  fmt::print("{} points, {} of them kept; {} machines of the RTL are built\n\n", points.size(), count_kept(points),
             machines);
  if (!text.empty()) fmt::print("next: parallel < {}\n", shell_word((out / "lines.txt").string()));
  fmt::print("then: pipegs campaign {} --out {} --merge\n", shell_word(arguments.file), shell_word(arguments.out));
  return kExitOk;
}

int merge(const CampaignArguments& arguments, const CLI::App& command, const std::vector<PointResult>& points) {
  write_merged(arguments.out, points);
  if (arguments.page) {
    StudyPage page = study_page("Campaign", command);
    add_campaign(page, points);
    write_page(arguments.out + "/campaign.html", page);
  }
  size_t differing = 0;
  for (const PointResult& one : points) {
    if (!one.kept) continue;
    const auto& result = (*one.kept)["result"];
    differing += result.contains("mismatches") && !result["mismatches"].is_null() && result["mismatches"] != 0;
  }
  const size_t kept = count_kept(points);
  fmt::print("{} of {} points in {}/results.csv, results.json, costs.csv\n{}\n", kept, points.size(), arguments.out,
             cost_text(points));
  for (const PointResult& one : points) {
    if (one.kept) continue;
    fmt::print(stderr, "pipegs: {} points are missing, the first: {}\n", points.size() - kept,
               one.point.arguments.line());
    break;
  }
  if (differing > 0) fmt::print(stderr, "pipegs: in {} points the RTL differs from the golden model\n", differing);
  return kept == points.size() && differing == 0 ? kExitOk : kExitDiffers;
}

int run_campaign(const CampaignArguments& arguments, const CLI::App& command) {
  try_folder("--out", arguments.out, {"lines.txt", "results.csv", "results.json", "costs.csv", "campaign.html"});
  if (arguments.page) try_page();
  const std::vector<CampaignPoint> campaign =
      read_campaign(arguments.file, std::filesystem::path(arguments.out) / "points");
  std::set<std::string> machines;
  const std::vector<PointResult> points = look_up(campaign, arguments.merge ? nullptr : &machines);
  return arguments.merge ? merge(arguments, command, points) : write_lines(arguments, points, machines.size());
}

}  // namespace

void add_campaign(CLI::App& app, Run& run) {
  CLI::App& command =
      add_command(app, "campaign", "scenes x views x settings x design points",
                  footer("pipegs campaign campaign.json --out campaign", "written (--merge: of every point)",
                         "--merge: a point is missing, or the RTL differs in one",
                         "GNU parallel runs the lines, on one core each. Written again they are those that are "
                         "left: nothing is measured twice."));
  static CampaignArguments arguments;
  add_text(command, "FILE", arguments.file, "campaign: JSON, docs/campaign.md has its fields").required();
  add_text(command, "--out", arguments.out, "folder for the lines, what they keep, and what it is merged to")
      .required();
  add_flag(command, "--merge", arguments.merge, "merge what is kept: results.csv, results.json, costs.csv");
  add_flag(command, "--page", arguments.page, "campaign.html: charts of all points, too").needs("--merge");
  when_chosen(command, run, [&command] { return run_campaign(arguments, command); });
}

}  // namespace pipegs
