// SPDX-License-Identifier: Apache-2.0
// shared.hpp: the folder of trained scenes that are no part of the repository: PIPEGS_SHARED, or beside the checkout.
#pragma once

#include <cstdlib>
#include <filesystem>

namespace pipegs {

inline std::filesystem::path shared_folder() {
  const char* set = std::getenv("PIPEGS_SHARED");
  return set != nullptr ? std::filesystem::path(set) : std::filesystem::path(PIPEGS_SOURCE_DIR) / ".." / "shared";
}

}  // namespace pipegs
