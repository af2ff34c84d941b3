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

// "record.field = value, signed 12 bits" of the first field out of its range; empty when all fit.
template <class R>
std::string misfit(const Config& config, const R& record) {
  std::string first;
  visit_fields(config, record, [&](const FieldName& field, const auto& value, int width, bool is_signed) {
    if (!first.empty() || width >= 64) return;
    const auto bits = static_cast<uint64_t>(value);
    const auto whole = static_cast<int64_t>(bits);
    const bool fits = width == 0  ? bits == 0
                      : is_signed ? whole >= -(int64_t{1} << (width - 1)) && whole < (int64_t{1} << (width - 1))
                                  : bits >> width == 0;
    if (fits) return;
    first = std::string(R::kName) + "." + field.text() + " = " +
            (is_signed ? std::to_string(whole) : std::to_string(bits)) + ", " + (is_signed ? "signed " : "unsigned ") +
            std::to_string(width) + " bits";
  });
  return first;
}

}  // namespace pipegs
