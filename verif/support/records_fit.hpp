// SPDX-License-Identifier: Apache-2.0
// records_fit: does every field of a record hold a value of its declared width? The check behind "nothing wraps".
//
// Idea    records.def gives each field its width and sign; a bit-accurate model that leaves it would be cut by the
//         RTL's wires. `pack` throws for one such field; this names it, so that whole chains of bit-accurate models can
//         be asked.
#pragma once

#include <string>

#include "cpp_model/records.hpp"

namespace pipegs {

class FieldsFit final : public FieldVisitor {
 public:
  void visit(const FieldName& field, uint64_t& value, int width, bool is_signed) override {
    if (!first.empty() || width >= 64) return;
    const auto whole = static_cast<int64_t>(value);
    const bool fits = width == 0  ? value == 0
                      : is_signed ? whole >= -(int64_t{1} << (width - 1)) && whole < (int64_t{1} << (width - 1))
                                  : value >> width == 0;
    if (fits) return;
    first = field.text() + " = " + (is_signed ? std::to_string(whole) : std::to_string(value)) + ", " +
            (is_signed ? "signed " : "unsigned ") + std::to_string(width) + " bits";
  }
  std::string first;
};

// "record.field = value, signed 12 bits" of the first field out of its range; empty when all fit.
template <class R>
std::string misfit(const Config& config, R record) {
  FieldsFit fit;
  visit_fields(config, record, fit);
  return fit.first.empty() ? "" : std::string(R::kName) + "." + fit.first;
}

}  // namespace pipegs
