// rung.hpp: the rungs of the paper's ladder (Fig. 8, 9) as configurations of the one machine, and two of our own.
//
// Idea    A rung is what is computed where, and in which order: the entries `late`, `order` and `quadratic` of
//         cpp_model/config.def. Units, widths and memory stay the same from rung to rung. Rungs that cache coefficients
//         (late) have no alpha stores and twice the records in their SUs; what that comes to in bytes: docs/memories.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cpp_model/config.hpp"

namespace pipegs {

struct Rung {
  std::string_view name;
  int late, order, quadratic, records;
  std::string_view what;  // one line
  bool in_paper;
  // What the paper reports of this variant; 0 where its text gives no figure.
  double paper_speedup;   // over Baseline, "up to", Sec. 5.3.2
  double paper_ratio;     // rasterization over sorting time, Sec. 5.3.1
};

// From the paper's baseline upwards.
const std::vector<Rung>& rungs();
std::string rung_names();  // with commas between

// Throws ConfigError, one line that names the known rungs.
const Rung& find_rung(std::string_view name);
std::vector<const Rung*> find_rungs(const std::vector<std::string>& names);  // all of them when there is no name

void apply_rung(const Rung& rung, Config& config);

// The configuration's rung by name, "" when it is none of them.
std::string rung_name(const Config& config);

}  // namespace pipegs
