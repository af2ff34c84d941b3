// SPDX-License-Identifier: Apache-2.0
// pack_order: see pack_order.hpp.
//
// Idea    Items stay where they are, four lists of their numbers are split. A part of the items that is small enough
//         for the processor's cache is copied first, with numbers of its own; such parts share nothing, so threads
//         take them.
#include "cpp_model/pack/pack_order.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <vector>

#include "cpp_model/float/parallel.hpp"

namespace pipegs {
namespace {

constexpr int kDimensions = 4, kSize = 3;
constexpr std::size_t kUneven = 32;     // no part below 1/32 of its parent: bounds the depth
constexpr std::size_t kCached = 16384;  // items, 20 bytes each and 21 of the splitter

using Orders = std::array<std::vector<uint32_t>, kDimensions>;

// A box of means and their largest scale.
struct Bounds {
  float low[3], high[3], scale = 0;
  explicit Bounds(const OrderItem& item) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = item.value[axis] - item.extent[axis];
      high[axis] = item.value[axis] + item.extent[axis];
    }
    scale = item.value[kSize];
  }
  void add(const OrderItem& item) { add(Bounds(item)); }
  void add(const Bounds& other) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], other.low[axis]);
      high[axis] = std::max(high[axis], other.high[axis]);
    }
    scale = std::max(scale, other.scale);
  }
  // How often a window touches it, up to a constant.
  float touch(float window, float reach) const {
    const float grown = 2 * reach * scale + window;
    const float x = high[0] - low[0] + grown, y = high[1] - low[1] + grown, z = high[2] - low[2] + grown;
    return x * y + y * z + z * x;
  }
};

// A float as bits that sort as the numbers do; both zeros are equal.
uint32_t sortable(float value) {
  const auto bits = std::bit_cast<uint32_t>(value + 0.0f);
  return (bits >> 31) != 0 ? ~bits : bits | uint32_t{1} << 31;
}

// The items' numbers by each dimension; equal values keep the order of the items.
Orders sorted(std::span<const OrderItem> items, unsigned threads) {
  Orders orders;
  parallel_for(kDimensions, threads, [&](std::size_t d) {
    std::vector<uint64_t> keys(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) keys[i] = uint64_t{sortable(items[i].value[d])} << 32 | i;
    std::sort(keys.begin(), keys.end());
    orders[d].resize(items.size());
    std::transform(keys.begin(), keys.end(), orders[d].begin(),
                   [](uint64_t key) { return static_cast<uint32_t>(key); });
  });
  return orders;
}

struct Sizes {
  std::size_t chunk, group;  // items
  float window, reach;
};

struct Part {
  std::size_t begin, end;
};

class Splitter {
 public:
  Splitter(std::span<const OrderItem> items, const Sizes& sizes, Orders orders)
      : items_(items), sizes_(sizes), orders_(std::move(orders)), left_(items.size()), spare_(items.size()) {}

  // Splits down to chunks; parts of at most `least` items are left as they are and returned.
  std::vector<Part> split(std::size_t least) {
    split(0, items_.size(), std::max(least, sizes_.chunk));
    return std::move(parts_);
  }
  // Splits a part down to chunks. Parts share nothing: threads may do it at the same time.
  void finish(const Part& part) {
    const std::size_t count = part.end - part.begin;
    if (count <= sizes_.chunk) return;
    std::vector<OrderItem> items(count);
    std::vector<uint32_t> numbers(orders_[0].begin() + static_cast<std::ptrdiff_t>(part.begin),
                                  orders_[0].begin() + static_cast<std::ptrdiff_t>(part.end));
    for (std::size_t i = 0; i < count; ++i) {
      items[i] = items_[numbers[i]];
      spare_[numbers[i]] = static_cast<uint32_t>(i);
    }
    Orders orders;
    for (int d = 0; d < kDimensions; ++d) {
      orders[d].resize(count);
      for (std::size_t i = 0; i < count; ++i) orders[d][i] = spare_[orders_[d][part.begin + i]];
    }
    Splitter inner(items, sizes_, std::move(orders));
    inner.split(0);
    for (std::size_t i = 0; i < count; ++i) orders_[0][part.begin + i] = numbers[inner.orders_[0][i]];
  }
  std::vector<uint32_t> take_order() { return std::move(orders_[0]); }

