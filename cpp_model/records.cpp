// SPDX-License-Identifier: Apache-2.0
// records.cpp: see records.hpp.
#include "cpp_model/records.hpp"

#include <stdexcept>

namespace pipegs {

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
  if (width == 0 && value == 0) return;  // a field that this configuration does not have
  const int64_t as_signed = static_cast<int64_t>(value);
  const bool fits = is_signed ? (as_signed >= -(int64_t{1} << (width - 1)) && as_signed < (int64_t{1} << (width - 1)))
                              : (value >> width) == 0;
  if (fits) return;
  throw std::logic_error(std::string(record) + "." + field.text() + " = " +
                         (is_signed ? std::to_string(as_signed) : std::to_string(value)) + " does not fit " +
                         (is_signed ? "signed " : "unsigned ") + std::to_string(width) + " bits");
}

}  // namespace pipegs
