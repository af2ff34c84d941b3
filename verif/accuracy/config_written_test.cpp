// SPDX-License-Identifier: Apache-2.0
// Against sim/study/accuracy/report: a configuration that --target writes comes back through --config as it was.
#include <gtest/gtest.h>

#include "sim/design/config_file.hpp"
#include "sim/design/design_point.hpp"
#include "sim/study/accuracy/report.hpp"

namespace pipegs {
namespace {

Config read_back(const std::string& text) {
  Config config;
  apply_config_lines(parse_config_text("target.cfg", text), config);
  return config;
}

TEST(ConfigWritten, ComesBackAsItWasWritten) {
  Config config;
  for (const DesignPoint& design_point : design_points()) {
    apply_design_point(design_point, config);
    config.alpha_w = 10;
    EXPECT_EQ(read_back(config_file(config, "a comment")), config);
  }
  EXPECT_EQ(read_back(config_file(Config{}, "nothing")), Config{});
}

}  // namespace
}  // namespace pipegs
