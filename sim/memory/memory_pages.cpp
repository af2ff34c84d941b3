// SPDX-License-Identifier: Apache-2.0
// memory_pages.cpp: see memory_pages.hpp.
#include "sim/memory/memory_pages.hpp"

namespace pipegs {

MemoryLine& MemoryPages::line(uint64_t address) {
  const uint64_t page = address / kPageLines;
  if (page != cached_page_) {
    auto& slot = pages_[page];
    if (!slot) slot = std::make_unique<Page>();
    cached_page_ = page;
    cached_ = slot.get();
  }
  return (*cached_)[address % kPageLines];
}

const MemoryLine& MemoryPages::line(uint64_t address) const {
  static const MemoryLine kZero{};
  const auto slot = pages_.find(address / kPageLines);
  return slot == pages_.end() ? kZero : (*slot->second)[address % kPageLines];
}

}  // namespace pipegs
