// SPDX-License-Identifier: Apache-2.0
// fidelity.hpp: the same frame by everything that can tell something of it: how long each takes, and what each gets
// right.
//
// Idea    From the least to the most faithful: float64 truth, golden model, timing model, RTL. Each is held against the
//         RTL's run of the same frame: pixels that differ, cycles, bytes of the memory. Where cycles went (stalls) is
//         in the RTL alone.
// Times   Wall seconds on one core, except for a row that names two threads. Waves are written of one window only, for
//         the file's size; that row's factor is against the RTL on the same window.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/compare/simulate.hpp"

namespace pipegs {

struct FidelityRow {
  std::string name;
  double seconds = 0;
  double ratio = 0;  // seconds / those of the golden model (waves: of the same window without them)
  std::string pixels, cycles, bytes, stalls;  // what it says of them, or "-"
  std::string failure;
};

struct Fidelity {
  bool complete() const;  // every row was run
  std::vector<FidelityRow> rows;
  uint64_t mismatches =
      0;  // RTL against golden, over all runs; and cycles or bytes of the timing model unlike the RTL's
  uintmax_t wave_bytes = 0;
};

// `wave_window` is the window whose waves are written, to `wave_file`, which is removed again.
Fidelity fidelity(const Scene& scene, const Camera& camera, const SimulateOptions& options,
                  std::array<int, 2> wave_window, const std::string& wave_file);

std::string fidelity_text(const Fidelity& fidelity);
nlohmann::ordered_json fidelity_json(const Fidelity& fidelity);

}  // namespace pipegs
