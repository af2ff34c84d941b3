// SPDX-License-Identifier: Apache-2.0
// pack_cells.cpp: see pack_cells.hpp.
#include "cpp_model/pack/pack_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <stdexcept>

namespace pipegs {
namespace {

constexpr uint64_t kFewGroups = 8;

struct Box {
  std::array<double, 3> low = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  void add(const Node& node) {
    const std::array<int64_t, 3> center = {node.center_x, node.center_y, node.center_z};
    const std::array<uint64_t, 3> half = {node.half_x, node.half_y, node.half_z};
    for (size_t axis = 0; axis < 3; ++axis) {
      const double reach = std::ldexp(static_cast<double>(half[axis]), static_cast<int>(node.half_exp)),
                   at = static_cast<double>(center[axis]);
      low[axis] = std::min(low[axis], at - reach);
      high[axis] = std::max(high[axis], at + reach);
    }
  }
  double surface() const {
    const double x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    return x * y + y * z + z * x;
  }
};

struct Run {
  uint64_t first = 0, count = 0;  // of its groups

  bool operator<(const Run& other) const { return count != other.count ? count < other.count : first > other.first; }
};

// How many groups the first of two parts has: where the sum of count times surface is least.
uint64_t best_cut(const std::vector<Node>& groups, const Run& run) {
  std::vector<double> behind(run.count);  // surface of the groups from this one on
  Box box;
  for (uint64_t i = run.count; i-- > 1;) {
    box.add(groups[run.first + i]);
    behind[i] = box.surface();
  }
  box = {};
  uint64_t best = 1;
  double least = HUGE_VAL;
  for (uint64_t i = 1; i < run.count; ++i) {
    box.add(groups[run.first + i - 1]);
    const double cost = static_cast<double>(i) * box.surface() + static_cast<double>(run.count - i) * behind[i];
    if (cost < least) least = cost, best = i;
  }
  return best;
}

}  // namespace

std::vector<Node> cell_table(const std::vector<Node>& cells, const std::vector<Node>& groups, size_t entries) {
  std::priority_queue<Run> large;  // the largest first
  for (const Node& cell : cells) {
    if (cell.count != 0) large.push({cell.first, cell.count});
  }
  if (large.size() > entries) throw std::invalid_argument("cell_table: fewer entries than cells");
  while (!large.empty() && large.size() < entries && large.top().count > kFewGroups) {
    const Run run = large.top();
    const uint64_t cut = best_cut(groups, run);
    large.pop();
    large.push({run.first, cut});
    large.push({run.first + cut, run.count - cut});
  }
  std::vector<Node> table;
  for (; !large.empty(); large.pop()) {
    Node& entry = table.emplace_back();
    entry.first = large.top().first;
    entry.count = large.top().count;
  }
  std::sort(table.begin(), table.end(), [](const Node& a, const Node& b) { return a.first < b.first; });
  table.resize(entries);
  return table;
}

}  // namespace pipegs
