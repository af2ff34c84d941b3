// SPDX-License-Identifier: Apache-2.0
// csv_fuzz: any bytes as a table of three columns: each row has three fields and numbers in range, or an InputError.
#include <cstdlib>

#include "scenes/input_error.hpp"
#include "scenes/text/csv.hpp"
#include "verif/fuzz/keep.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pipegs;
  try {
    Kept<4> kept;
    parse_csv("fuzz.csv", {reinterpret_cast<const char*>(data), size}, "row,cycles,uj", [&](const CsvRow& row) {
      if (row.text("row").size() > size) std::abort();
      if (row.integer<int>("cycles", 1, 1000) > 1000) std::abort();
      if (!std::isfinite(row.real("uj", kPositive))) std::abort();
      kept.add(row.text("row"));
    });
  } catch (const InputError& error) { refused(error); }
  return 0;
}
