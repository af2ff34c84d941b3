// SPDX-License-Identifier: Apache-2.0
// json: reading and writing JSON that others wrote or will read.
//
// Rule    Of a text: one value and nothing behind it, valid UTF-8, at most kMostNested brackets inside each other (who
//         walks through or prints a value calls itself for each), each key once in its object, no more values than
//         kMostJsonMemory holds. Reading takes time with the length of the text. Numbers: finite, in the caller's
//         range, and an integer where one is meant.
// Writer  json_text never fails: bytes that are no UTF-8 (file names in Latin-1) become U+FFFD.
// Errors  InputError of the file with line and column, or the place inside, such as [3].rotation[0]; NumberError of a
//         number, before which the caller puts file and field.
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "scenes/text/number.hpp"

namespace pipegs {

inline constexpr int kMostNested = 64;
inline constexpr std::uint64_t kMostJsonBytes = std::uint64_t{1} << 26, kMostJsonMemory = std::uint64_t{1} << 29;

// Json is nlohmann::json or nlohmann::ordered_json.
template <typename Json>
Json parse_json(const std::string& file, std::string_view text);
// At most kMostJsonBytes: 200 000 cameras.
template <typename Json>
Json read_json(const std::filesystem::path& path, std::string_view expected);

template <typename Json>
std::string json_text(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

// The text with U+FFFD for what is no UTF-8.
std::string valid_utf8(const std::string& text);

template <typename Json>
double json_real(const Json& json, const RealRange& range = kFinite) {
  const bool fits = json.is_number() && range.holds(json.template get<double>());
  if (!fits) throw NumberError("found " + quote(json_text(json)) + ", expected " + range.text());
  return json.template get<double>();
}

// 1000.0 is an integer: Python writes some so.
template <std::integral T, typename Json>
T json_integer(const Json& json, T low = std::numeric_limits<T>::min(), T high = std::numeric_limits<T>::max()) {
  if (json.is_number_unsigned()) {
    const uint64_t value = json.template get<uint64_t>();
    if (std::cmp_greater_equal(value, low) && std::cmp_less_equal(value, high)) return static_cast<T>(value);
  } else if (json.is_number_integer()) {
    const int64_t value = json.template get<int64_t>();
    if (std::cmp_greater_equal(value, low) && std::cmp_less_equal(value, high)) return static_cast<T>(value);
  } else if (json.is_number()) {
    constexpr double kExact = 9007199254740992.0;  // 2^53: above, a double is no longer the number that was written
    const double value = json.template get<double>();
    if (value == std::floor(value) && std::abs(value) <= kExact) {
      const auto whole = static_cast<int64_t>(value);
      if (std::cmp_greater_equal(whole, low) && std::cmp_less_equal(whole, high)) return static_cast<T>(whole);
    }
  }
  throw NumberError("found " + quote(json_text(json)) + ", expected an integer from " + std::to_string(low) + " to " +
                    std::to_string(high));
}

extern template nlohmann::json parse_json(const std::string&, std::string_view);
extern template nlohmann::ordered_json parse_json(const std::string&, std::string_view);
extern template nlohmann::json read_json(const std::filesystem::path&, std::string_view);
extern template nlohmann::ordered_json read_json(const std::filesystem::path&, std::string_view);

}  // namespace pipegs
