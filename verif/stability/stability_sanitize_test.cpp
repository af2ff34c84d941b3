// SPDX-License-Identifier: Apache-2.0
// The golden model under the sanitizer: no report, and the same bits as the optimised build (T28 of
// docs/numerics/stability.md).
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "verif/stability/support/pixel_hash.hpp"

namespace pipegs {
namespace {

TEST(Stability, T28_TheSameBitsWhateverTheCompilerDoes) {
  constexpr int kScenes = 60;
  const std::string command = "'" PIPEGS_SANITIZED "' " + std::to_string(kScenes) + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  std::string said;
  for (char text[256]; std::fgets(text, sizeof text, pipe) != nullptr;) said += text;
  EXPECT_EQ(pclose(pipe), 0) << said;
  char expected[32];
  std::snprintf(expected, sizeof expected, "%016llx\n", static_cast<unsigned long long>(hostile_hash(kScenes)));
  EXPECT_EQ(said, expected);
}

}  // namespace
}  // namespace pipegs
