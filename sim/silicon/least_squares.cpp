// least_squares.cpp: see least_squares.hpp.
#include "sim/silicon/least_squares.hpp"

#include <algorithm>
#include <cmath>

namespace pipegs {

std::vector<double> least_squares(const std::vector<std::vector<double>>& x, const std::vector<double>& y, const std::vector<double>& ridge) {
  const size_t n = x.at(0).size();
  std::vector<std::vector<double>> m(n, std::vector<double>(n + 1));
  for (size_t row = 0; row < x.size(); ++row) {
    for (size_t i = 0; i < n; ++i) {
      for (size_t k = 0; k < n; ++k) m[i][k] += x[row][i] * x[row][k];
      m[i][n] += x[row][i] * y[row];
    }
  }
  for (size_t i = 0; i < ridge.size(); ++i) m[i][i] += ridge[i];
  for (size_t i = 0; i < n; ++i) {
    size_t pivot = i;
    for (size_t k = i + 1; k < n; ++k) {
      if (std::abs(m[k][i]) > std::abs(m[pivot][i])) pivot = k;
    }
    std::swap(m[i], m[pivot]);
    for (size_t k = 0; k < n; ++k) {
      if (k == i) continue;
      const double factor = m[k][i] / m[i][i];
      for (size_t j = i; j <= n; ++j) m[k][j] -= factor * m[i][j];
    }
  }
  std::vector<double> coefficients;
  for (size_t i = 0; i < n; ++i) coefficients.push_back(m[i][n] / m[i][i]);
  return coefficients;
}

}  // namespace pipegs
