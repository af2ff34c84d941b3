// SPDX-License-Identifier: Apache-2.0
// table.hpp: what was found, as a table; the one road from figures to the terminal, files and pages.
//
// Idea    Who measures fills a Table and knows nothing of where it goes; one writer for each place prints it.
// Rule    A cell shows its text, or else its number with its column's digits. A column in which no cell shows anything
//         is left out where people read: in text and pages. CSV has all columns, by key.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace pipegs {

struct TableCell {
  std::string text = {};             // what it shows, if not its number
  std::optional<double> value = {};  // its number: by it a page sorts; without one, by the text
  std::string mark = {};             // stands before the number, such as "~"
  std::string copy = {};             // in a column that copies: what its button copies, if not the text
  std::string link = {};             // the id of a place in the page
};

struct TableColumn {
  std::string key = {};  // names the column in CSV
  std::string heading = {};
  std::string unit = {};
  int digits = 0;        // behind the point
  bool word = false;     // stands left
  bool wrapped = false;  // long text in several lines: in a page where it must, on a terminal in the last column
  bool copies = false;   // has buttons in a page
};

struct Table {
  std::string title = {};
  std::vector<TableColumn> columns = {};  // none: title and notes are all there is
  std::vector<std::vector<TableCell>> rows = {};
  std::vector<std::string> notes = {};  // beneath
};

TableCell number_cell(double value, const std::string& mark = "");
TableCell text_cell(const std::string& text);
// What the cell shows in its column.
std::string cell_text(const TableCell& cell, const TableColumn& column);

// For a terminal: two blanks before and between columns.
std::string table_text(const Table& table);
// With an empty line between tables.
std::string tables_text(const std::vector<Table>& tables);
// Rows only; numbers in full, a mark is left out.
std::string table_csv(const Table& table);
// As sim/report/page/table.mjs reads it.
nlohmann::ordered_json table_json(const Table& table);

}  // namespace pipegs
