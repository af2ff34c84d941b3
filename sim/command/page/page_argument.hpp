// SPDX-License-Identifier: Apache-2.0
// page_argument.hpp: --page FILE of the commands that measure: what they found as one HTML file.
//
// Idea    A page holds all that the command prints, its charts, every machine that was measured as settings for the
//         same commands, and the command line that makes the page again.
// Errors  InputError: the file cannot be written; OwnFailure: the template cannot be made. Both before anything is
//         computed.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cpp_model/config.hpp"
#include "cpp_model/float/projection.hpp"
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
  std::vector<Table> tables = {};
  NamedMachines machines;
};

class PageArgument {
 public:
  void add(CLI::App& command);
  bool wanted() const { return !file_.empty(); }
  // These do nothing without --page.
  void check() const;
  void write(const StudyFindings& findings) const;
  void write(const StudyPage& page) const;

 private:
  const CLI::App* command_ = nullptr;
  std::string file_;
};

}  // namespace pipegs
