// SPDX-License-Identifier: Apache-2.0
// keep.hpp: what every target does with what it has read: names and texts are kept, as many as a room of Room bytes
// holds; and with what it has not: the message is one line.
//
// Idea    A fuzzer that finds nothing may be blind: no coverage, no sanitizer, inputs that are refused at once. Built
//         with PIPEGS_PLANTED the room does not check its bounds, so an input that is read well and holds one byte more
//         than any of the corpus ends in an overflow, which planted.sh wants to see found.
#pragma once

#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <string_view>

namespace pipegs {

template <std::size_t Room>
class Kept {
 public:
  void add(std::string_view item) {
#ifndef PIPEGS_PLANTED
    if (item.size() > Room - used_) return;
#endif
    std::memcpy(room_->data() + used_, item.data(), item.size());
    used_ += item.size();
  }

 private:
  std::unique_ptr<std::array<char, Room>> room_ = std::make_unique<std::array<char, Room>>();
  std::size_t used_ = 0;
};

inline void refused(const std::exception& error) {
  if (std::strchr(error.what(), '\n') != nullptr) std::abort();
}

}  // namespace pipegs
