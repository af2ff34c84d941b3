// SPDX-License-Identifier: Apache-2.0
// page_argument.cpp: see page_argument.hpp.
#include "sim/command/page/page_argument.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/command/outputs.hpp"
#include "sim/command/replay.hpp"
#include "sim/design/design_point.hpp"
#include "sim/report/html/template.hpp"
#include "sim/report/measurement_store.hpp"

namespace pipegs {
namespace {

constexpr const char* kTemplate = "page";

}  // namespace

Table machines_table(const NamedMachines& machines) {
  Table table{.title = "The machines",
              .columns = {{.heading = "machine", .word = true},
                          {.heading = "settings for any command", .word = true, .wrapped = true, .copies = true}}};
  for (const auto& [name, config] : machines) table.rows.push_back({{.text = name}, {.text = machine_words(config)}});
  return table;
}

StudyPage study_page(const std::string& title, const CLI::App& command, const std::set<std::string>& without) {
  return {title, given_again(command, without), page_version()};
}

void check_page_picture(const std::string& option, const PixelRect& pixels) {
  const int width = pixels.x1 - pixels.x0, height = pixels.y1 - pixels.y0;
  if (std::max(width, height) > HtmlDocument::kLongestSide)
    throw ConfigError(fmt::format("{}: found {}x{} pixels, expected sides up to {} (--crop takes a part)", option,
                                  width, height, HtmlDocument::kLongestSide));
}

std::string page_version() { return fmt::format("PipeGS; the sources of its models are {:.12}.", measured_by()); }

void try_page() { html_template(kTemplate); }

void write_page(const std::filesystem::path& file, const StudyPage& page) {
  write_text(file, page.text(html_template(kTemplate)));
}

void PageArgument::add(CLI::App& command) {
  command_ = &command;
  command.add_option("--page", file_, "charts and tables as one HTML file");
}

void PageArgument::check() const {
  if (!wanted()) return;
  try_file("--page", file_);
  try_page();
}

void PageArgument::write(const StudyFindings& findings) const {
  if (!wanted()) return;
  StudyPage made = study_page(findings.title, *command_);
  made.lead(findings.head);
  if (!findings.charts.empty()) made.section("Charts");
  made.charts(findings.charts);
  made.section("Figures");
  for (const Table& table : findings.tables) made.table(table);
  if (!findings.machines.empty()) made.table(machines_table(findings.machines));
  write(made);
}

void PageArgument::write(const StudyPage& page) const {
  if (wanted()) write_page(file_, page);
}

}  // namespace pipegs