 private:
  void split(std::size_t begin, std::size_t end, std::size_t least) {
    while (end - begin > least) {
      const std::size_t count = end - begin, step = count > sizes_.group ? sizes_.group : sizes_.chunk;
      Cut best{(count - 1) / step / 2 * step + step, 0, std::numeric_limits<float>::infinity()};
      for (int d = 0; d < kDimensions; ++d) sweep(d, begin, count, step, best);
      partition(best.dimension, begin, end, best.at);
      split(begin, begin + best.at, least);
      begin += best.at;
    }
    parts_.push_back({begin, end});
  }

  struct Cut {
    std::size_t at;
    int dimension;
    float cost;
  };

  // Costs of all places to cut along one dimension: at multiples of `step`.
  void sweep(int d, std::size_t begin, std::size_t count, std::size_t step, Cut& best) {
    const uint32_t* order = orders_[d].data() + begin;
    steps_.clear();
    for (std::size_t i = 0; i < count; i += step) {
      Bounds bounds(items_[order[i]]);
      for (std::size_t k = i + 1; k < std::min(count, i + step); ++k) bounds.add(items_[order[k]]);
      steps_.push_back(bounds);
    }
    below_.clear();
    Bounds below = steps_.front();
    for (std::size_t n = 1; n < steps_.size(); ++n) {
      below_.push_back(below.touch(sizes_.window, sizes_.reach) * static_cast<float>(n * step));
      below.add(steps_[n]);
    }
    Bounds above = steps_.back();
    for (std::size_t n = steps_.size() - 1; n > 0; --n) {
      above.add(steps_[n]);
      const std::size_t i = n * step;
      const bool even = count <= kUneven * step || (i * kUneven >= count && (count - i) * kUneven >= count);
      const float cost = below_[n - 1] + above.touch(sizes_.window, sizes_.reach) * static_cast<float>(count - i);
      if (even && cost < best.cost) best = {i, d, cost};
    }
  }

  // Brings the first `at` items along dimension `best` to the front of all orders, each order kept otherwise.
  void partition(int best, std::size_t begin, std::size_t end, std::size_t at) {
    for (std::size_t i = begin; i < end; ++i) left_[orders_[best][i]] = i < begin + at;
    for (int d = 0; d < kDimensions; ++d) {
      if (d == best) continue;
      uint32_t* const order = orders_[d].data();
      std::size_t front = begin, back = begin;
      for (std::size_t i = begin; i < end; ++i) {  // both are written, one counts: there is no branch to mispredict
        const uint32_t item = order[i];
        const bool left = left_[item] != 0;
        order[front] = item;
        spare_[back] = item;
        front += left;
        back += !left;
      }
      std::copy_n(spare_.begin() + static_cast<std::ptrdiff_t>(begin), back - begin, order + front);
    }
  }

  std::span<const OrderItem> items_;
  Sizes sizes_;
  Orders orders_;
  std::vector<char> left_;
  std::vector<uint32_t> spare_;
  std::vector<Bounds> steps_;
  std::vector<float> below_;
  std::vector<Part> parts_;
};

std::vector<uint32_t> order_of(std::span<const OrderItem> items, const Sizes& sizes, unsigned threads) {
  Splitter splitter(items, sizes, sorted(items, threads));
  const std::vector<Part> parts = splitter.split(kCached);
  parallel_for(parts.size(), threads, [&](std::size_t i) { splitter.finish(parts[i]); });
  return splitter.take_order();
}

}  // namespace

void pack_order(std::span<OrderItem> items, std::size_t chunk, std::size_t group, float window, float reach,
                unsigned threads) {
  if (items.size() <= chunk) return;
  const std::vector<uint32_t> order = order_of(items, {chunk, group, window, reach}, threads);
  std::vector<OrderItem> ordered;
  ordered.reserve(items.size());
  for (const uint32_t i : order) ordered.push_back(items[i]);
  std::copy(ordered.begin(), ordered.end(), items.begin());
}

}  // namespace pipegs
