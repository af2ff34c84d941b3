// SPDX-License-Identifier: Apache-2.0
// nearest.cpp: see nearest.hpp.
#include "scenes/text/nearest.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace pipegs {
namespace {

constexpr size_t kLongest = 64;  // letters that count: a hostile word may have a megabyte

std::string small(std::string_view text) {
  std::string letters(text.substr(0, kLongest));
  for (char& c : letters) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return letters;
}

// Levenshtein's distance.
size_t distance(const std::string& a, const std::string& b) {
  if (!a.empty() && b.find(a) != std::string::npos) return a == b ? 0 : 1;
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t{0});
  for (size_t i = 0; i < a.size(); ++i) {
    size_t corner = row[0];
    row[0] = i + 1;
    for (size_t k = 0; k < b.size(); ++k) {
      const size_t changed = corner + (a[i] != b[k]);
      corner = row[k + 1];
      row[k + 1] = std::min({changed, row[k] + 1, corner + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_word(std::string_view word, const std::vector<std::string>& known) {
  const std::string wanted = small(word);
  const auto best = std::min_element(known.begin(), known.end(), [&](const std::string& a, const std::string& b) {
    return distance(wanted, small(a)) < distance(wanted, small(b));
  });
  return best == known.end() ? "" : *best;
}

}  // namespace pipegs
