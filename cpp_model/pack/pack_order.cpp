// SPDX-License-Identifier: Apache-2.0
// pack_order: see pack_order.hpp.
#include "cpp_model/pack/pack_order.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace pipegs {
namespace {

constexpr int kDimensions = 4, kSize = 3;
constexpr std::size_t kUneven = 32;  // no part below 1/32 of its parent: bounds the depth

// A box of means and their largest scale, grown item by item.
struct Bounds {
  float low[3], high[3], scale = 0;
  explicit Bounds(const OrderItem& item) {
    for (int axis = 0; axis < 3; ++axis) low[axis] = high[axis] = item.value[axis];
    scale = item.value[kSize];
  }
  void add(const OrderItem& item) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], item.value[axis]);
      high[axis] = std::max(high[axis], item.value[axis]);
    }
    scale = std::max(scale, item.value[kSize]);
  }
  // How often a window touches it, up to a constant.
  float touch(float window, float reach) const {
    const float grown = 2 * reach * scale + window;
    const float x = high[0] - low[0] + grown, y = high[1] - low[1] + grown, z = high[2] - low[2] + grown;
    return x * y + y * z + z * x;
  }
};

class Splitter {
 public:
  Splitter(std::span<const OrderItem> items, std::size_t chunk, std::size_t group, float window, float reach)
      : items_(items),
        chunk_(chunk),
        group_(group),
        window_(window),
        reach_(reach),
        left_(items.size()),
        spare_(items.size()) {
    for (int d = 0; d < kDimensions; ++d) {
      order_[d].resize(items.size());
      for (uint32_t i = 0; i < items.size(); ++i) order_[d][i] = i;
      std::sort(order_[d].begin(), order_[d].end(), [&](uint32_t a, uint32_t b) {
        const float x = items[a].value[d], y = items[b].value[d];
        return x != y ? x < y : items[a].index < items[b].index;
      });
    }
    split(0, items.size());
  }
  const std::vector<uint32_t>& order() const { return order_[0]; }

 private:
  void split(std::size_t begin, std::size_t end) {
    while (end - begin > chunk_) {
      const std::size_t count = end - begin, step = count > group_ ? group_ : chunk_;
      std::size_t at = (count - 1) / step / 2 * step + step;
      int best = 0;
      float least = std::numeric_limits<float>::infinity();
      for (int d = 0; d < kDimensions; ++d) sweep(d, begin, count, step, least, best, at);
      partition(best, begin, end, at);
      split(begin, begin + at);
      begin += at;
    }
  }

  // Costs of all places to cut along one dimension.
  void sweep(int d, std::size_t begin, std::size_t count, std::size_t step, float& least, int& best, std::size_t& at) {
    const uint32_t* order = order_[d].data() + begin;
    below_.clear();
    Bounds below(items_[order[0]]);
    for (std::size_t i = 1; i < count; ++i) {
      if (i % step == 0) below_.push_back(below.touch(window_, reach_) * static_cast<float>(i));
      below.add(items_[order[i]]);
    }
    Bounds above(items_[order[count - 1]]);
    for (std::size_t i = count - 1; i > 0; --i) {
      above.add(items_[order[i]]);
      if (i % step != 0) continue;
      const bool even = count <= kUneven * step || (i * kUneven >= count && (count - i) * kUneven >= count);
      const float cost = below_[i / step - 1] + above.touch(window_, reach_) * static_cast<float>(count - i);
      if (even && cost < least) {
        least = cost;
        best = d;
        at = i;
      }
    }
  }

  // Brings the first `at` items along dimension `best` to the front of all orders, each order kept otherwise.
  void partition(int best, std::size_t begin, std::size_t end, std::size_t at) {
    for (std::size_t i = begin; i < end; ++i) left_[order_[best][i]] = i < begin + at;
    for (int d = 0; d < kDimensions; ++d) {
      if (d == best) continue;
      std::size_t front = begin, back = 0;
      for (std::size_t i = begin; i < end; ++i) {
        const uint32_t item = order_[d][i];
        if (left_[item] != 0) order_[d][front++] = item;
        else spare_[back++] = item;
      }
      std::copy_n(spare_.begin(), back, order_[d].begin() + static_cast<std::ptrdiff_t>(front));
    }
  }

  std::span<const OrderItem> items_;
  std::size_t chunk_, group_;
  float window_, reach_;
  std::vector<uint32_t> order_[kDimensions];
  std::vector<char> left_;
  std::vector<uint32_t> spare_;
  std::vector<float> below_;
};

}  // namespace

void pack_order(std::span<OrderItem> items, std::size_t chunk, std::size_t group, float window, float reach) {
  if (items.size() <= chunk) return;
  const Splitter splitter(items, chunk, group, window, reach);
  std::vector<OrderItem> ordered;
  ordered.reserve(items.size());
  for (const uint32_t i : splitter.order()) ordered.push_back(items[i]);
  std::copy(ordered.begin(), ordered.end(), items.begin());
}

}  // namespace pipegs
