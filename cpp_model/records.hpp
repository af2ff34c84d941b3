// SPDX-License-Identifier: Apache-2.0
// records.hpp: the records of records.def as C++ structs, with one generic way to pack, compare and print them.
//
// Every field is an (u)int64_t that holds the value of a fixed-point field of the width that the Config gives it.
// `pack` puts the first field into the lowest bits, as the packed structs of rtl/pipegs_pkg.sv do, so a record crosses
// into Verilator as 32-bit words. Packing a value that does not fit its field throws: nothing ever wraps silently.
//
// RTL  rtl/pipegs_pkg.sv (printed from the same table)
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "cpp_model/config.hpp"

namespace pipegs {

// kind: what a beat of a stream is.
enum Kind : uint64_t { kData = 0, kLayerEnd = 1, kWindowEnd = 2 };

// clang-format off
#define PIPEGS_RECORD(Name, name) struct Name { static constexpr std::string_view kName = #name;
#define FIELD_U(field, width, what) uint64_t field = 0;
#define FIELD_S(field, width, what) int64_t field = 0;
#define FIELD_R(field, Record, what) Record field = {};
#define PIPEGS_END(Name) bool operator==(const Name&) const = default; };
#include "cpp_model/records.def"
#undef PIPEGS_RECORD
#undef FIELD_U
#undef FIELD_S
#undef FIELD_R
#undef PIPEGS_END
// clang-format on

// One accessor for each name of config.def that may be a width, whether it is a member or a function.
#define PIPEGS_CONFIG(name, Name, value, low, high, unit, what) \
  inline int config_width_##name(const Config& c) { return c.name; }
#define PIPEGS_DERIVED(name, Name, expression, what) \
  inline int config_width_##name(const Config& c) { return c.name(); }
#define PIPEGS_FIXED(name, Name, value, what)
#include "cpp_model/config.def"
#undef PIPEGS_CONFIG
#undef PIPEGS_DERIVED
#undef PIPEGS_FIXED

// Name of a field; in a record within a record the way to it, `camera.position.x`. Built on the stack, text on demand.
struct FieldName {
  const char* name;
  const FieldName* inner = nullptr;
  std::string text() const { return inner ? std::string(name) + "." + inner->text() : name; }
};

// visit_fields(config, record, f): f(name, value&, width, is_signed) for each field, low bits first; what a record in
// the record holds is visited field by field in its place.
// clang-format off
#define PIPEGS_RECORD(Name, name)                                    \
  template <class R, class F>                                        \
  requires std::is_same_v<std::remove_const_t<R>, Name>              \
  void visit_fields([[maybe_unused]] const Config& c, R& r, F&& f) {
#define FIELD_U(field, width, what) f(FieldName{#field}, r.field, config_width_##width(c), false);
#define FIELD_S(field, width, what) f(FieldName{#field}, r.field, config_width_##width(c), true);
#define FIELD_R(field, Record, what)                                                                    \
    visit_fields(c, r.field, [&](const FieldName& inner, auto& value, int width, bool is_signed) {      \
      f(FieldName{#field, &inner}, value, width, is_signed);                                            \
    });
#define PIPEGS_END(Name) }
#include "cpp_model/records.def"
#undef PIPEGS_RECORD
#undef FIELD_U
#undef FIELD_S
#undef FIELD_R
#undef PIPEGS_END
// clang-format on

template <class R>
int record_width(const Config& config) {
  R record;
  int bits = 0;
  visit_fields(config, record, [&](const FieldName&, auto&, int width, bool) { bits += width; });
  return bits;
}

template <class R>
int record_words(const Config& config) {
  return (record_width<R>(config) + 31) / 32;
}

// Writes `width` (at most 64) low bits of `value` at bit `at` of the words.
void put_bits(uint32_t* words, int at, int width, uint64_t value);
// Reads `width` (at most 64) bits, zero extended.
uint64_t get_bits(const uint32_t* words, int at, int width);
// Throws std::logic_error when the value does not fit.
void check_field(std::string_view record, const FieldName& field, uint64_t value, int width, bool is_signed);

template <class R>
void pack(const Config& config, const R& record, uint32_t* words) {
  for (int i = 0, n = record_words<R>(config); i < n; ++i) words[i] = 0;
  int at = 0;
  visit_fields(config, record, [&](const FieldName& field, const auto& value, int width, bool is_signed) {
    check_field(R::kName, field, static_cast<uint64_t>(value), width, is_signed);
    put_bits(words, at, width, static_cast<uint64_t>(value));
    at += width;
  });
}

template <class R>
R unpack(const Config& config, const uint32_t* words) {
  R record;
  int at = 0;
  visit_fields(config, record, [&](const FieldName&, auto& value, int width, bool is_signed) {
    uint64_t bits = get_bits(words, at, width);
    if (is_signed && width > 0 && width < 64 && ((bits >> (width - 1)) & 1)) bits |= ~uint64_t{0} << width;
    value = static_cast<std::remove_reference_t<decltype(value)>>(bits);
    at += width;
  });
  return record;
}

// "name{field=value, ...}".
template <class R>
std::string to_text(const Config& config, const R& record) {
  std::string text = std::string(R::kName) + "{";
  visit_fields(config, record, [&](const FieldName& field, const auto& value, int, bool) {
    text += (text.back() == '{' ? "" : ", ") + field.text() + "=" + std::to_string(value);
  });
  return text + "}";
}

// Name and both values of the first differing field; empty when equal.
template <class R>
std::string first_difference(const Config& config, const R& expected, const R& found) {
  std::string text;
  std::vector<std::string> values;
  visit_fields(config, expected,
               [&](const FieldName&, const auto& value, int, bool) { values.push_back(std::to_string(value)); });
  size_t i = 0;
  visit_fields(config, found, [&](const FieldName& field, const auto& value, int, bool) {
    const std::string now = std::to_string(value);
    if (text.empty() && now != values[i]) text = field.text() + ": expected " + values[i] + ", found " + now;
    ++i;
  });
  return text;
}

// A record with every field drawn from its whole range: legal for plumbing, not for arithmetic.
template <class R, class Rng>
R random_record(const Config& config, Rng& rng) {
  R record;
  visit_fields(config, record, [&](const FieldName&, auto& value, int width, bool is_signed) {
    uint64_t bits = rng();
    bits = width >= 64 ? bits : bits & ((uint64_t{1} << width) - 1);
    if (is_signed && width > 0 && width < 64 && ((bits >> (width - 1)) & 1)) bits |= ~uint64_t{0} << width;
    value = static_cast<std::remove_reference_t<decltype(value)>>(bits);
  });
  return record;
}

}  // namespace pipegs
