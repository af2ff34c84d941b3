// SPDX-License-Identifier: Apache-2.0
// sram_cost.cpp: see sram_cost.hpp.
#include "sim/silicon/area/sram_cost.hpp"

#include <algorithm>
#include <cmath>

#include "scenes/input_error.hpp"
#include "scenes/text/csv.hpp"
#include "sim/silicon/area/least_squares.hpp"

namespace pipegs {
namespace {

constexpr const char* kHeader =
    "tech_um,cell,periph,size_B,width_b,ports,area_mm2,access_ns,cycle_ns,read_pJ,write_pJ,leak_mW";
constexpr std::array kFigures = {"area_mm2", "access_ns", "cycle_ns", "read_pJ", "write_pJ", "leak_mW"};
constexpr double kNode = 0.028;  // um
constexpr int kWidestMacro = 256;

std::vector<double> terms(double bytes, double width, bool two_ports) {
  return {1, std::log2(bytes), std::log2(width), two_ports ? 1.0 : 0.0};
}

}  // namespace

SramLaw::SramLaw(const std::filesystem::path& csv) {
  read_csv(csv, kHeader, [&](const CsvRow& fields) {
    const std::string& ports = fields.text("ports");
    if (ports != "1RW" && ports != "1R1W") fields.fail("ports", "found " + quote(ports) + ", expected 1RW or 1R1W");
    Row row = {fields.real("size_B", kPositive), fields.real("width_b", kPositive), ports == "1R1W", {}};
    for (size_t i = 0; i < row.figures.size(); ++i) row.figures[i] = fields.real(kFigures[i], kPositive);
    if (fields.real("tech_um", kPositive) == kNode)
      kinds_[fields.text("cell") + "/" + fields.text("periph")].rows.push_back(row);
  });
  for (auto& [name, kind] : kinds_) {
    std::vector<std::vector<double>> x;
    for (const Row& row : kind.rows) x.push_back(terms(row.bytes, row.width, row.two_ports));
    for (size_t i = 0; i < 6; ++i) {
      std::vector<double> y;
      for (const Row& row : kind.rows) y.push_back(std::log2(row.figures[i]));
      kind.exponents[i] = least_squares(x, y);
      if (!std::all_of(kind.exponents[i].begin(), kind.exponents[i].end(), [](double e) { return std::isfinite(e); })) {
        throw InputError(csv.string(), name, "too few sizes, widths or ports for a law");
      }
    }
  }
  if (kinds_.empty()) throw InputError(csv.string(), "", "no rows of 28 nm");
}

std::vector<std::string> SramLaw::kinds() const {
  std::vector<std::string> names;
  for (const auto& [name, kind] : kinds_) names.push_back(name);
  return names;
}

std::array<double, 6> SramLaw::evaluate(const Kind& kind, double bytes, double width, bool two_ports) const {
  const std::vector<double> x = terms(bytes, width, two_ports);
  std::array<double, 6> figures{};
  for (size_t i = 0; i < 6; ++i) {
    double power = 0;
    for (size_t k = 0; k < 4; ++k) power += kind.exponents[i][k] * x[k];
    figures[i] = std::exp2(power);
  }
  return figures;
}

SramFigures SramLaw::macro(const std::string& kind, double bytes, double width, bool two_ports) const {
  const std::array<double, 6> f = evaluate(kinds_.at(kind), bytes, width, two_ports);
  return {f[0], f[1], f[2], f[3], f[4], f[5]};
}

SramFigures SramLaw::memory(const std::string& kind, int width, int depth, int ports) const {
  const int columns = (width + kWidestMacro - 1) / kWidestMacro;
  const double column = static_cast<double>(width) / columns;
  SramFigures f = macro(kind, column * depth / 8, column, ports == 2);
  for (double* each : {&f.area_mm2, &f.read_pj, &f.write_pj, &f.leak_mw}) *each *= columns;
  return f;
}

std::array<double, 6> SramLaw::worst(const std::string& name) const {
  std::array<double, 6> result{};
  const Kind& kind = kinds_.at(name);
  for (const Row& row : kind.rows) {
    const std::array<double, 6> f = evaluate(kind, row.bytes, row.width, row.two_ports);
    for (size_t i = 0; i < 6; ++i) result[i] = std::max(result[i], std::abs(f[i] / row.figures[i] - 1));
  }
  return result;
}

std::array<double, 6> SramLaw::mean(const std::string& name) const {
  std::array<double, 6> result{};
  const Kind& kind = kinds_.at(name);
  for (const Row& row : kind.rows) {
    const std::array<double, 6> f = evaluate(kind, row.bytes, row.width, row.two_ports);
    for (size_t i = 0; i < 6; ++i)
      result[i] += std::abs(f[i] / row.figures[i] - 1) / static_cast<double>(kind.rows.size());
  }
  return result;
}

}  // namespace pipegs
