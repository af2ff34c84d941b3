// table.cpp: see table.hpp.
#include "sim/silicon/table.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    else if (c == ',' && !quoted) fields.emplace_back();
    else fields.back() += c;
  }
  return fields;
}

}  // namespace

Config config_of(const std::string& difference) {
  Config config;
  std::stringstream text(difference == "default" ? "" : difference);
  for (std::string setting; std::getline(text, setting, ',');) config_set(config, setting);
  config_check(config);
  return config;
}

void each_line(const std::filesystem::path& csv, const std::string& header, size_t count, const std::function<void(const std::vector<std::string>&)>& visit) {
  std::ifstream file(csv);
  std::string line;
  if (!std::getline(file, line) || line != header) throw InputError(csv.string(), "line 1", "expected " + header);
  for (int number = 2; std::getline(file, line); ++number) {
    const std::vector<std::string> fields = fields_of(line);
    const std::string where = fmt::format("line {}", number);
    if (fields.size() != count) throw InputError(csv.string(), where, fmt::format("expected {} fields, found {}", count, fields.size()));
    try {
      visit(fields);
    } catch (const std::exception& error) {
      throw InputError(csv.string(), where, quote(error.what()));
    }
  }
}

}  // namespace pipegs
