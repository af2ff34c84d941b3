// SPDX-License-Identifier: Apache-2.0
// template.cpp: see template.hpp.
#include "sim/report/html/template.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "scenes/own_failure.hpp"

namespace pipegs {

std::string html_template(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(PIPEGS_BUILD_DIR) / "page", log = folder / "build.log",
                              file = folder / (name + ".html");
  std::filesystem::create_directories(folder);
  if (!std::filesystem::exists(file)) fmt::print(stderr, "making the template of the pages ...\n");
  const std::string command =
      fmt::format("'{}/sim/report/page/build.sh' '{}' > '{}' 2>&1", PIPEGS_SOURCE_DIR, folder.string(), log.string());
  if (std::system(command.c_str()) != 0)
    throw OwnFailure(fmt::format("the template of the pages cannot be made: see {}", log.string()));
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in || text.empty()) throw OwnFailure(file.string() + ": cannot read");
  return text;
}

}  // namespace pipegs
