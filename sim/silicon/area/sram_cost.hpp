// SPDX-License-Identifier: Apache-2.0
// sram_cost.hpp: what an SRAM costs in 28 nm: area, time, energy of an access, leakage.
//
// Idea    synth/data/sram.csv holds CACTI 7 results for banks of 1 to 64 KB and words of 32 to 256 bits. Of each kind
//         of cell a power law in capacity, width and ports is fitted to each figure; the test
//         `silicon` prints how well it meets the rows. Below 1 KB the law is extrapolated.
// Rule    An SRAM of the machine has a read and a write port, 1R1W, or one for both, 1RW (rtl/lib/pipegs_sram.sv).
//         Words wider than 256 bits are columns of equal width, each a macro of its own.
// Units   mm2, ns, pJ for one access of the whole word, mW at 350 K.
// Errors  InputError: the table is missing or a row is not what it should be.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace pipegs {

struct SramFigures {
  double area_mm2 = 0, access_ns = 0, cycle_ns = 0, read_pj = 0, write_pj = 0, leak_mw = 0;
};

class SramLaw {
 public:
  explicit SramLaw(const std::filesystem::path& csv);

  // Cell and periphery, as in itrs-lstp/itrs-hp.
  std::vector<std::string> kinds() const;
  // A macro of so many bytes, words of `width` bits.
  SramFigures macro(const std::string& kind, double bytes, double width, bool two_ports) const;
  // A memory of the machine: width x depth with a read and a write port, or with one for both.
  SramFigures memory(const std::string& kind, int width, int depth, int ports) const;
  // Largest |law / table - 1| over the rows of a kind, figure by figure as in SramFigures; and the mean.
  std::array<double, 6> worst(const std::string& kind) const;
  std::array<double, 6> mean(const std::string& kind) const;

 private:
  struct Row {
    double bytes, width;
    bool two_ports;
    std::array<double, 6> figures;
  };
  struct Kind {
    std::vector<Row> rows;
    std::array<std::vector<double>, 6> exponents;  // of 1, capacity, width, two ports, in log2
  };
  std::array<double, 6> evaluate(const Kind& kind, double bytes, double width, bool two_ports) const;

  std::map<std::string, Kind> kinds_;
};

}  // namespace pipegs
