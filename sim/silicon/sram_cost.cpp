// sram_cost.cpp: see sram_cost.hpp.
#include "sim/silicon/sram_cost.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "scenes/input_error.hpp"
#include "sim/silicon/least_squares.hpp"

namespace pipegs {
namespace {

constexpr const char* kHeader = "tech_um,cell,periph,size_B,width_b,ports,area_mm2,access_ns,cycle_ns,read_pJ,write_pJ,leak_mW";
constexpr double kNode = 0.028;  // um
constexpr int kWidestMacro = 256;

std::vector<double> terms(double bytes, double width, bool two_ports) { return {1, std::log2(bytes), std::log2(width), two_ports ? 1.0 : 0.0}; }

}  // namespace

SramLaw::SramLaw(const std::filesystem::path& csv) {
  std::ifstream file(csv);
  std::string line;
  if (!std::getline(file, line) || line != kHeader) throw InputError(csv.string(), "line 1", std::string("expected ") + kHeader);
  for (int number = 2; std::getline(file, line); ++number) {
    std::vector<std::string> fields;
    std::stringstream text(line);
    for (std::string field; std::getline(text, field, ',');) fields.push_back(field);
    const auto wrong = [&](const std::string& what) { return InputError(csv.string(), "line " + std::to_string(number), what); };
    if (fields.size() != 12) throw wrong("expected 12 fields, found " + std::to_string(fields.size()));
    const auto value = [&](size_t i) {
      char* end = nullptr;
      const double read = std::strtod(fields[i].c_str(), &end);
      if (*end != '\0' || !(read > 0) || !std::isfinite(read)) throw wrong("field " + std::to_string(i + 1) + ": expected a positive number, found " + quote(fields[i]));
      return read;
    };
    if (fields[5] != "1RW" && fields[5] != "1R1W") throw wrong("ports: expected 1RW or 1R1W, found " + quote(fields[5]));
    if (value(0) != kNode) continue;
    Row row = {value(3), value(4), fields[5] == "1R1W", {}};
    for (size_t i = 0; i < 6; ++i) row.figures[i] = value(6 + i);
    kinds_[fields[1] + "/" + fields[2]].rows.push_back(row);
  }
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

SramFigures SramLaw::memory(const std::string& kind, int width, int depth) const {
  const int columns = (width + kWidestMacro - 1) / kWidestMacro;
  const double column = static_cast<double>(width) / columns;
  SramFigures f = macro(kind, column * depth / 8, column, true);
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
    for (size_t i = 0; i < 6; ++i) result[i] += std::abs(f[i] / row.figures[i] - 1) / static_cast<double>(kind.rows.size());
  }
  return result;
}

}  // namespace pipegs
