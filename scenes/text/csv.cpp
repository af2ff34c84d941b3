// SPDX-License-Identifier: Apache-2.0
// csv: see csv.hpp.
#include "scenes/text/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "scenes/input_error.hpp"
#include "scenes/text/text_file.hpp"

namespace pipegs {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 26;

// One field from the front of `rest`, which then begins behind its comma, or is done.
std::string take_field(std::string_view& rest, bool& done) {
  std::string field;
  if (rest.starts_with('"')) {
    for (;;) {
      const std::size_t end = rest.find('"', 1);
      if (end == std::string_view::npos) throw std::runtime_error("found a quote that does not end");
      field += rest.substr(1, end - 1);
      rest.remove_prefix(end + 1);
      if (!rest.starts_with('"')) break;
      field += '"';
    }
  } else {
    const std::size_t end = std::min(rest.find(','), rest.size());
    field = rest.substr(0, end);
    rest.remove_prefix(end);
    if (field.find('"') != std::string::npos) throw std::runtime_error("found a quote inside of a field");
  }
  done = rest.empty();
  if (!done && rest[0] != ',') throw std::runtime_error("found text behind a quoted field, expected a comma");
  if (!done) rest.remove_prefix(1);
  return field;
}

std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields;
  for (bool done = false; !done;) fields.push_back(take_field(line, done));
  return fields;
}

}  // namespace

CsvRow::CsvRow(std::string_view file, int line, const std::vector<std::string>& columns,
               std::vector<std::string> fields)
    : file_(file), line_(line), columns_(columns), fields_(std::move(fields)) {}

const std::string& CsvRow::text(std::string_view column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end()) throw std::invalid_argument("csv: no column " + std::string(column));
  return fields_[static_cast<std::size_t>(found - columns_.begin())];
}

double CsvRow::real(std::string_view column, const RealRange& range) const {
  try {
    return parse_real(text(column), range);
  } catch (const NumberError& error) { fail(column, error.what()); }
}

void CsvRow::fail(std::string_view column, std::string_view what) const {
  throw InputError(file_, fmt::format("line {}, {}", line_, column), what);
}

void parse_csv(std::string_view file, std::string_view text, std::string_view header, const CsvVisit& visit) {
  const std::vector<std::string> columns = fields_of(header);
  bool has_header = false;
  int number = 0;
  for (const std::string_view line : lines_of(text)) {
    const std::string where = fmt::format("line {}", ++number);
    if (line.starts_with('#')) continue;
    if (!has_header) {
      if (line != header) throw InputError(file, where, fmt::format("found {}, expected {}", quote(line), header));
      has_header = true;
      continue;
    }
    try {
      std::vector<std::string> fields = fields_of(line);
      if (fields.size() != columns.size())
        throw InputError(file, where, fmt::format("found {} fields, expected {}", fields.size(), columns.size()));
      visit(CsvRow(file, number, columns, std::move(fields)));
    } catch (const InputError&) { throw; } catch (const std::runtime_error& error) {
      throw InputError(file, where, error.what());
    }
  }
  if (!has_header) throw InputError(file, "", fmt::format("found no header, expected {}", header));
}

void read_csv(const std::filesystem::path& path, std::string_view header, const CsvVisit& visit) {
  parse_csv(path.string(), read_text_file(path, "a table", kMostBytes), header, visit);
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n#") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char one : text) quoted += one == '"' ? std::string("\"\"") : std::string(1, one);
  return quoted + "\"";
}

}  // namespace pipegs
