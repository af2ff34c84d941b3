// SPDX-License-Identifier: Apache-2.0
// study_output.cpp: see study_output.hpp.
#include "sim/command/page/study_output.hpp"

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

std::string StudyOutput::file(const char* extension) const {
  return fmt::format("{}/{}.{}", out_, name_of(*command_), extension);
}

void StudyOutput::add(CLI::App& command, const std::string& folder) {
  command_ = &command;
  out_ = folder;
  const std::string name = name_of(command);
  const Option out =
      add_text(command, "--out", out_, fmt::format("folder for {0}.json, {0}.csv and what is asked for", name));
  if (!folder.empty()) out.shows_default();
  add_flag(command, "--page", page_, fmt::format("{}.html in --out: charts and tables as a page", name));
  add_flag(command, "--json", json_, "print JSON instead of the tables");
}

void StudyOutput::check() const {
  if (page_ && out_.empty()) throw ConfigError("--page: found no --out, expected the folder that takes it");
  if (out_.empty()) return;
  try_folder("--out", out_);
  for (const char* extension : {"json", "csv", "html"}) try_file("--out", file(extension));
  if (page_) try_page();
}

void StudyOutput::write(const StudyFindings& findings, nlohmann::ordered_json json, bool files) const {
  if (findings.odd) json["findings"] = to_json(*findings.odd);
  if (!findings.charts.empty()) json["charts"] = charts_json(findings.charts);
  if (json_) fmt::print("{}\n", json.dump(2));
  else fmt::print("{}\n\n{}", findings.head, tables_text(findings.tables));
  if (out_.empty() || !files) return;
  if (!json_) fmt::print("  files in {}\n", out_);
  write_text(file("json"), json.dump(2) + "\n");
  write_text(file("csv"), table_csv(findings.tables.front()));
  if (!page_) return;
  StudyPage page = study_page(findings.title, *command_);
  page.lead(findings.head);
  page.findings(findings.odd.value_or(Findings()));
  if (!findings.charts.empty()) page.section("Charts");
  if (!findings.note.empty()) page.note(findings.note);
  page.charts(findings.charts);
  page.section("Figures");
  for (const Table& table : findings.tables) page.table(table);
  if (!findings.machines.empty()) page.table(machines_table(findings.machines));
  write_page(file("html"), page);
}

}  // namespace pipegs
