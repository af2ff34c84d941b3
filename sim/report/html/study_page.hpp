// SPDX-License-Identifier: Apache-2.0
// study_page.hpp: the page of a study: sentences, charts, tables whose columns sort, pictures, and the command that
// makes it again, in one HTML file.
//
// Idea    Sections one after the other; what is added belongs to the last one. sim/report/page/study.mjs draws them.
// Rule    A number that is not finite is left out of charts; a table shows the text that it was given.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cpp_model/float/image.hpp"
#include "scenes/check/finding.hpp"
#include "sim/report/chart.hpp"
#include "sim/report/html/document.hpp"
#include "sim/report/table.hpp"

namespace pipegs {

class StudyPage {
 public:
  // `version` says which program wrote it.
  StudyPage(const std::string& title, const std::string& command, const std::string& version);

  void lead(const std::string& sentence);
  void section(const std::string& title);
  void note(const std::string& sentence);
  void findings(const Findings& odd);  // a section of their own; none without one
  void charts(const std::vector<Chart>& charts);
  void table(const Table& table);
  void picture(const std::string& caption, const Rgb8& picture, const std::string& id);

  std::string text(const std::string& html_template) const { return document_.text(html_template); }

 private:
  nlohmann::ordered_json& last(const char* list);

  HtmlDocument document_;
};

}  // namespace pipegs
