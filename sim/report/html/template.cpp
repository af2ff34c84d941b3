// SPDX-License-Identifier: Apache-2.0
// template.cpp: see template.hpp.
#include "sim/report/html/template.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "scenes/own_failure.hpp"
#include "sim/run_program.hpp"

namespace pipegs {

std::string html_template(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(PIPEGS_BUILD_DIR) / "page", log = folder / "build.log",
                              file = folder / (name + ".html");
  const std::string script = PIPEGS_SOURCE_DIR "/sim/report/page/build.sh";
  require_own_file(script);
  if (run_program({script, folder.string(), "fresh"}) != 0) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    fmt::print(stderr, "making the template of the pages ...\n");
    if (run_program({script, folder.string()}, log) != 0)
      throw OwnFailure(fmt::format("the template of the pages cannot be made: see {}", log.string()));
  }
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in || text.empty()) throw OwnFailure(file.string() + ": cannot read");
  return text;
}

}  // namespace pipegs
