// SPDX-License-Identifier: Apache-2.0
// trace_fuzz: any bytes as the table of reference runs, which names the traces of the DRAM check: each of them can be
// played, or there is an InputError.
#include <algorithm>
#include <cstdlib>

#include "scenes/input_error.hpp"
#include "sim/memory/dram/check/dram_references.hpp"
#include "sim/memory/dram/check/dram_trace.hpp"
#include "verif/fuzz/keep.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pipegs;
  try {
    Kept<20> kept;
    for (const DramReference& run : parse_dram_references("fuzz.csv", {reinterpret_cast<const char*>(data), size})) {
      const bool named = std::find(kDramTraces.begin(), kDramTraces.end(), run.trace) != kDramTraces.end();
      if (!named || run.max_out < 1 || run.bursts < 1 || !(run.gbps > 0)) std::abort();
      if (dram_reference_timing(run.configuration).burst_bytes() == 0) std::abort();
      kept.add(run.source);
    }
  } catch (const InputError&) { return 0; }
  return 0;
}
