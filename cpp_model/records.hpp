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
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "cpp_model/config.hpp"

namespace pipegs {

// kind: what a beat of a stream is.
enum Kind : uint64_t { kData = 0, kLayerEnd = 1, kWindowEnd = 2, kPartEnd = 3 };

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

// Name of a field; in a record within a record the way to it, `camera.position.x`. Built on the stack, text on demand.
struct FieldName {
  const char* name;
  const FieldName* outer = nullptr;
  std::string text() const { return outer ? outer->text() + "." + name : name; }
};

// What is done with each field of a record, low bits first; what a record in the record holds is visited field by field
// in its place. `value`: of a signed field in two's complement.
class FieldVisitor {
 public:
  virtual void visit(const FieldName& field, uint64_t& value, int width, bool is_signed) = 0;

 protected:
  ~FieldVisitor() = default;
};

// clang-format off
#define PIPEGS_RECORD(Name, name) \
  void visit_fields(const Config& config, Name& record, FieldVisitor& visitor, const FieldName* outer = nullptr);
#define FIELD_U(field, width, what)
#define FIELD_S(field, width, what)
#define FIELD_R(field, Record, what)
#define PIPEGS_END(Name)
#include "cpp_model/records.def"
#undef PIPEGS_RECORD
#undef FIELD_U
#undef FIELD_S
#undef FIELD_R
#undef PIPEGS_END
// clang-format on

// The visitors behind the functions below; they are compiled once, not for each record in each file.
class FieldWidths final : public FieldVisitor {
 public:
  void visit(const FieldName& field, uint64_t& value, int width, bool is_signed) override;
  int bits = 0;
};
class FieldPacker final : public FieldVisitor {
 public:
  FieldPacker(std::string_view record, uint32_t* words) : record_(record), words_(words) {}
  void visit(const FieldName& field, uint64_t& value, int width, bool is_signed) override;

 private:
  std::string_view record_;
  uint32_t* words_;
  int at_ = 0;
};
class FieldUnpacker final : public FieldVisitor {
 public:
  explicit FieldUnpacker(const uint32_t* words) : words_(words) {}
  void visit(const FieldName& field, uint64_t& value, int width, bool is_signed) override;

 private:
  const uint32_t* words_;
  int at_ = 0;
};
class FieldPrinter final : public FieldVisitor {
 public:
  void visit(const FieldName& field, uint64_t& value, int width, bool is_signed) override;
  std::string text;
};
class FieldComparer final : public FieldVisitor {  // first the expected record, then the one that was found
 public:
  void visit(const FieldName& field, uint64_t& value, int width, bool is_signed) override;
  bool found = false;
  std::string difference;

 private:
  std::vector<uint64_t> expected_;
  size_t at_ = 0;
};
class FieldFiller final : public FieldVisitor {
 public:
  explicit FieldFiller(std::mt19937_64& rng) : rng_(rng) {}
  void visit(const FieldName& field, uint64_t& value, int width, bool is_signed) override;

 private:
  std::mt19937_64& rng_;
};

template <class R>
int record_width(const Config& config) {
  R record;
  FieldWidths widths;
  visit_fields(config, record, widths);
  return widths.bits;
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
void pack(const Config& config, R record, uint32_t* words) {
  for (int i = 0, n = record_words<R>(config); i < n; ++i) words[i] = 0;
  FieldPacker packer(R::kName, words);
  visit_fields(config, record, packer);
}

template <class R>
R unpack(const Config& config, const uint32_t* words) {
  R record;
  FieldUnpacker unpacker(words);
  visit_fields(config, record, unpacker);
  return record;
}

// "name{field=value, ...}".
template <class R>
std::string to_text(const Config& config, R record) {
  FieldPrinter printer;
  visit_fields(config, record, printer);
  return std::string(R::kName) + "{" + printer.text + "}";
}

// Name and both values of the first differing field; empty when equal.
template <class R>
std::string first_difference(const Config& config, R expected, R found) {
  FieldComparer comparer;
  visit_fields(config, expected, comparer);
  comparer.found = true;
  visit_fields(config, found, comparer);
  return comparer.difference;
}

// A record with every field drawn from its whole range: legal for plumbing, not for arithmetic.
template <class R>
R random_record(const Config& config, std::mt19937_64& rng) {
  R record;
  FieldFiller filler(rng);
  visit_fields(config, record, filler);
  return record;
}

}  // namespace pipegs
