// SPDX-License-Identifier: Apache-2.0
// printed_tables.cpp: see printed_tables.hpp.
#include "sim/report/html/printed_tables.hpp"

#include <algorithm>
#include <cstdlib>

namespace pipegs {
namespace {

constexpr size_t kApart = 2;   // blanks between columns
constexpr size_t kEnough = 6;  // lines that show where columns are though one does not fit
constexpr size_t kLong = 44;   // characters of a word that goes into several lines

// Characters, each of which fills a place: names may hold any.
std::u32string characters(const std::string& text) {
  std::u32string result;
  for (const char byte : text) {
    const auto code = static_cast<unsigned char>(byte);
    if ((code & 0xc0) == 0x80 && !result.empty()) result.back() = result.back() << 8 | code;
    else result += code;
  }
  return result;
}

std::string bytes(const std::u32string& text) {
  std::string result;
  for (const char32_t places : text) {
    for (int shift = 24; shift >= 0; shift -= 8) {
      if (places >> shift != 0) result += static_cast<char>(places >> shift & 0xff);
    }
  }
  return result;
}

std::u32string trimmed(const std::u32string& text) {
  const size_t first = text.find_first_not_of(U' ');
  return first == std::u32string::npos ? U"" : text.substr(first, text.find_last_not_of(U' ') - first + 1);
}

bool has_gap(const std::u32string& text) { return trimmed(text).find(U"  ") != std::u32string::npos; }

struct Stretch {
  size_t from, to;
};

std::u32string part(const std::u32string& line, Stretch stretch) {
  return stretch.from < line.size() ? trimmed(line.substr(stretch.from, stretch.to - stretch.from)) : U"";
}

// Where the columns within `whole` are, with at least `apart` places between them that are blank in all lines.
std::vector<Stretch> columns_of(const std::vector<std::u32string>& lines, Stretch whole, size_t apart) {
  std::vector<Stretch> stretches;
  size_t blanks = apart;
  for (size_t at = whole.from; at < whole.to; ++at) {
    const bool blank = std::all_of(lines.begin(), lines.end(),
                                   [&](const std::u32string& line) { return at >= line.size() || line[at] == U' '; });
    if (blank) {
      ++blanks;
      continue;
    }
    if (blanks >= apart) stretches.push_back({at, at});
    stretches.back().to = at + 1;
    blanks = 0;
  }
  return stretches;
}

// Columns with a single blank between them. A word of the names that no cell stands under belongs to the word at its
// right, unless two blanks are between them.
std::vector<Stretch> near_columns(const std::vector<std::u32string>& lines, Stretch whole) {
  std::vector<Stretch> stretches;
  bool open = false;  // the last one has no cell yet
  for (const Stretch stretch : columns_of(lines, whole, 1)) {
    if (open && lines[0].find_first_not_of(U' ', stretches.back().to) < stretches.back().to + kApart)
      stretches.back().to = stretch.to;
    else stretches.push_back(stretch);
    open = std::all_of(lines.begin() + 1, lines.end(),
                       [&](const std::u32string& line) { return part(line, stretches.back()).empty(); });
  }
  if (!open || stretches.size() < 2) return stretches;
  const size_t to = stretches.back().to;
  stretches.pop_back();
  stretches.back().to = to;
  return stretches;
}

// A column in which words still stand apart is several ones.
std::vector<Stretch> all_columns(const std::vector<std::u32string>& lines) {
  size_t width = 0;
  for (const std::u32string& line : lines) width = std::max(width, line.size());
  std::vector<Stretch> stretches;
  for (const Stretch stretch : columns_of(lines, {0, width}, kApart)) {
    const bool several = std::any_of(lines.begin(), lines.end(),
                                     [&](const std::u32string& line) { return has_gap(part(line, stretch)); });
    const std::vector<Stretch> parts = several ? near_columns(lines, stretch) : std::vector{stretch};
    stretches.insert(stretches.end(), parts.begin(), parts.end());
  }
  return stretches;
}

// Of a line's words most are no numbers: it names the columns.
bool names_columns(const std::u32string& line) {
  const std::vector<Stretch> words = columns_of({line}, {0, line.size()}, kApart);
  const auto count = std::count_if(words.begin(), words.end(), [&](Stretch stretch) {
    return leading_number(bytes(part(line, stretch))).has_value();
  });
  return 2 * static_cast<size_t>(count) < words.size();
}

// Every cell is one: nothing in it stands apart.
bool are_cut(const std::vector<std::u32string>& lines) {
  const std::vector<Stretch> columns = all_columns(lines);
  return std::none_of(lines.begin(), lines.end(), [&](const std::u32string& line) {
    return std::any_of(columns.begin(), columns.end(), [&](Stretch column) { return has_gap(part(line, column)); });
  });
}

// The row but for which all cells would be cut: a cell of it is wider than its column. None: 0, the names' own.
size_t odd_row(const std::vector<std::u32string>& lines) {
  if (lines.size() < kEnough || are_cut(lines)) return 0;
  for (size_t i = 1; i < lines.size(); ++i) {
    std::vector<std::u32string> others = lines;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    if (are_cut(others)) return i;
  }
  return 0;
}

// Of the odd row each word stands in the column over which most of it lies.
std::vector<std::u32string> cells_by_place(const std::u32string& line, const std::vector<Stretch>& columns) {
  std::vector<std::u32string> cells(columns.size());
  for (const Stretch word : columns_of({line}, {0, line.size()}, kApart)) {
    const auto over = [&](size_t k) {
      const size_t from = std::max(word.from, columns[k].from), to = std::min(word.to, columns[k].to);
      return to > from ? to - from : 0;
    };
    size_t best = 0;
    for (size_t k = 1; k < columns.size(); ++k) best = over(k) > over(best) ? k : best;
    cells[best] += (cells[best].empty() ? U"" : U" ") + part(line, word);
  }
  return cells;
}

std::vector<std::vector<std::u32string>> cells_of(const std::vector<std::u32string>& lines) {
  const size_t odd = odd_row(lines);
  std::vector<std::u32string> even = lines;
  if (odd > 0) even.erase(even.begin() + static_cast<std::ptrdiff_t>(odd));
  const std::vector<Stretch> columns = all_columns(even);
  std::vector<std::vector<std::u32string>> rows;
  for (size_t i = 0; i < lines.size(); ++i) {
    std::vector<std::u32string>& row = rows.emplace_back();
    if (odd > 0 && i == odd) row = cells_by_place(lines[i], columns);
    else
      for (const Stretch column : columns) row.push_back(part(lines[i], column));
  }
  return rows;
}

// What a cell is: nothing, a number, a word.
int kind_of(const std::u32string& cell) { return cell.empty() ? 0 : leading_number(bytes(cell)) ? 1 : 2; }

// The first row names the columns, unless numbers stand in it wherever they stand in the second.
bool has_names(const std::vector<std::vector<std::u32string>>& rows) {
  if (rows.size() < 2) return false;
  if (rows[0][0].empty() != rows[1][0].empty()) return true;
  bool number = false;
  for (size_t k = 0; k < rows[0].size(); ++k) {
    if (kind_of(rows[1][k]) == 1 && kind_of(rows[0][k]) != 1) return true;
    number = number || kind_of(rows[1][k]) == 1;
  }
  return !number;
}

Table table_of(const std::string& title, const std::vector<std::u32string>& lines) {
  Table table{.title = title};
  const std::vector<std::vector<std::u32string>> rows = cells_of(lines);
  const size_t first = has_names(rows) ? 1 : 0;
  for (size_t k = 0; k < rows[0].size(); ++k) {
    size_t numbers = 0, words = 0, longest = 0;
    for (size_t i = first; i < rows.size(); ++i) {
      if (rows[i][k].empty() || rows[i][k] == U"-") continue;
      ++(kind_of(rows[i][k]) == 1 ? numbers : words);
      longest = std::max(longest, rows[i][k].size());
    }
    const bool word = words > numbers || k == 0;
    table.columns.push_back(
        {.heading = first > 0 ? bytes(rows[0][k]) : "", .word = word, .wrapped = word && longest > kLong});
  }
  for (size_t i = first; i < rows.size(); ++i) {
    std::vector<TableCell>& row = table.rows.emplace_back();
    for (size_t k = 0; k < rows[i].size(); ++k) {
      const std::string cell = bytes(rows[i][k]);
      row.push_back({.text = cell, .value = table.columns[k].word ? std::nullopt : leading_number(cell)});
    }
  }
  return table;
}

std::vector<std::vector<std::u32string>> blocks_of(const std::string& text) {
  std::vector<std::vector<std::u32string>> blocks(1);
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find('\n', at), text.size());
    const std::u32string line = characters(text.substr(at, end - at));
    if (!trimmed(line).empty()) blocks.back().push_back(line);
    else if (!blocks.back().empty()) blocks.emplace_back();
    at = end + 1;
  }
  if (blocks.back().empty()) blocks.pop_back();
  return blocks;
}

