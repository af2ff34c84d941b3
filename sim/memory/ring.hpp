// SPDX-License-Identifier: Apache-2.0
// ring.hpp: a queue in an array that grows, for queues that are touched in every cycle.
#pragma once

#include <cstddef>
#include <vector>

namespace pipegs {

template <class T>
class Ring {
 public:
  bool empty() const { return first_ == end_; }
  std::size_t size() const { return end_ - first_; }
  T& front() { return items_[first_ & (items_.size() - 1)]; }
  const T& front() const { return items_[first_ & (items_.size() - 1)]; }
  void push_back(const T& item) {
    if (size() == items_.size()) grow();
    items_[end_++ & (items_.size() - 1)] = item;
  }
  void pop_front() { ++first_; }

 private:
  void grow() {
    std::vector<T> larger(2 * items_.size());
    std::size_t count = 0;
    for (; !empty(); pop_front()) larger[count++] = front();
    items_ = std::move(larger);
    first_ = 0, end_ = count;
  }

  std::vector<T> items_ = std::vector<T>(8);  // a power of two
  std::size_t first_ = 0, end_ = 0;           // counted from the beginning
};

}  // namespace pipegs
