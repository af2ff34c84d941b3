// SPDX-License-Identifier: Apache-2.0
// memory_pages.hpp: the contents of a large memory, of which only the pages that are touched exist.
//
// Units   Addresses are numbers of lines of 64 bytes. Lines that were never touched hold zero.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <unordered_map>

#include "cpp_model/memory_line.hpp"

namespace pipegs {

class MemoryPages {
 public:
  const MemoryLine& line(uint64_t address) const;
  MemoryLine& line(uint64_t address);

 private:
  static constexpr uint64_t kPageLines = 4096;
  using Page = std::array<MemoryLine, kPageLines>;

  std::unordered_map<uint64_t, std::unique_ptr<Page>> pages_;
  uint64_t cached_page_ = ~uint64_t{0};
  Page* cached_ = nullptr;
};

}  // namespace pipegs
