// SPDX-License-Identifier: Apache-2.0
// config_file.cpp: see config_file.hpp.
#include "sim/design/config_file.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <map>

#include "scenes/input_error.hpp"
#include "scenes/text/text_file.hpp"

namespace pipegs {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 20;  // a hundred entries and their comments

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

}  // namespace

std::vector<ConfigLine> parse_config_text(const std::string& file, std::string_view text) {
  std::vector<ConfigLine> lines;
  std::map<std::string_view, int> first_lines;  // of each key
  int number = 0;
  for (const std::string_view line : lines_of(text)) {
    ++number;
    const std::string_view entry = trimmed(line.substr(0, line.find('#')));
    if (entry.empty()) continue;
    const std::string place = one_line(fmt::format("{}:{}", file, number));
    const std::size_t equals = entry.find('=');
    if (equals == std::string_view::npos)
      throw ConfigError(fmt::format("{}: {}: expected key=value", place, quote(entry)));
    const std::string_view key = trimmed(entry.substr(0, equals)), value = trimmed(entry.substr(equals + 1));
    const auto [first, is_new] = first_lines.try_emplace(key, number);
    if (!is_new) {
      throw ConfigError(fmt::format("{}: found a second {}, the first is in line {}, expected one", place, quote(key),
                                    first->second));
    }
    lines.push_back({fmt::format("{}={}", key, value), place});
  }
  return lines;
}

std::vector<ConfigLine> read_config_file(const std::filesystem::path& path) {
  std::string text;
  try {
    text = read_text_file(path, "a configuration file", kMostBytes);
  } catch (const InputError& error) { throw ConfigError(fmt::format("--config {}", error.what())); }
  return parse_config_text(path.string(), text);
}

void apply_setting(std::string_view setting, Config& config) {
  Config alone;
  config_set(alone, setting);
  const std::string_view key = setting.substr(0, setting.find('='));
  for (const ConfigEntry& entry : config_entries(Config{})) {
    if (entry.member != nullptr && entry.name == key) config.*entry.member = alone.*entry.member;
  }
}

void apply_config_lines(const std::vector<ConfigLine>& lines, Config& config) {
  for (const ConfigLine& line : lines) {
    try {
      apply_setting(line.setting, config);
    } catch (const ConfigError& error) {
      std::string what = error.what();
      if (what.starts_with("--set ")) what.erase(0, 6);
      if (what.starts_with("--set: ")) what.erase(0, 7);
      throw ConfigError(fmt::format("{}: {}", line.place, what));
    }
  }
}

void apply_config_file(const std::filesystem::path& path, Config& config) {
  apply_config_lines(read_config_file(path), config);
}

}  // namespace pipegs
