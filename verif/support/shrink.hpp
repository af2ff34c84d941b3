// SPDX-License-Identifier: Apache-2.0
// shrink.hpp: of a long list that makes a test fail, a short one that does, too.
//
// Idea    Halves are left out, then quarters, down to single entries, wherever the rest still fails; again from the
//         halves on as long as that helps. What is left fails, and without any one of its entries it does not, unless
//         the runs did not suffice.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pipegs {

template <class Entry, class Fails>
std::vector<Entry> shrink(std::vector<Entry> list, Fails&& fails, int runs = 200) {
  for (bool shorter = true; shorter;) {
    shorter = false;
    for (size_t part = list.size() / 2; part > 0; part /= 2) {
      for (size_t at = 0; at < list.size() && runs > 0;) {
        std::vector<Entry> rest = list;
        const auto from = rest.begin() + static_cast<std::ptrdiff_t>(at);
        rest.erase(from, from + static_cast<std::ptrdiff_t>(std::min(part, list.size() - at)));
        --runs;
        if (fails(rest)) list = std::move(rest), shorter = true;
        else at += part;
      }
    }
    shorter = shorter && runs > 0;
  }
  return list;
}

}  // namespace pipegs
