// SPDX-License-Identifier: Apache-2.0
// records_fit: does every field of a record hold a value of its declared width? The check behind "nothing wraps".
//
// Idea    records.def gives each field its width and sign; a bit-accurate model that leaves it would be cut by the
//         RTL's wires. `pack` throws for such a field; here that is an answer, so that whole chains of bit-accurate
//         models can be asked.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "cpp_model/records.hpp"

namespace pipegs {

// What `pack` says of the first field out of its range; empty when all fit.
template <class R>
std::string misfit(const Config& config, const R& record) {
  std::vector<uint32_t> words(static_cast<size_t>(record_words<R>(config)) + 1);
  try {
    pack(config, record, words.data());
  } catch (const std::logic_error& error) { return error.what(); }
  return "";
}

}  // namespace pipegs
