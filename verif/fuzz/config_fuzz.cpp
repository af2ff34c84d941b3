// SPDX-License-Identifier: Apache-2.0
// config_fuzz: any bytes as a --config file: its entries are within their ranges, or there is a ConfigError.
#include <cstdlib>

#include "sim/design/config_file.hpp"
#include "verif/fuzz/keep.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pipegs;
  try {
    const std::vector<ConfigLine> lines = parse_config_text("fuzz.cfg", {reinterpret_cast<const char*>(data), size});
    Config config;
    apply_config_lines(lines, config);
    Kept<6> kept;
    for (const ConfigLine& line : lines) kept.add(line.setting);
    for (const ConfigEntry& entry : config_entries(config)) {
      if (entry.member != nullptr && (entry.value < entry.low || entry.value > entry.high)) std::abort();
    }
    config_check(config);
  } catch (const ConfigError& error) { refused(error); }
  return 0;
}
