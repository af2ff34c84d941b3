// SPDX-License-Identifier: Apache-2.0
// test_main: main of the GoogleTests; what was skipped does not read as passed.
//
// Seed     Where PIPEGS_DAY is set (.ci/run), random streams are those of that day, as PIPEGS_SEED would make them;
//          what fails then is followed by the line that draws the same again. Figures of pages are those without it.
// Skipped  A line says how many cases were skipped. Where that is all of them, the exit code is 77, which ctest shows
//          as skipped; verif/self/skipped.sh sums up the lines of entries in which others passed.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const char* day = std::getenv("PIPEGS_DAY");
  if (day != nullptr) setenv("PIPEGS_SEED", day, 0);
  const int code = RUN_ALL_TESTS();
  if (day != nullptr && code != 0)
    std::printf("the same draws again: PIPEGS_SEED=%s %s\n", std::getenv("PIPEGS_SEED"), argv[0]);
  const testing::UnitTest& unit = *testing::UnitTest::GetInstance();
  const int skipped = unit.skipped_test_count(), cases = unit.test_to_run_count();
  if (skipped > 0) std::printf("skipped %d of %d cases\n", skipped, cases);
  return code == 0 && skipped > 0 && skipped == cases ? 77 : code;
}
