// SPDX-License-Identifier: Apache-2.0
// study_page.cpp: see study_page.hpp.
#include "sim/report/html/study_page.hpp"

#include <fmt/format.h>

#include "sim/report/finite.hpp"
#include "sim/report/html/printed_tables.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(finite_json(value));
  return list;
}

const char* name_of(Chart::Form form) {
  switch (form) {
    case Chart::Form::kBars: return "bars";
    case Chart::Form::kStacked: return "stacked";
    case Chart::Form::kLines: return "lines";
    case Chart::Form::kHistogram: return "histogram";
    case Chart::Form::kScatter: return "scatter";
  }
  return "";
}

}  // namespace

Json chart_json(const Chart& chart) {
  Json json = {{"form", name_of(chart.form)}, {"title", chart.title},           {"x_label", chart.x_label},
               {"y_label", chart.y_label},    {"categories", chart.categories}, {"x", numbers(chart.x)},
               {"log_x", chart.log_x},        {"log_y", chart.log_y},           {"from_zero", chart.from_zero},
               {"note", chart.note},          {"series", Json::array()}};
  for (const Series& series : chart.series) {
    Json one = {{"name", series.name}, {"values", numbers(series.values)}, {"outlined", series.outlined}};
    if (chart.form == Chart::Form::kScatter) {
      one.update({{"x", numbers(series.x)}, {"labels", series.labels}, {"named", series.named}});
      if (!series.copies.empty()) one["copies"] = series.copies;
    }
    json["series"].push_back(std::move(one));
  }
  return json;
}

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

void StudyPage::charts(const std::vector<Chart>& charts) {
  for (const Chart& chart : charts) last("charts").push_back(chart_json(chart));
}

void StudyPage::table(const Table& table) { last("tables").push_back(table_json(table)); }

void StudyPage::printed(const std::string& text) {
  for (const Table& one : printed_tables(text)) table(one);
}

void StudyPage::picture(const std::string& caption, const std::string& png, const std::string& id) {
  const std::string file = fmt::format("picture{}", pictures_++);
  document_.add_file(file, png);
  Json json = {{"caption", caption}, {"file", file}};
  if (!id.empty()) json["id"] = id;
  last("pictures").push_back(std::move(json));
}

}  // namespace pipegs
