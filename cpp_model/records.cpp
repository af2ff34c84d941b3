// SPDX-License-Identifier: Apache-2.0
// records.cpp: see records.hpp.
#include "cpp_model/records.hpp"

#include <stdexcept>

namespace pipegs {
namespace {

// One accessor for each name of config.def that may be a width, whether it is a member or a function.
#define PIPEGS_CONFIG(name, Name, value, low, high, unit, what) \
  [[maybe_unused]] int config_width_##name(const Config& c) { return c.name; }
#define PIPEGS_DERIVED(name, Name, expression, what) \
  [[maybe_unused]] int config_width_##name(const Config& c) { return c.name(); }
#define PIPEGS_FIXED(name, Name, value, what) \
  [[maybe_unused]] int config_width_##name(const Config&) { return value; }
#include "cpp_model/config.def"
#undef PIPEGS_CONFIG
#undef PIPEGS_DERIVED
#undef PIPEGS_FIXED

std::string decimal(uint64_t value, bool is_signed) {
  return is_signed ? std::to_string(static_cast<int64_t>(value)) : std::to_string(value);
}

uint64_t sign_extended(uint64_t bits, int width, bool is_signed) {
  const bool negative = is_signed && width > 0 && width < 64 && (bits >> (width - 1) & 1) != 0;
  return negative ? bits | ~uint64_t{0} << width : bits;
}

}  // namespace

// clang-format off
#define PIPEGS_RECORD(Name, name)                                                                        \
  void visit_fields([[maybe_unused]] const Config& c, Name& r, FieldVisitor& v, const FieldName* outer) {
#define FIELD_U(field, width, what) v.visit({#field, outer}, r.field, config_width_##width(c), false);
#define FIELD_S(field, width, what) \
    v.visit({#field, outer}, reinterpret_cast<uint64_t&>(r.field), config_width_##width(c), true);
#define FIELD_R(field, Record, what) { const FieldName way{#field, outer}; visit_fields(c, r.field, v, &way); }
#define PIPEGS_END(Name) }
#include "cpp_model/records.def"
// clang-format on

void FieldWidths::visit(const FieldName&, uint64_t&, int width, bool) { bits += width; }

void FieldPacker::visit(const FieldName& field, uint64_t& value, int width, bool is_signed) {
  check_field(record_, field, value, width, is_signed);
  put_bits(words_, at_, width, value);
  at_ += width;
}

void FieldUnpacker::visit(const FieldName&, uint64_t& value, int width, bool is_signed) {
  value = sign_extended(get_bits(words_, at_, width), width, is_signed);
  at_ += width;
}

void FieldPrinter::visit(const FieldName& field, uint64_t& value, int, bool is_signed) {
  text += (text.empty() ? "" : ", ") + field.text() + "=" + decimal(value, is_signed);
}

void FieldComparer::visit(const FieldName& field, uint64_t& value, int, bool is_signed) {
  if (!found) return expected_.push_back(value);
  const uint64_t expected = expected_[at_++];
  if (!difference.empty() || value == expected) return;
  difference = field.text() + ": expected " + decimal(expected, is_signed) + ", found " + decimal(value, is_signed);
}

void FieldFiller::visit(const FieldName&, uint64_t& value, int width, bool is_signed) {
  const uint64_t bits = rng_();
  value = sign_extended(width >= 64 ? bits : bits & ((uint64_t{1} << width) - 1), width, is_signed);
}

void put_bits(uint32_t* words, int at, int width, uint64_t value) {
  for (int done = 0; done < width;) {
    const int word = (at + done) / 32, shift = (at + done) % 32, take = std::min(32 - shift, width - done);
    const uint32_t mask = take == 32 ? ~0u : ((1u << take) - 1);
    words[word] = (words[word] & ~(mask << shift)) | ((static_cast<uint32_t>(value >> done) & mask) << shift);
    done += take;
  }
}

uint64_t get_bits(const uint32_t* words, int at, int width) {
  uint64_t value = 0;
  for (int done = 0; done < width;) {
    const int word = (at + done) / 32, shift = (at + done) % 32, take = std::min(32 - shift, width - done);
    const uint32_t mask = take == 32 ? ~0u : ((1u << take) - 1);
    value |= static_cast<uint64_t>((words[word] >> shift) & mask) << done;
    done += take;
  }
  return value;
}

void check_field(std::string_view record, const FieldName& field, uint64_t value, int width, bool is_signed) {
  if (width >= 64) return;
  const int64_t as_signed = static_cast<int64_t>(value);
  const bool fits = width == 0  ? value == 0  // a field that this configuration does not have
                    : is_signed ? as_signed >= -(int64_t{1} << (width - 1)) && as_signed < (int64_t{1} << (width - 1))
                                : value >> width == 0;
  if (fits) return;
  throw std::logic_error(std::string(record) + "." + field.text() + " = " + decimal(value, is_signed) +
                         " does not fit " + (is_signed ? "signed " : "unsigned ") + std::to_string(width) + " bits");
}

}  // namespace pipegs
