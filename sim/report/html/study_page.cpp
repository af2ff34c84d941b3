// SPDX-License-Identifier: Apache-2.0
// study_page.cpp: see study_page.hpp.
#include "sim/report/html/study_page.hpp"

namespace pipegs {

using Json = nlohmann::ordered_json;

StudyPage::StudyPage(const std::string& title, const std::string& command, const std::string& version)
    : document_("study", title, command) {
  document_.data["version"] = version;
  document_.data["lead"] = Json::array();
  document_.data["sections"] = Json::array();
}

Json& StudyPage::last(const char* list) {
  if (document_.data["sections"].empty()) section("What was found");
  return document_.data["sections"].back()[list];
}

void StudyPage::lead(const std::string& sentence) { document_.data["lead"].push_back(sentence); }

void StudyPage::section(const std::string& title) { document_.data["sections"].push_back({{"title", title}}); }

void StudyPage::note(const std::string& sentence) { last("notes").push_back(sentence); }

void StudyPage::findings(const Findings& odd) {
  if (!odd.empty()) section("What is odd in scene, cameras and frames");
  for (const Finding& finding : odd) note(finding_line(finding));
}

void StudyPage::charts(const std::vector<Chart>& charts) {
  for (Json& chart : charts_json(charts)) last("charts").push_back(std::move(chart));
}

void StudyPage::table(const Table& table) { last("tables").push_back(table_json(table)); }

void StudyPage::picture(const std::string& caption, const Rgb8& picture, const std::string& id) {
  document_.add_plane(id, picture.width, picture.height, 3, picture.data);
  last("pictures").push_back({{"caption", caption}, {"id", id}});
}

}  // namespace pipegs
