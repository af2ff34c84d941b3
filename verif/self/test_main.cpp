// SPDX-License-Identifier: Apache-2.0
// test_main: main of the GoogleTests; what was skipped does not read as passed.
//
// A line says how many cases were skipped. Where that is all of them, the exit code is 77, which ctest shows as
// skipped; verif/self/skipped.sh sums up the lines of entries in which others passed.
#include <gtest/gtest.h>

#include <cstdio>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const int code = RUN_ALL_TESTS();
  const testing::UnitTest& unit = *testing::UnitTest::GetInstance();
  const int skipped = unit.skipped_test_count(), cases = unit.test_to_run_count();
  if (skipped > 0) std::printf("skipped %d of %d cases\n", skipped, cases);
  return code == 0 && skipped > 0 && skipped == cases ? 77 : code;
}
