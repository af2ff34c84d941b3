// table.hpp: tables of synth/: lines of fields with commas between, a field in quotes may hold some.
//
// Errors  InputError names the file, the line and what was expected, whatever the visitor throws.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "cpp_model/config.hpp"

namespace pipegs {

// Calls visit with the fields of every line behind the header.
void each_line(const std::filesystem::path& csv, const std::string& header, size_t fields, const std::function<void(const std::vector<std::string>&)>& visit);

// The configuration that config_difference has named.
Config config_of(const std::string& difference);

}  // namespace pipegs
