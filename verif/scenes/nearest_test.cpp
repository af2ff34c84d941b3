// SPDX-License-Identifier: Apache-2.0
// nearest_test: the word that somebody may have meant.
#include "scenes/text/nearest.hpp"

#include <gtest/gtest.h>

namespace pipegs {
namespace {

const std::vector<std::string> kKnown = {"units", "alpha_w", "alpha_lines", "fetch_lines", "late"};

TEST(Nearest, OneLetterIsWrongLeftOutOrTooMany) {
  for (const char* word : {"unitz", "unts", "xunits", "nuits", "UNITS", "units"})
    EXPECT_EQ(nearest_word(word, kKnown), "units") << word;
  EXPECT_EQ(nearest_word("alphaw", kKnown), "alpha_w");
  EXPECT_EQ(nearest_word("lat", kKnown), "late");
}

TEST(Nearest, APartOfAWordIsNear) {
  EXPECT_EQ(nearest_word("lines", kKnown), "alpha_lines");  // `late` is three letters away
  EXPECT_EQ(nearest_word("fetch", kKnown), "fetch_lines");
}

TEST(Nearest, AnyWordIsNearToSomething) {
  EXPECT_EQ(nearest_word("", kKnown), "late");
  EXPECT_NE(nearest_word(std::string(1000000, 'x'), kKnown), "");
  EXPECT_EQ(nearest_word("units", {}), "");
}

}  // namespace
}  // namespace pipegs
