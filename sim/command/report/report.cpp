// SPDX-License-Identifier: Apache-2.0
// report.cpp: `pipegs report`: one page of all results in a folder.
#include <fmt/format.h>

#include <algorithm>

#include "scenes/input_error.hpp"
#include "sim/command/command.hpp"
#include "sim/command/page/study_output.hpp"
#include "sim/command/report/results.hpp"
#include "sim/photos/photograph.hpp"

namespace pipegs {
namespace {

// As large as a page of a few megabytes allows: a pixel takes about two bytes.
void add_pictures(StudyPage& page, const std::vector<FolderResults::Picture>& pictures) {
  constexpr int kMostPixels = 1500000;
  int longest = FolderResults::kLongestSide;
  const auto shrunken = [&](int side, const Rgb8& picture) {
    const int step = (std::max(picture.width, picture.height) + longest - 1) / longest;
    return (side + step - 1) / step;
  };
  const auto pixels = [&] {
    int all = 0;
    for (const auto& [caption, id, one] : pictures) all += shrunken(one.width, one) * shrunken(one.height, one);
    return all;
  };
  while (longest > 40 && pixels() > kMostPixels) longest /= 2;
  if (!pictures.empty()) page.section("Pictures");
  for (const auto& [caption, id, one] : pictures)
    page.picture(caption, shrunk(one, shrunken(one.width, one), shrunken(one.height, one)), id);
}

void add_results(StudyPage& page, const FolderResults& results) {
  page.lead(
      fmt::format("{} results: {} frames, {} sequences of frames, {} trained scenes.{}", results.count(),
                  results.frames.rows.size(), results.walks.size(), results.trained_scenes,
                  results.left_out.empty() ? "" : fmt::format(" {} files are left out.", results.left_out.size())));
  if (!results.frames.rows.empty()) {
    page.section("Frames");
    page.table(results.frames);
    page.charts(results.charts);
  }
  if (!results.walks.empty()) page.section("Sequences of frames");
  for (const auto& [chart, table] : results.walks) page.charts({chart}), page.table(table);
  if (!results.trained.rows.empty()) page.section("Trained scenes"), page.table(results.trained);
  add_pictures(page, results.pictures);
  if (results.left_out.empty()) return;
  page.section("Left out");
  Table table{.columns = {{.heading = "file", .word = true, .wrapped = true},
                          {.heading = "why", .word = true, .wrapped = true}}};
  for (const LeftOut& one : results.left_out) table.rows.push_back({text_cell(one.file), text_cell(one.reason)});
  page.table(table);
}

int run_report(const std::filesystem::path& folder, const CLI::App& command) {
  const std::filesystem::path file = folder / "report.html";
  if (std::filesystem::is_directory(folder)) try_file("DIR", file);
  const FolderResults results = read_results(folder);
  if (results.count() == 0) {
    throw InputError(folder.string(), "",
                     results.left_out.empty()
                         ? "found no result, expected report.json, sequence.json or train.json"
                         : fmt::format("found no result that can be read; {}: {}", results.left_out.front().file,
                                       results.left_out.front().reason));
  }
  try_page();
  StudyPage page = study_page("Results in " + folder.string(), command);
  add_results(page, results);
  write_page(file, page);
  fmt::print("{} results in {}\n", results.count(), file.string());
  for (const LeftOut& one : results.left_out) fmt::print("  left out: {}: {}\n", one.file, one.reason);
  return kExitOk;
}

}  // namespace

void add_report(CLI::App& app, Run& run) {
  CLI::App& command = add_command(
      app, "report", "one page of all results in a folder",
      footer("pipegs report ladder", "written", "",
             "Reads what `sim`, `ladder` and `train` write: report.json, sequence.json, train.json. A file that "
             "is broken is\nleft out, with its reason in the page."));
  static std::string folder;
  add_text(command, "DIR", folder, "the folder; the page is its report.html").required();
  when_chosen(command, run, [&command] { return run_report(folder, command); });
}

}  // namespace pipegs
