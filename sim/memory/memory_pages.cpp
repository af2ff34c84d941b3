// SPDX-License-Identifier: Apache-2.0
// memory_pages.cpp: see memory_pages.hpp.
#include "sim/memory/memory_pages.hpp"

#include <random>

namespace pipegs {

MemoryPages::Page& MemoryPages::page(uint64_t number) const {
  if (number != cached_page_) {
    auto& slot = pages_[number];
    if (!slot) {
      slot = std::make_unique<Page>();
      std::mt19937_64 noise(number);
      for (MemoryLine& line : *slot) {
        for (uint32_t& word : line) word = static_cast<uint32_t>(noise() >> 32);
      }
    }
    cached_page_ = number;
    cached_ = slot.get();
  }
  return *cached_;
}

}  // namespace pipegs
