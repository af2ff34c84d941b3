// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/accuracy/report: a configuration that --target writes comes back through --config as it was.
#include <gtest/gtest.h>

#include "sim/design/config_file.hpp"
#include "sim/design/design_point.hpp"
#include "sim/studies/accuracy/report.hpp"

namespace pipegs {
namespace {

// Whatever the machine to which the lines are added.
TEST(ConfigWritten, ComesBackAsItWasWritten) {
  for (const DesignPoint& design_point : design_points()) {
    Config written = design_point.config;
    written.alpha_w = 11;
    for (const DesignPoint& other : design_points()) {
      Config config = other.config;
      apply_config_lines(parse_config_text("target.cfg", config_file(written, "a comment")), config);
      EXPECT_EQ(config, written) << design_point.name << " on " << other.name;
    }
  }
}

}  // namespace
}  // namespace pipegs
