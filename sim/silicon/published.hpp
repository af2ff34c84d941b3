// SPDX-License-Identifier: Apache-2.0
// published.hpp: area and power that others report for 28 nm and 1 GHz, as they print them.
//
// Rule    Nothing is corrected: PipeGS' rows sum to 3.271 mm2 and 0.945 W, its printed totals are 3.283 and 0.948.
#pragma once

#include <array>
#include <string_view>

namespace pipegs {

struct PublishedRow {
  std::string_view unit;
  int count;  // 0: KB
  double kb, area_mm2, power_w;
};

// Paper, Table 2.
inline constexpr std::array<PublishedRow, 6> kPipegsTable2 = {{{"DOPU", 1, 0, 0.001, 0.004},
                                                               {"PU", 4, 0, 1.695, 0.466},
                                                               {"SU", 4, 0, 0.065, 0.068},
                                                               {"RU", 4, 0, 0.472, 0.171},
                                                               {"Buffers", 0, 428, 1.038, 0.236},
                                                               {"Total", 0, 0, 3.283, 0.948}}};

// GSCore (ASPLOS 2024), Table 7. CCU: culling and conversion; QSU, BSU: sorting; VRU: volume rendering.
inline constexpr std::array<PublishedRow, 6> kGscore = {{{"CCU", 4, 0, 0.82, 0.52},
                                                         {"QSU", 8, 0, 0.01, 0.01},
                                                         {"BSU", 4, 0, 0.06, 0.05},
                                                         {"VRU", 64, 0, 1.81, 0.25},
                                                         {"Buffers", 0, 272, 1.25, 0.04},
                                                         {"Total", 0, 0, 3.95, 0.87}}};

}  // namespace pipegs
