// rung.cpp: see rung.hpp.
#include "sim/rung.hpp"

namespace pipegs {

const std::vector<Rung>& rungs() {
  static const std::vector<Rung> kRungs = {
      {.name = "baseline", .late = 1, .order = 1, .quadratic = 1, .records = 2048,
       .what = "preprocess all, list per window, sort, then every pixel's power by the full quadratic form in the RUs",
       .in_paper = true, .paper_speedup = 1, .paper_ratio = 7.48},
      {.name = "dpc", .late = 1, .order = 1, .quadratic = 0, .records = 2048,
       .what = "baseline with the power by differences along rows (DPC)",
       .in_paper = true, .paper_speedup = 0, .paper_ratio = 5.71},
      {.name = "tspp", .late = 0, .order = 1, .quadratic = 0, .records = 1024,
       .what = "dpc with the alphas computed once in the PUs and cached (TSPP): the paper's HGR",
       .in_paper = true, .paper_speedup = 2.33, .paper_ratio = 1.83},
      {.name = "dop", .late = 0, .order = 0, .quadratic = 0, .records = 1024,
       .what = "tspp with layers instead of lists (DOP): the paper's final design",
       .in_paper = true, .paper_speedup = 2.85, .paper_ratio = 0},
      {.name = "late", .late = 1, .order = 0, .quadratic = 0, .records = 2048,
       .what = "layers, but coefficients are cached instead of alphas; the Row Units stand in the RUs",
       .in_paper = false, .paper_speedup = 0, .paper_ratio = 0},
      {.name = "exact", .late = 1, .order = 2, .quadratic = 0, .records = 2048,
       .what = "late with chunks taken nearest first and released by watermarks: depth order without layers",
       .in_paper = false, .paper_speedup = 0, .paper_ratio = 0},
  };
  return kRungs;
}

std::string rung_names() {
  std::string names;
  for (const Rung& rung : rungs()) names += (names.empty() ? "" : ", ") + std::string(rung.name);
  return names;
}

const Rung& find_rung(std::string_view name) {
  for (const Rung& rung : rungs()) {
    if (rung.name == name) return rung;
  }
  throw ConfigError("unknown rung '" + std::string(name) + "'; known: " + rung_names());
}

std::vector<const Rung*> find_rungs(const std::vector<std::string>& names) {
  std::vector<const Rung*> found;
  if (names.empty()) {
    for (const Rung& rung : rungs()) found.push_back(&rung);
  }
  for (const std::string& name : names) {
    const Rung& rung = find_rung(name);
    for (const Rung* other : found) {
      if (other == &rung) throw ConfigError("rung '" + name + "' is named twice");
    }
    found.push_back(&rung);
  }
  return found;
}

void apply_rung(const Rung& rung, Config& config) {
  config.late = rung.late;
  config.order = rung.order;
  config.quadratic = rung.quadratic;
  config.records = rung.records;
}

std::string rung_name(const Config& config) {
  for (const Rung& rung : rungs()) {
    if (rung.late == config.late && rung.order == config.order && rung.quadratic == config.quadratic) return std::string(rung.name);
  }
  return "";
}

}  // namespace pipegs
