// SPDX-License-Identifier: Apache-2.0
// least_squares.cpp: see least_squares.hpp. The only file that reads Eigen's headers, which take seconds to compile.
#include "sim/silicon/area/least_squares.hpp"

#include <Eigen/Cholesky>
#include <limits>

namespace pipegs {
namespace {

constexpr double kSingular = 1e-14;  // a smaller pivot, of the largest: the equations do not determine all

}  // namespace

std::vector<double> least_squares(const std::vector<std::vector<double>>& x, const std::vector<double>& y,
                                  const std::vector<double>& ridge) {
  const auto unknowns = static_cast<Eigen::Index>(x.at(0).size());
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(unknowns, unknowns);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
  for (size_t i = 0; i < x.size(); ++i) {
    const Eigen::Map<const Eigen::VectorXd> row(x[i].data(), unknowns);
    normal += row * row.transpose();
    right += y.at(i) * row;
  }
  for (size_t i = 0; i < ridge.size(); ++i) normal.diagonal()(static_cast<Eigen::Index>(i)) += ridge[i];
  const Eigen::LDLT<Eigen::MatrixXd> ldlt(normal);
  Eigen::VectorXd c = Eigen::VectorXd::Constant(unknowns, std::numeric_limits<double>::quiet_NaN());
  const Eigen::VectorXd pivots = ldlt.vectorD();
  if (pivots.minCoeff() > kSingular * pivots.maxCoeff()) c = ldlt.solve(right);
  return {c.begin(), c.end()};
}

}  // namespace pipegs
