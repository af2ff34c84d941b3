// SPDX-License-Identifier: Apache-2.0
// least_squares.hpp: coefficients c with x c ~ y: a few unknowns, tens of rows.
//
// Idea    The normal equations, solved by Eigen (LDLT).
// Rule    ridge[i] is added to the i-th diagonal: with it coefficients that the rows do not tell apart stay small and
//         alike; without, the rows must determine all, or all come back as NaN.
#pragma once

#include <vector>

namespace pipegs {

std::vector<double> least_squares(const std::vector<std::vector<double>>& x, const std::vector<double>& y,
                                  const std::vector<double>& ridge = {});

}  // namespace pipegs
