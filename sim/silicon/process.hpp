// SPDX-License-Identifier: Apache-2.0
// process.hpp: from the gates of a library to 28 nm: one NAND2's area, capacitance and leakage, an inverter's delay,
// as ranges.
//
// Idea    A netlist is counted in NAND2 equivalents of its own library, its paths in FO4 delays of its own library, its
//         energy in C V^2 of one NAND2 input of its own library; these cross to another technology better than areas,
//         delays and energies do.
// Trust   Placement, wires, clock tree, scan chains and the rings around macros are in no netlist. `mid` holds none of
//         them, `high` an allowance: docs/silicon/silicon.md says what each bound stands on.
#pragma once

namespace pipegs {

struct Range {
  double low = 0, mid = 0, high = 0;
  Range operator*(double by) const { return {low * by, mid * by, high * by}; }
  Range operator+(const Range& of) const { return {low + of.low, mid + of.mid, high + of.high}; }
};

// um2 of a NAND2 in 28 nm. Low: Nangate's open 45 nm NAND2, 0.798 um2, shrunk by (28/45)^2. Mid: the figure that the
// accelerators' literature divides by. High: mid at a utilisation of 0.78.
inline constexpr Range kNand2Um2 = {0.31, 0.49, 0.63};

// ps of an inverter that drives four: 0.36 and 0.5 ps per nm of gate length are the usual rule's typical and slow ends;
// mid is what fits between them and a low-power process.
inline constexpr Range kFo4Ps = {10, 16, 20};

// fF of one input of a NAND2 in 28 nm: of three open libraries, with the length of the gates. Low: SkyWater's 130 nm
// (sky130hd, 2.3 fF x 28/130). Mid: Nangate's open 45 nm (1.6 fF x 28/45). High: Oklahoma State's 180 nm (osu018, 12.7
// fF x 28/180); it is also mid with wires as heavy as what they join.
inline constexpr Range kNand2InputFf = {0.5, 1.0, 2.0};
inline constexpr double kVolts = 0.9;

// nW of a NAND2 in 28 nm at 350 K: as one bit of a 64 KB memory with its share of the periphery leaks in
// synth/data/sram.csv, cells for low standby power, median, and for speed. Nangate's open 45 nm NAND2 leaks 17 nW at 25
// C.
inline constexpr Range kNand2LeakageNw = {0.05, 12, 31};

// pJ for a bit over the pins. Low: the currents of an LPDDR4-2400's reads and writes of open rows alone. Mid: what
// Accelergy's table takes for LPDDR4. High: LPDDR4 with activations, standby and pins (Ha, Stanford 2018).
inline constexpr Range kDramPjPerBit = {6, 8, 14};

}  // namespace pipegs
