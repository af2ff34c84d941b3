// SPDX-License-Identifier: Apache-2.0
// record_table.hpp: records.def as a table of names, for programs that print it: the package, the registers.
//
// records.hpp has the same records as structs. A width is here the name of its entry in config.def; config_value() has
// its number.
#pragma once

#include <vector>

namespace pipegs {

struct RecordField {
  const char* name;
  const char* type;  // a width, or the C++ name of a record
  enum { kUnsigned, kSigned, kRecord } form;
  const char* what;
};

struct RecordEntry {
  const char* name;
  const char* camel_name;
  std::vector<RecordField> fields;
};

inline const std::vector<RecordEntry>& record_table() {
  // clang-format off
  static const std::vector<RecordEntry> table = {
#define PIPEGS_RECORD(Name, name) {#name, #Name, {
#define FIELD_U(field, width, what) {#field, #width, RecordField::kUnsigned, what},
#define FIELD_S(field, width, what) {#field, #width, RecordField::kSigned, what},
#define FIELD_R(field, Record, what) {#field, #Record, RecordField::kRecord, what},
#define PIPEGS_END(Name) }},
#include "cpp_model/records.def"
#undef PIPEGS_RECORD
#undef FIELD_U
#undef FIELD_S
#undef FIELD_R
#undef PIPEGS_END
  };
  // clang-format on
  return table;
}

}  // namespace pipegs
