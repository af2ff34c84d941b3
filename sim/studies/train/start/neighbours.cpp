// SPDX-License-Identifier: Apache-2.0
// neighbours: see neighbours.hpp.
//
// Idea    The tree is an order of the points: the middle of a span is its root, what lies before and behind it the two
//         halves, so that only the axes are stored beside the order.
#include "sim/studies/train/start/neighbours.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "cpp_model/float/parallel.hpp"

namespace pipegs {
namespace {

constexpr std::size_t kLeaf = 8, kBlock = 1024;

class Tree {
 public:
  explicit Tree(const std::vector<glm::dvec3>& points) : points_(points), order_(points.size()), axes_(points.size()) {
    for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = static_cast<std::uint32_t>(i);
    build(0, order_.size());
  }

  // Squares of the distances from point `of` to its nearest others, ascending; infinite where there are no more.
  std::array<double, kNeighbours> nearest(std::size_t of) const {
    std::array<double, kNeighbours> best;
    best.fill(std::numeric_limits<double>::infinity());
    look(0, order_.size(), of, best);
    return best;
  }

 private:
  void build(std::size_t begin, std::size_t end) {
    if (end - begin <= kLeaf) return;
    glm::dvec3 low = points_[order_[begin]], high = low;
    for (std::size_t i = begin; i < end; ++i) {
      low = glm::min(low, points_[order_[i]]);
      high = glm::max(high, points_[order_[i]]);
    }
    const glm::dvec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [this](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end),
                     [&](std::uint32_t a, std::uint32_t b) { return points_[a][axis] < points_[b][axis]; });
    axes_[middle] = static_cast<std::uint8_t>(axis);
    build(begin, middle);
    build(middle + 1, end);
  }

  void offer(std::uint32_t other, std::size_t of, std::array<double, kNeighbours>& best) const {
    if (other == of) return;
    const glm::dvec3 d = points_[other] - points_[of];
    double square = glm::dot(d, d);
    for (double& known : best) {
      if (square < known) std::swap(square, known);
    }
  }

  void look(std::size_t begin, std::size_t end, std::size_t of, std::array<double, kNeighbours>& best) const {
    if (end - begin <= kLeaf) {
      for (std::size_t i = begin; i < end; ++i) offer(order_[i], of, best);
      return;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    const int axis = axes_[middle];
    const double side = points_[of][axis] - points_[order_[middle]][axis];
    offer(order_[middle], of, best);
    look(side < 0 ? begin : middle + 1, side < 0 ? middle : end, of, best);
    if (side * side <= best.back()) look(side < 0 ? middle + 1 : begin, side < 0 ? end : middle, of, best);
  }

  const std::vector<glm::dvec3>& points_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint8_t> axes_;  // at the middle of each span
};

}  // namespace

std::vector<double> mean_squared_distances(const std::vector<glm::dvec3>& points, unsigned threads) {
  const Tree tree(points);
  std::vector<double> means(points.size());
  parallel_for((points.size() + kBlock - 1) / kBlock, threads, [&](std::size_t block) {
    for (std::size_t i = block * kBlock; i < std::min(points.size(), (block + 1) * kBlock); ++i) {
      double sum = 0;
      int found = 0;
      for (const double square : tree.nearest(i)) {
        if (!(square < std::numeric_limits<double>::infinity())) break;
        sum += square;
        ++found;
      }
      means[i] = found == 0 ? 0 : sum / found;
    }
  });
  return means;
}

}  // namespace pipegs
