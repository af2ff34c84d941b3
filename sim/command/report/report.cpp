// SPDX-License-Identifier: Apache-2.0
// report.cpp: `pipegs report`: one page of all results in a folder.
#include <fmt/format.h>

#include "scenes/input_error.hpp"
#include "sim/command/command.hpp"
#include "sim/command/page/page_argument.hpp"
#include "sim/command/report/report_page.hpp"

namespace pipegs {
namespace {

struct ReportArguments {
  std::string folder, page;
};

int run_report(const ReportArguments& arguments, const CLI::App& command) {
  const std::filesystem::path folder = arguments.folder;
  const std::filesystem::path file =
      arguments.page.empty() ? folder / "report.html" : std::filesystem::path(arguments.page);
  if (!arguments.page.empty() || std::filesystem::is_directory(folder)) try_file("--page", file);
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
  CLI::App* command = app.add_subcommand("report", "one HTML page of all results in a folder and those below it");
  command->footer(
      footer("pipegs report ladder", "written", "",
             "Reads what `sim`, `ladder` and `train` write: report.json, sequence.json, train.json. A file that "
             "is broken is\nleft out, with its reason in the page."));
  static ReportArguments arguments;
  command->add_option("DIR", arguments.folder, "the folder")->required();
  command->add_option("--page", arguments.page, "the file; report.html in the folder without it");
  command->callback([&run, command] { run = [command] { return run_report(arguments, *command); }; });
}

}  // namespace pipegs
