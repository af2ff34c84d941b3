// config_file.hpp: configuration entries in a file, one `key=value` a line: what --config reads and --target writes.
//
// Rule    `#` begins a comment, blanks around key and value do not count. The first bad line is a ConfigError that names file
//         and line.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cpp_model/config.hpp"

namespace pipegs {

struct ConfigLine {
  std::string setting;  // key=value
  std::string place;    // file:line
};

std::vector<ConfigLine> read_config_file(const std::filesystem::path& path);

// Sets every line's entry; config_check is the caller's.
void apply_config_file(const std::filesystem::path& path, Config& config);

}  // namespace pipegs
