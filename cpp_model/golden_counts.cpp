// SPDX-License-Identifier: Apache-2.0
// golden_counts.cpp: sums of what the golden model counts: see golden.hpp.
#include <algorithm>

#include "cpp_model/golden.hpp"

namespace pipegs {

Work& Work::operator+=(const Work& o) {
  fetched += o.fetched, visible += o.visible, records += o.records, regions += o.regions;
  open_regions += o.open_regions, quads += o.quads, alphas += o.alphas;
  blended += o.blended, keys += o.keys, chunks += o.chunks, layers += o.layers, windows += o.windows;
  return *this;
}

Saturations& Saturations::operator+=(const Saturations& o) {
  mean += o.mean, color += o.color, accumulated += o.accumulated, dead += o.dead;
  return *this;
}

Called& Called::operator+=(const Called& o) {
  near += o.near, guard += o.guard, stopped += o.stopped, ties += o.ties, layers = std::max(layers, o.layers),
                                                                          bucket = std::max(bucket, o.bucket);
  return *this;
}

}  // namespace pipegs
