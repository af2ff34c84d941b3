// SPDX-License-Identifier: Apache-2.0
// report.cpp: `pipegs report`: one page of all results in a folder.
#include <fmt/format.h>

#include "scenes/input_error.hpp"
#include "sim/command/command.hpp"
#include "sim/command/page/study_output.hpp"
#include "sim/command/report/report_page.hpp"

namespace pipegs {
namespace {

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
  CLI::App* command = app.add_subcommand("report", "one page of all results in a folder");
  command->footer(
      footer("pipegs report ladder", "written", "",
             "Reads what `sim`, `ladder` and `train` write: report.json, sequence.json, train.json. A file that "
             "is broken is\nleft out, with its reason in the page."));
  static std::string folder;
  command->add_option("DIR", folder, "the folder; the page is its report.html")->required();
  command->callback([&run, command] { run = [command] { return run_report(folder, *command); }; });
}

}  // namespace pipegs
