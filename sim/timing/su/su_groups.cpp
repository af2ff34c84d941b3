// SPDX-License-Identifier: Apache-2.0
// su_groups.cpp: the splitter's passes, played on the keys: see su.hpp, su_split.sv, cpp_model/su/sort/su_split.hpp.
#include <algorithm>
#include <array>
#include <bit>

#include "sim/timing/su/su.hpp"

namespace pipegs::timing {
namespace {

constexpr int kBuckets = 16, kBucketW = 4, kGroup = 16;

int wide_shift(uint64_t range) { return std::max(static_cast<int>(std::bit_width(range)) - kBucketW, 0); }

struct Range {
  uint32_t first, count;
  int shift;
};

}  // namespace

void su_groups(std::vector<uint64_t>& keys, uint64_t min, uint64_t max, std::vector<SortGroup>& groups,
               std::vector<LinkWrites>& links) {
  static thread_local std::vector<uint64_t> moved;
  static thread_local std::vector<Range> stack;
  moved.resize(keys.size());
  stack.clear();
  groups.clear();
  links.clear();
  for (uint64_t& key : keys) key -= min;
  Range group{0, static_cast<uint32_t>(keys.size()), wide_shift(max - min)};
  int at = keys.size() <= kGroup ? 1 : 2;  // first cycle of what follows Idle or Measure, or Take
  for (;;) {
    if (group.count <= kGroup) {
      groups.push_back({at, static_cast<int>(group.count), links.size()});
      if (stack.empty()) return;
      group = stack.back();
      stack.pop_back();
      at = 2;
      continue;
    }
    std::array<uint32_t, kBuckets> count{}, place{};
    uint64_t differ = 0;
    for (uint32_t i = 0; i < group.count; ++i) {
      const uint64_t key = keys[group.first + i];
      ++count[key >> group.shift & (kBuckets - 1)];
      differ |= key ^ keys[group.first];
    }
    uint32_t sum = 0;
    for (int b = 0; b < kBuckets; ++b) place[static_cast<size_t>(b)] = sum, sum += count[static_cast<size_t>(b)];
    for (uint32_t i = 0; i < group.count; ++i) {
      const uint64_t key = keys[group.first + i];
      moved[group.first + place[key >> group.shift & (kBuckets - 1)]++] = key;
    }
    std::copy_n(moved.begin() + group.first, group.count, keys.begin() + group.first);

    // From far to near: neighbours are joined while they fit.
    const int shift = std::max(group.shift - kBucketW, 0);
    Range near{group.first + group.count, 0, shift};
    const int gather = at + static_cast<int>(group.count) + 3;
    links.push_back({at + 2, gather - 2});  // every key is dropped into its bucket
    int filled = 0;
    for (int b = kBuckets; b-- > 0;) {
      const uint32_t n = count[static_cast<size_t>(b)];
      if (n == 0) continue;
      if (filled > 0 && near.count + n > kGroup) {
        stack.push_back(near);
        near.count = 0;
      }
      ++filled;
      near.first -= n;
      near.count += n;
    }
    links.push_back({gather, gather + filled - 1});  // it claims the links for each bucket, joined or not
    at = gather + filled + 1;
    if (filled == 1) near.shift = wide_shift(differ), ++at;  // Measure
    group = near;
  }
}

}  // namespace pipegs::timing
