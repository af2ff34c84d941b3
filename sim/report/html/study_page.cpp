// SPDX-License-Identifier: Apache-2.0
// study_page.cpp: see study_page.hpp.
#include "sim/report/html/study_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

Json to_json(const PageCell& cell) {
  Json json = {{"text", cell.text}};
  if (cell.value && std::isfinite(*cell.value)) json["value"] = *cell.value;
  if (!cell.copy.empty()) json["copy"] = cell.copy;
  if (!cell.link.empty()) json["link"] = cell.link;
  return json.size() == 1 ? json["text"] : json;
}

Json to_json(const PageTable& table) {
  Json json = {{"title", table.title}, {"columns", Json::array()}, {"rows", Json::array()}, {"notes", table.notes}};
  // An empty column is left out.
  std::vector<size_t> shown;
  for (size_t k = 0; k < table.columns.size(); ++k) {
    const bool any = std::any_of(table.rows.begin(), table.rows.end(),
                                 [&](const std::vector<PageCell>& row) { return !row[k].text.empty(); });
    if (any || table.rows.empty()) shown.push_back(k);
  }
  for (const size_t k : shown) {
    const PageColumn& column = table.columns[k];
    Json one = {{"name", column.name}};
    if (column.word) one["word"] = true;
    if (column.wrapped) one["long"] = true;
    if (column.copies) one["copy"] = true;
    json["columns"].push_back(std::move(one));
  }
  for (const std::vector<PageCell>& row : table.rows) {
    Json cells = Json::array();
    for (const size_t k : shown) cells.push_back(to_json(row[k]));
    json["rows"].push_back(std::move(cells));
  }
  return json;
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

void StudyPage::table(const PageTable& table) { last("tables").push_back(to_json(table)); }

void StudyPage::printed(const std::string& text) {
  for (const PageTable& one : printed_tables(text)) table(one);
}

void StudyPage::picture(const std::string& caption, const std::string& png, const std::string& id) {
  const std::string file = fmt::format("picture{}", pictures_++);
  document_.add_file(file, png);
  Json json = {{"caption", caption}, {"file", file}};
  if (!id.empty()) json["id"] = id;
  last("pictures").push_back(std::move(json));
}

}  // namespace pipegs
