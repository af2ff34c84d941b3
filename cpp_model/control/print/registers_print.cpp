// SPDX-License-Identifier: Apache-2.0
// registers_print.cpp: prints a file that follows from the table of registers:
//   registers_print header|csv [key=value ...]
//
// package/machines.py calls it for every design point; a test compares what is committed with its output.
#include <cstdio>
#include <exception>
#include <map>

#include "cpp_model/control/print/print.hpp"

int main(int argc, char** argv) {
  using namespace pipegs;
  const std::map<std::string, std::string (*)(const RegisterMap&)> printers = {{"header", print_header},
                                                                               {"csv", print_csv}};
  const auto printer = printers.find(argc > 1 ? argv[1] : "");
  if (printer == printers.end()) {
    std::fprintf(stderr, "usage: registers_print header|csv [key=value ...]\n");
    return 2;
  }
  try {
    Config config;
    for (int i = 2; i < argc; ++i) config_set(config, argv[i]);
    config_check(config);
    std::fputs(printer->second(register_map(config)).c_str(), stdout);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "registers_print: %s\n", error.what());
    return 2;
  }
}
