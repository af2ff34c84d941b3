// SPDX-License-Identifier: Apache-2.0
// su_split.cpp: see su_split.hpp.
#include "cpp_model/su/sort/su_split.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "cpp_model/fixed.hpp"

namespace pipegs {
namespace {

constexpr int kBuckets = 16, kBucketW = 4;
constexpr size_t kGroup = 16;

struct Group {
  std::vector<uint32_t> slots;
  int shift;
};

// The four bits below the leading one of a range.
int wide_shift(uint64_t range) { return std::max(bit_length(range) - kBucketW, 0); }

}  // namespace

std::vector<std::vector<uint32_t>> su_split(std::span<const uint64_t> keys, const KeyRange& range, SplitStats* stats) {
  std::vector<std::vector<uint32_t>> groups;
  std::vector<Group> stack;
  Group group{std::vector<uint32_t>(keys.size()), wide_shift(range.max - range.min)};
  std::iota(group.slots.begin(), group.slots.end(), 0u);
  for (;;) {
    if (group.slots.size() <= kGroup) {
      groups.push_back(std::move(group.slots));
      if (stack.empty()) return groups;
      group = std::move(stack.back());
      stack.pop_back();
      continue;
    }
    std::array<std::vector<uint32_t>, kBuckets> buckets;
    const uint64_t first = keys[group.slots.front()] - range.min;
    uint64_t differ = 0;
    for (const uint32_t slot : group.slots) {
      const uint64_t offset = keys[slot] - range.min;
      differ |= offset ^ first;
      buckets[offset >> group.shift & (kBuckets - 1)].push_back(slot);
    }
    if (stats != nullptr) stats->passes += 1, stats->visits += group.slots.size();
    Group near{{}, std::max(group.shift - kBucketW, 0)};
    int filled = 0;
    for (int b = kBuckets; b-- > 0;) {
      if (buckets[b].empty()) continue;
      std::reverse(buckets[b].begin(), buckets[b].end());  // a chain shows its newest key first
      if (filled++ > 0 && near.slots.size() + buckets[b].size() > kGroup) {
        stack.push_back(near);
        near.slots.clear();
      }
      near.slots.insert(near.slots.begin(), buckets[b].begin(), buckets[b].end());
    }
    if (filled == 1) near.shift = wide_shift(differ);
    group = std::move(near);
  }
}

}  // namespace pipegs
