// process.hpp: from the gates of a library to 28 nm: one NAND2's area and an inverter's delay, each as a range.
//
// Idea    A netlist is counted in NAND2 equivalents of its own library and its paths in FO4 delays of its own library;
//         both cross to another technology better than areas and delays do.
// Trust   Placement, wires, clock tree, scan chains and the rings around macros are in no netlist. `mid` holds none of
//         them, `high` an allowance: docs/silicon.md says what each bound stands on.
#pragma once

namespace pipegs {

struct Range {
  double low = 0, mid = 0, high = 0;
  Range operator*(double by) const { return {low * by, mid * by, high * by}; }
  Range operator+(const Range& of) const { return {low + of.low, mid + of.mid, high + of.high}; }
};

// um2 of a NAND2 in 28 nm. Low: Nangate's open 45 nm NAND2, 0.798 um2, shrunk by (28/45)^2. Mid: the figure that the accelerators'
// literature divides by. High: mid at a utilisation of 0.78.
inline constexpr Range kNand2Um2 = {0.31, 0.49, 0.63};

// ps of an inverter that drives four: 0.36 and 0.5 ps per nm of gate length are the usual rule's typical and slow ends; mid is
// what fits between them and a low-power process.
inline constexpr Range kFo4Ps = {10, 16, 20};

}  // namespace pipegs
