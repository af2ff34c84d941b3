// SPDX-License-Identifier: Apache-2.0
// csv: the one reader of tables: the header, then rows of as many fields as it names.
//
// Rule    The header is exactly the caller's. A line that begins with `#` is a comment. A field is bare or in quotes,
//         where a comma is a comma and "" a quote; nothing stands beside the quotes. A row has the fields of the
//         header: a blank line is none. Numbers are read by number.hpp.
// Errors  InputError with file, line and column; what the visitor throws as std::runtime_error gets file and line.
#pragma once

#include <concepts>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/text/number.hpp"

namespace pipegs {

class CsvRow {
 public:
  CsvRow(std::string_view file, int line, const std::vector<std::string>& columns, std::vector<std::string> fields);

  const std::string& text(std::string_view column) const;

  template <std::integral T>
  T integer(std::string_view column, T low = std::numeric_limits<T>::min(),
            T high = std::numeric_limits<T>::max()) const {
    try {
      return parse_integer<T>(text(column), low, high);
    } catch (const NumberError& error) { fail(column, error.what()); }
  }
  double real(std::string_view column, const RealRange& range = kFinite) const;

  [[noreturn]] void fail(std::string_view column, std::string_view what) const;

 private:
  std::string_view file_;
  int line_;
  const std::vector<std::string>& columns_;
  std::vector<std::string> fields_;
};

using CsvVisit = std::function<void(const CsvRow&)>;

void read_csv(const std::filesystem::path& path, std::string_view header, const CsvVisit& visit);
// The same of a text; `file` is its name in errors.
void parse_csv(std::string_view file, std::string_view text, std::string_view header, const CsvVisit& visit);

// A field as the reader takes it: in quotes where bare it would be read otherwise.
std::string csv_field(const std::string& text);

}  // namespace pipegs
