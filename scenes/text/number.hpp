// SPDX-License-Identifier: Apache-2.0
// number: the one way from text to a number, for every file and every option.
//
// Rule    The whole text is the number, or there is none: no blanks, no second sign, nothing behind it. A number
//         outside the caller's range is refused, so nothing wraps (-1 is no unsigned number) and nothing is cut (1.5 is
//         no integer). NaN and infinities are no numbers; only parse_value, for the body of a scene, lets them pass.
// Errors  NumberError: "found 'abc', expected an integer from 6 to 12"; the caller puts file, line and field before it.
// Use     parse_integer<int>(text, 6, 12)    parse_real(text, kPositive)
#pragma once

#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "scenes/text/quote.hpp"

namespace pipegs {

struct NumberError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Which real numbers are meant: low to high, both included unless `above` takes the lowest out.
struct RealRange {
  double low = std::numeric_limits<double>::lowest(), high = std::numeric_limits<double>::max();
  bool above = false;

  bool holds(double value) const { return value >= low && value <= high && !(above && value == low); }  // not NaN

  std::string text() const {
    const auto shown = [](double value) {
      char digits[32];
      std::snprintf(digits, sizeof digits, "%g", value);
      return std::string(digits);
    };
    const bool bottom = low > std::numeric_limits<double>::lowest(), top = high < std::numeric_limits<double>::max();
    std::string text = "a number";
    if (bottom) text += (above ? " above " : " from ") + shown(low);
    if (top) text += (above || !bottom ? " up to " : " to ") + shown(high);
    return text;
  }
};
inline constexpr RealRange kFinite{}, kPositive{.low = 0, .above = true}, kNotNegative{.low = 0};

namespace number_detail {

// A text without its plus sign, which from_chars does not know; one more sign behind it stays, to be refused.
inline std::string_view unsigned_text(std::string_view text) {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+';
  return plus ? text.substr(1) : text;
}

// NaN and infinities included; nothing when it is no number.
inline std::optional<double> real(std::string_view text) {
  const std::string_view digits = unsigned_text(text);
  double value = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) return std::nullopt;
  // Too large is infinite and too small is zero, as in every other reader of decimals.
  return error == std::errc::result_out_of_range ? std::strtod(std::string(digits).c_str(), nullptr) : value;
}

}  // namespace number_detail

template <std::integral T>
T parse_integer(std::string_view text, T low = std::numeric_limits<T>::min(), T high = std::numeric_limits<T>::max()) {
  std::conditional_t<std::is_signed_v<T>, int64_t, uint64_t> value = 0;
  const std::string_view digits = number_detail::unsigned_text(text);
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (error != std::errc{} || stop != end || value < low || value > high) {
    throw NumberError("found " + quote(text) + ", expected an integer from " + std::to_string(low) + " to " +
                      std::to_string(high));
  }
  return static_cast<T>(value);
}

inline double parse_real(std::string_view text, const RealRange& range = kFinite) {
  const std::optional<double> value = number_detail::real(text);
  if (!value || !range.holds(*value)) throw NumberError("found " + quote(text) + ", expected " + range.text());
  return *value;
}

// For values that may be missing or beyond all bounds: NaN, inf and -inf pass, and 1e999 is inf.
inline double parse_value(std::string_view text) {
  const std::optional<double> value = number_detail::real(text);
  if (!value) throw NumberError("found " + quote(text) + ", expected a number");
  return *value;
}

}  // namespace pipegs
