// SPDX-License-Identifier: Apache-2.0
// config_file.hpp: configuration entries in a file, one `key=value` a line: what --config reads and --target writes.
//
// Rule    `#` begins a comment; blanks before and behind a key and a value do not count. A key comes once.
// Errors  ConfigError that names file and line of the first bad line.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "cpp_model/config.hpp"

namespace pipegs {

struct ConfigLine {
  std::string setting;  // key=value
  std::string place;    // file:line
};

std::vector<ConfigLine> read_config_file(const std::filesystem::path& path);
// The same of a text; `file` is its name in places and errors.
std::vector<ConfigLine> parse_config_text(const std::string& file, std::string_view text);

// As config_set, which looks at all derived entries of the configuration before: those of one that config_check would
// refuse may not be computable. So it is set in one that is whole, and taken over.
void apply_setting(std::string_view setting, Config& config);
// Sets every line's entry; config_check is the caller's.
void apply_config_lines(const std::vector<ConfigLine>& lines, Config& config);
void apply_config_file(const std::filesystem::path& path, Config& config);

}  // namespace pipegs
