// SPDX-License-Identifier: Apache-2.0
// table.cpp: see table.hpp.
#include "sim/report/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "scenes/text/csv.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;
using Texts = std::vector<std::string>;

std::string head_text(const TableColumn& column) {
  if (column.unit.empty() || column.heading.empty()) return column.heading + column.unit;
  return column.heading + ", " + column.unit;
}

std::vector<size_t> shown_columns(const Table& table) {
  std::vector<size_t> shown;
  for (size_t k = 0; k < table.columns.size(); ++k) {
    const bool any = std::any_of(table.rows.begin(), table.rows.end(), [&](const std::vector<TableCell>& row) {
      return !cell_text(row[k], table.columns[k]).empty();
    });
    if (any || table.rows.empty()) shown.push_back(k);
  }
  return shown;
}

Texts heads_of(const Table& table, const std::vector<size_t>& shown) {
  Texts heads;
  for (const size_t k : shown) heads.push_back(head_text(table.columns[k]));
  return heads;
}

Texts texts_of(const Table& table, const std::vector<TableCell>& row, const std::vector<size_t>& shown) {
  Texts texts;
  for (const size_t k : shown) texts.push_back(cell_text(row[k], table.columns[k]));
  return texts;
}

// Places that a text fills in a terminal: one for each character, of however many bytes.
size_t places(const std::string& text) {
  return static_cast<size_t>(std::count_if(
      text.begin(), text.end(), [](char byte) { return (static_cast<unsigned char>(byte) & 0xc0) != 0x80; }));
}

constexpr size_t kLongestLine = 120, kLeastRoom = 40;  // places

// A long text in lines of at most so many places, broken at blanks.
Texts lines_of_text(const std::string& text, size_t room) {
  Texts lines = {""};
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    if (!lines.back().empty() && places(lines.back()) + 1 + places(word) > room) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
    at = end + 1;
  }
  return lines;
}

Json cell_json(const TableCell& cell, const TableColumn& column) {
  Json json = {{"text", cell_text(cell, column)}};
  if (cell.value && std::isfinite(*cell.value)) json["value"] = *cell.value;
  if (!cell.copy.empty()) json["copy"] = cell.copy;
  if (!cell.link.empty()) json["link"] = cell.link;
  return json.size() == 1 ? json["text"] : json;
}

}  // namespace

TableCell number_cell(double value, const std::string& mark) { return {.value = value, .mark = mark}; }
TableCell text_cell(const std::string& text) { return {.text = text}; }

std::string cell_text(const TableCell& cell, const TableColumn& column) {
  if (!cell.text.empty() || !cell.value) return cell.text;
  return fmt::format("{}{:.{}f}", cell.mark, *cell.value, column.digits);
}

std::string table_text(const Table& table) {
  const std::vector<size_t> shown = shown_columns(table);
  std::vector<Texts> lines;
  const Texts heads = heads_of(table, shown);
  if (std::any_of(heads.begin(), heads.end(), [](const std::string& head) { return !head.empty(); }))
    lines.push_back(heads);
  for (const std::vector<TableCell>& row : table.rows) lines.push_back(texts_of(table, row, shown));
  std::vector<size_t> widths(shown.size());
  for (const Texts& line : lines) {
    for (size_t k = 0; k < line.size(); ++k) widths[k] = std::max(widths[k], places(line[k]));
  }
  std::string text = table.title.empty() ? "" : "  " + table.title + "\n";
  size_t before = 2 * shown.size();  // places before the last column
  for (size_t k = 0; k + 1 < widths.size(); ++k) before += widths[k];
  const bool wraps = !shown.empty() && table.columns[shown.back()].wrapped && before + kLeastRoom <= kLongestLine;
  for (const Texts& line : lines) {
    std::string one;
    for (size_t k = 0; k < line.size(); ++k) {
      const std::string blanks(widths[k] - places(line[k]), ' ');
      if (wraps && k + 1 == line.size()) {
        const std::string next = "\n" + std::string(before, ' ');
        one += fmt::format("  {}", fmt::join(lines_of_text(line[k], kLongestLine - before), next));
      } else {
        one += "  " + (table.columns[shown[k]].word ? line[k] + blanks : blanks + line[k]);
      }
    }
    text += one.substr(0, one.find_last_not_of(' ') + 1) + "\n";
  }
  for (const std::string& note : table.notes) text += "  " + note + "\n";
  return text;
}

std::string tables_text(const std::vector<Table>& tables) {
  std::string text;
  for (const Table& table : tables) text += (text.empty() ? "" : "\n") + table_text(table);
  return text;
}

std::string table_csv(const Table& table) {
  std::string text;
  for (const TableColumn& column : table.columns) text += (text.empty() ? "" : ",") + csv_field(column.key);
  text += "\n";
  for (const std::vector<TableCell>& row : table.rows) {
    for (size_t k = 0; k < row.size(); ++k) {
      const std::string cell = row[k].value ? fmt::format("{}", *row[k].value) : csv_field(row[k].text);
      text += (k == 0 ? "" : ",") + cell;
    }
    text += "\n";
  }
  return text;
}

Json table_json(const Table& table) {
  Json json = {{"title", table.title}, {"columns", Json::array()}, {"rows", Json::array()}, {"notes", table.notes}};
  const std::vector<size_t> shown = shown_columns(table);
  for (const size_t k : shown) {
    const TableColumn& column = table.columns[k];
    Json one = {{"name", head_text(column)}};
    if (column.word) one["word"] = true;
    if (column.wrapped) one["long"] = true;
    if (column.copies) one["copy"] = true;
    json["columns"].push_back(std::move(one));
  }
  for (const std::vector<TableCell>& row : table.rows) {
    Json cells = Json::array();
    for (const size_t k : shown) cells.push_back(cell_json(row[k], table.columns[k]));
    json["rows"].push_back(std::move(cells));
  }
  return json;
}

}  // namespace pipegs
