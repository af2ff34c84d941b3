// SPDX-License-Identifier: Apache-2.0
// neighbours: how far the three nearest other points are, of each point, exactly.
//
// Idea    A k-d tree: points halved at the median of the widest axis of their box, down to a few in a leaf. A half is
//         looked into only if its plane is nearer than the third neighbour found so far. INRIA's simple-knn looks into
//         boxes of a curve and is exact, too.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace pipegs {

inline constexpr int kNeighbours = 3;

// The mean of the squared distances to the three nearest others; of fewer where there are not so many, 0 for one point
// alone. Coordinates are finite.
std::vector<double> mean_squared_distances(const std::vector<glm::dvec3>& points, unsigned threads);

}  // namespace pipegs
