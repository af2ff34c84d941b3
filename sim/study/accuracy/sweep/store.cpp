// SPDX-License-Identifier: Apache-2.0
// store.cpp: see store.hpp.
#include "sim/study/accuracy/sweep/store.hpp"

namespace pipegs {

std::optional<Accuracy> AccuracyStore::load(const Config& config) const {
  const std::optional<nlohmann::ordered_json> measured = store_.load(config);
  try {
    return measured ? std::optional(accuracy_from_json(*measured)) : std::nullopt;
  } catch (const NumberError&) { return std::nullopt; } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

}  // namespace pipegs
