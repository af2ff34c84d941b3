// config_file.cpp: see config_file.hpp.
#include "sim/config_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace pipegs {
namespace {

std::string without_blanks(std::string text) {
  std::erase_if(text, [](unsigned char c) { return c == ' ' || c == '\t' || c == '\r'; });
  return text;
}

}  // namespace

std::vector<ConfigLine> read_config_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path)) throw ConfigError(fmt::format("--config {}: cannot be read", path.string()));
  std::vector<ConfigLine> lines;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    const std::string setting = without_blanks(line.substr(0, line.find('#')));
    if (!setting.empty()) lines.push_back({setting, fmt::format("{}:{}", path.string(), number)});
  }
  return lines;
}

void apply_config_file(const std::filesystem::path& path, Config& config) {
  for (const ConfigLine& line : read_config_file(path)) {
    try {
      config_set(config, line.setting);
    } catch (const ConfigError& error) {
      std::string what = error.what();
      if (what.starts_with("--set ")) what.erase(0, 6);
      if (what.starts_with("--set: ")) what.erase(0, 7);
      throw ConfigError(fmt::format("{}: {}", line.place, what));
    }
  }
}

}  // namespace pipegs
