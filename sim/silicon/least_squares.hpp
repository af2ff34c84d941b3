// least_squares.hpp: coefficients c with x c ~ y, by the normal equations with partial pivoting: a few unknowns, tens of rows.
//
// Rule    ridge[i] is added to the i-th diagonal: with it coefficients that the rows do not tell apart stay small and alike;
//         without, the rows must determine all.
#pragma once

#include <vector>

namespace pipegs {

std::vector<double> least_squares(const std::vector<std::vector<double>>& x, const std::vector<double>& y, const std::vector<double>& ridge = {});

}  // namespace pipegs
