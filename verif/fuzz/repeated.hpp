// SPDX-License-Identifier: Apache-2.0
// repeated.hpp: large shallow documents out of few bytes: a fuzzer alone does not write a list of ten thousand.
//
// Format  "*", then three lines: what is before the list, an element, what is behind it. The element comes as often, by
//         commas, as makes kRepeatedBytes of it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace pipegs {

inline constexpr std::size_t kRepeatedBytes = 200000;

// The document; without a star the bytes as they are.
inline std::string repeated(std::string_view bytes) {
  if (!bytes.starts_with('*')) return std::string(bytes);
  const auto line = [&] {
    const std::string_view taken = bytes.substr(0, bytes.find('\n'));
    bytes.remove_prefix(std::min(bytes.size(), taken.size() + 1));
    return taken;
  };
  bytes.remove_prefix(1);
  const std::string_view head = line(), element = line(), tail = line();
  std::string text(head);
  text += element;
  for (std::size_t i = 1; i < kRepeatedBytes / (element.size() + 1); ++i) (text += ',') += element;
  return text += tail;
}

}  // namespace pipegs
