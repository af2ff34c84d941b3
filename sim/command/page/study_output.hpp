// SPDX-License-Identifier: Apache-2.0
// study_output.hpp: what a command that measures has found, on the terminal and in files: --out, --page and --json.
//
// Idea    A page holds all that the command prints, its charts, every machine that was measured as settings for the
//         same commands, and the command line that makes the page again.
// Files   NAME.json, NAME.csv of the first table, and NAME.html with --page, in the folder of --out; NAME is the
//         command's.
// Errors  InputError: a file cannot be written; ConfigError: --page without a folder; OwnFailure: the page's template
//         cannot be made. All before anything is computed.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cpp_model/config.hpp"
#include "cpp_model/float/projection.hpp"
#include "scenes/check/finding.hpp"
#include "sim/command/options.hpp"
#include "sim/report/html/study_page.hpp"

namespace pipegs {

// Machines by name, with buttons that copy their words (machine_words).
using NamedMachines = std::vector<std::pair<std::string, Config>>;
Table machines_table(const NamedMachines& machines);

// The page that `command`'s line makes, without the options that change nothing of it.
StudyPage study_page(const std::string& title, const CLI::App& command,
                     const std::set<std::string>& without = {"--json"});
// Throws ConfigError when a page cannot hold a picture of this size.
void check_page_picture(const std::string& option, const PixelRect& pixels);
// What made a page: one line for its end.
std::string page_version();
// Makes the template, when it must be made.
void try_page();
void write_page(const std::filesystem::path& file, const StudyPage& page);

struct StudyFindings {
  std::string title;
  std::string head;  // scene, view, memory: one line
  std::vector<Chart> charts;
  std::vector<Table> tables;  // the first one has columns
  NamedMachines machines;
  std::string note;                  // in the page above the charts
  std::optional<Findings> odd = {};  // in scene, cameras and frames
};

class StudyOutput {
 public:
  // `folder` is that of --out where it is not given; empty: then no file is written.
  void add(CLI::App& command, const std::string& folder = "");
  const std::string& out() const { return out_; }
  bool json() const { return json_; }
  void check() const;
  // Prints, and writes the files unless `files` is false; charts go into the JSON.
  void write(const StudyFindings& findings, nlohmann::ordered_json json, bool files = true) const;

 private:
  std::string file(const char* extension) const;

  const CLI::App* command_ = nullptr;
  std::string out_;
  bool json_ = false, page_ = false;
};

}  // namespace pipegs