void add_block(const std::vector<std::u32string>& block, std::vector<Table>& tables) {
  std::string title;
  std::vector<std::u32string> lines;
  std::vector<std::string> notes;
  const auto flush = [&] {
    if (!lines.empty()) tables.push_back(table_of(title, lines));
    else if (!title.empty()) notes.insert(notes.begin(), title);
    if (lines.empty() && !notes.empty()) tables.push_back({});
    if (!tables.empty()) tables.back().notes.insert(tables.back().notes.end(), notes.begin(), notes.end());
    title.clear(), lines.clear(), notes.clear();
  };
  for (size_t i = 0; i < block.size(); ++i) {
    if (has_gap(block[i])) {
      lines.push_back(block[i]);
      continue;
    }
    const std::string sentence = bytes(trimmed(block[i]));
    const bool above = i + 1 < block.size() && has_gap(block[i + 1]);
    if (above && (lines.empty() || names_columns(block[i + 1]))) {
      flush();
      title = sentence;
    } else {
      notes.push_back(sentence);
    }
  }
  flush();
}

}  // namespace

std::optional<double> leading_number(const std::string& cell) {
  const size_t first = cell.find_first_not_of("~<> ");
  if (first == std::string::npos) return std::nullopt;
  const size_t digit = cell.find_first_not_of("+-", first);
  if (digit == std::string::npos || digit > first + 1) return std::nullopt;
  if (cell[digit] < '0' || cell[digit] > '9') return std::nullopt;
  // Not "1: what follows" or "8x8", but "12 %", "4.09x" and "3 (2 to 4)".
  char* end = nullptr;
  const double value = std::strtod(cell.c_str() + (cell[first] == '+' ? first + 1 : first), &end);
  return value;
}

std::vector<Table> printed_tables(const std::string& text) {
  std::vector<Table> tables;
  for (const std::vector<std::u32string>& block : blocks_of(text)) add_block(block, tables);
  return tables;
}

}  // namespace pipegs
