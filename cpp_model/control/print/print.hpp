// SPDX-License-Identifier: Apache-2.0
// print.hpp: the table of registers in the languages of those who read it, each as the text of a file or its end.
//
// What depends on the configuration: widths (package, CSV; package/registers.py makes SystemRDL and IP-XACT of the
// CSV). The C header does not: one driver for all.
// The hash of the configuration, which each of its entries changes, stands in the package alone.
#pragma once

#include <string>

#include "cpp_model/control/registers.hpp"

namespace pipegs {

std::string print_package(const RegisterMap& map);  // the end of rtl/pipegs_pkg.sv
std::string print_header(const RegisterMap& map);   // cpp_model/driver/pipegs_registers.h
std::string print_csv(const RegisterMap& map);      // package/pipegs_registers.csv

// Whether a register holds what no text but the package's says.
inline bool only_in_package(const std::string& name) { return name == "CONFIG_HASH"; }

}  // namespace pipegs
