// SPDX-License-Identifier: Apache-2.0
// Against sim/command/options: what an option takes, and what it refuses, whatever the text.
// Part of readers_checked, so that the sanitizers see it; options_test has the options of each command.
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <random>

#include "sim/command/options.hpp"

namespace pipegs {
namespace {

struct Values {
  uint8_t small = 3;
  int64_t large = 0;
  double real = 0.5;
  std::vector<int> place, span;
  std::vector<std::string> names;
};

// The values that a command line gives, or what is wrong with it.
std::string parse(const std::vector<std::string>& words, Values& values) {
  CLI::App app;
  add_integer(app, "--small", values.small, "");
  add_integer(app, "--large", values.large, "", int64_t{-5});
  add_real(app, "--real", values.real, "", kPositive);
  add_place(app, "--place", values.place, "");
  add_span(app, "--span", values.span, "");
  add_names(app, "--names", values.names, "");
  std::vector<const char*> arguments = {"test"};
  for (const std::string& word : words) arguments.push_back(word.c_str());
  try {
    app.parse(static_cast<int>(arguments.size()), arguments.data());
  } catch (const CLI::ParseError& error) { return error.what(); }
  return "";
}

std::string refused(const std::vector<std::string>& words) {
  Values values;
  return parse(words, values);
}

TEST(ReadOptions, TakesWhatIsMeant) {
  Values values;
  ASSERT_EQ(
      parse({"--small", "255", "--large=-5", "--real", "1e-3", "--place", "3,4", "--span", "0-9", "--names", "b,a"},
            values),
      "");
  EXPECT_EQ(values.small, 255);
  EXPECT_EQ(values.large, -5);
  EXPECT_EQ(values.real, 1e-3);
  EXPECT_EQ(values.place, (std::vector<int>{3, 4}));
  EXPECT_EQ(values.span, (std::vector<int>{0, 9}));
  ASSERT_EQ(parse({"--span", "all"}, values), "");
  EXPECT_EQ(values.span, (std::vector<int>{0, -1}));
  EXPECT_EQ(values.names, (std::vector<std::string>{"b", "a"}));
}

TEST(ReadOptions, SaysWhatItWants) {
  EXPECT_EQ(refused({"--small", "256"}), "--small: found '256', expected an integer from 0 to 255");
  EXPECT_EQ(refused({"--small", "-1"}), "--small: found '-1', expected an integer from 0 to 255");
  EXPECT_EQ(refused({"--real", "0"}), "--real: found '0', expected a number above 0");
  EXPECT_EQ(refused({"--place", "3"}), "--place: found '3', expected COLUMN,ROW");
  EXPECT_EQ(refused({"--place", "3,-1"}), "--place: found '-1', expected an integer from 0 to 2147483647");
  EXPECT_EQ(refused({"--span", "3"}), "--span: found '3', expected FIRST-LAST or all");
  EXPECT_EQ(refused({"--span", "3-2"}), "--span: found '2', expected an integer from 3 to 2147483647");
  EXPECT_EQ(refused({"--span", "-1-2"}), "--span: found '', expected an integer from 0 to 2147483647");
  EXPECT_EQ(refused({"--names", "a,,b"}), "--names: found 'a,,b', expected elements by commas, none of them empty");
  EXPECT_EQ(refused({"--names", "a,b,a"}), "--names: found a second 'a', expected one");
  EXPECT_NE(refused({"--names", "a", "b"}), "");
  EXPECT_NE(refused({"--names", "a", "--names", "b"}), "");
}

TEST(ReadOptions, SurvivesAnyText) {
  std::mt19937 random(7);
  const std::string characters = "0123456789,,..-+ex[]{}\"' \t\n\xe9";
  for (int round = 0; round < 300; ++round) {
    std::string text;
    for (size_t i = random() % 40; i > 0; --i) text += characters[random() % characters.size()];
    for (const char* option : {"--small", "--large", "--real", "--place", "--span", "--names"}) {
      const std::string error = refused({option, text});
      EXPECT_LT(error.size(), 400u) << error;
    }
  }
}

}  // namespace
}  // namespace pipegs
