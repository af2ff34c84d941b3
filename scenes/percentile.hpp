// SPDX-License-Identifier: Apache-2.0
// percentile.hpp: percentiles by nearest rank: the least of the values that a share of them, 0 to 1, does not exceed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace pipegs {

// The place of a percentile among `count` values in rising order, of which there is one at least.
inline std::size_t nearest_rank(std::size_t count, double share) {
  return std::max<std::size_t>(static_cast<std::size_t>(std::ceil(share * static_cast<double>(count))), 1) - 1;
}

// NaN without values.
inline double percentile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(nearest_rank(values.size(), share));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace pipegs
