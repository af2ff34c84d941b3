// SPDX-License-Identifier: Apache-2.0
// memory_pages.hpp: the contents of a large memory, of which only the pages that are touched exist.
//
// Idea    What nobody has written is noise, the same in every run: who uses it shows, where zeros might pass for data.
// Units   Addresses are numbers of lines of 64 bytes.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <unordered_map>

#include "cpp_model/memory_line.hpp"

namespace pipegs {

class MemoryPages {
 public:
  const MemoryLine& line(uint64_t address) const { return page(address / kPageLines)[address % kPageLines]; }
  MemoryLine& line(uint64_t address) { return page(address / kPageLines)[address % kPageLines]; }

 private:
  static constexpr uint64_t kPageLines = 4096;
  using Page = std::array<MemoryLine, kPageLines>;

  Page& page(uint64_t number) const;

  mutable std::unordered_map<uint64_t, std::unique_ptr<Page>> pages_;
  mutable uint64_t cached_page_ = ~uint64_t{0};
  mutable Page* cached_ = nullptr;
};

}  // namespace pipegs
