// SPDX-License-Identifier: Apache-2.0
// Against scenes/text/number: a text is a number as a whole, within its range, or it is refused with what was expected.
#include "scenes/text/number.hpp"

#include <gtest/gtest.h>

namespace pipegs {
namespace {

template <typename Parse>
std::string refused(const Parse& parse) {
  try {
    parse();
  } catch (const NumberError& error) { return error.what(); }
  return "accepted";
}

TEST(Number, IntegersAreReadWhole) {
  EXPECT_EQ(parse_integer<int>("12"), 12);
  EXPECT_EQ(parse_integer<int>("-12"), -12);
  EXPECT_EQ(parse_integer<int>("+12"), 12);
  EXPECT_EQ(parse_integer<int>("007"), 7);
  EXPECT_EQ(parse_integer<uint64_t>("18446744073709551615"), ~uint64_t{0});
  EXPECT_EQ(parse_integer<int64_t>("-9223372036854775808"), std::numeric_limits<int64_t>::min());
  EXPECT_EQ(parse_integer<uint8_t>("255"), 255);
  EXPECT_EQ(parse_integer<int>("6", 6, 12), 6);
  EXPECT_EQ(parse_integer<int>("12", 6, 12), 12);
}

TEST(Number, WhatIsNoIntegerIsRefused) {
  for (const char* text : {"",    "+",   "-",   "++1",  "+-1", "-+1", "--1", " 1", "1 ", "1 0",
                           "1\t", "1.0", "1e2", "0x10", "1,5", "one", "1a",  "5",  "13", "99999999999999999999",
                           "nan", "inf"}) {
    EXPECT_EQ(refused([&] { parse_integer<int>(text, 6, 12); }),
              "found " + quote(text) + ", expected an integer from 6 to 12");
  }
  EXPECT_NE(refused([] { parse_integer<int>(std::string_view("8\0", 2), 6, 12); }), "accepted");
}

TEST(Number, NothingWraps) {
  for (const char* text : {"-1", "-0", "-18446744073709551615", "18446744073709551616"})
    EXPECT_NE(refused([&] { parse_integer<uint64_t>(text); }), "accepted") << text;
  EXPECT_NE(refused([] { parse_integer<uint8_t>("256"); }), "accepted");
  EXPECT_NE(refused([] { parse_integer<int8_t>("128"); }), "accepted");
  EXPECT_NE(refused([] { parse_integer<int>("2147483648"); }), "accepted");
  EXPECT_NE(refused([] { parse_integer<int>("4294967297"); }), "accepted");
}

TEST(Number, RealsAreReadWholeToTheLastBit) {
  EXPECT_EQ(parse_real("1"), 1.0);
  EXPECT_EQ(parse_real("-.5"), -0.5);
  EXPECT_EQ(parse_real("+2.5e-3"), 2.5e-3);
  EXPECT_EQ(parse_real("0.1"), 0.1);
  EXPECT_EQ(parse_real("1.7976931348623157e308"), std::numeric_limits<double>::max());
  EXPECT_EQ(parse_real("5e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(parse_real("1e-400"), 0.0);
  EXPECT_EQ(parse_real(std::string(600, '0') + "7"), 7.0);
}

TEST(Number, WhatIsNoRealIsRefused) {
  for (const char* text :
       {"",      "+",  "-",  ".",   "e5",   "++1", "+-1", "--1",  " 1",       "1 ",    "1 .5",   "1.5.", "1,5",
        "0x1p3", "1e", "1f", "nan", "-nan", "NAN", "inf", "-inf", "infinity", "1e999", "-1e999", "one"}) {
    EXPECT_EQ(refused([&] { parse_real(text); }), "found " + quote(text) + ", expected a number");
  }
}

TEST(Number, RealsKeepToTheirRange) {
  EXPECT_EQ(parse_real("0", kNotNegative), 0.0);
  EXPECT_EQ(parse_real("0.25", {0.25, 0.75}), 0.25);
  EXPECT_EQ(refused([] { parse_real("0", kPositive); }), "found '0', expected a number above 0");
  EXPECT_EQ(refused([] { parse_real("-0", kPositive); }), "found '-0', expected a number above 0");
  EXPECT_EQ(refused([] { parse_real("-1e-9", kNotNegative); }), "found '-1e-9', expected a number from 0");
  EXPECT_EQ(refused([] { parse_real("2", {0.25, 0.75}); }), "found '2', expected a number from 0.25 to 0.75");
  EXPECT_EQ(refused([] { parse_real("2", {0, 1, true}); }), "found '2', expected a number above 0 up to 1");
  EXPECT_EQ(refused([] { parse_real("2", {.high = 1}); }), "found '2', expected a number up to 1");
}

TEST(Number, OnlyValuesMayBeBeyondAllBounds) {
  EXPECT_TRUE(std::isnan(parse_value("nan")));
  EXPECT_EQ(parse_value("-inf"), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_value("1e999"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_value("+3"), 3.0);
  for (const char* text : {"", "+-3", "3 ", "nanx", "infin", "three"})
    EXPECT_EQ(refused([&] { parse_value(text); }), "found " + quote(text) + ", expected a number");
}

TEST(Number, MessagesStayShortAndOnOneLine) {
  const std::string message = refused([] { parse_integer<int>("1\n2" + std::string(1 << 20, 'x')); });
  EXPECT_LT(message.size(), 200u);
  EXPECT_NE(message.find("'1?2xxx"), std::string::npos) << message;
}

}  // namespace
}  // namespace pipegs
