// SPDX-License-Identifier: Apache-2.0
// knobs.cpp: the table of knobs; see knobs.hpp.
#include "sim/studies/explore/knobs.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pipegs {
namespace {

// A knob that is one entry.
Knob entry(const std::string& name, const std::string& what, const std::vector<int>& values, bool orders = false) {
  Knob knob{.name = name, .what = what, .values = {}, .orders = orders};
  for (const int value : values) knob.values.push_back({fmt::format("{}", value), {fmt::format("{}={}", name, value)}});
  return knob;
}

KnobValue below(int pixels) {
  return {.label = fmt::format("{} px", pixels), .settings = {"lod=1"}, .less = {.lod = 1.0 * pixels}};
}

std::vector<Knob> table() {
  return {
      // The power of a pixel.
      entry("coeff_f", "fraction bits of the six coefficients of a footprint", {20, 22, 24, 26, 28, 30}),
      entry("power_f", "fraction bits of the Row Units' accumulators", {12, 14, 16, 18, 20, 24}),
      {.name = "anchor",
       .what = "where differences start: once per footprint in its window (CoeffF = PowerF, exact from there on), or "
               "afresh, rounded once, in each 8x8 region",
       .values = {{"footprint 20", {"coeff_f=20", "power_f=20"}},
                  {"footprint 24", {"coeff_f=24", "power_f=24"}},
                  {"region 24/20", {"coeff_f=24", "power_f=20"}},
                  {"region 28/20", {"coeff_f=28", "power_f=20"}}},
       .together = false},
      entry("window", "side of a window in pixels: how far a footprint's anchor is from its pixels", {64, 32, 16}),
      entry("mean_f", "fraction bits of a projected mean", {6, 8, 10, 12, 14}),
      entry("mantissa_w", "mantissa bits of the projection", {18, 20, 22, 24, 26, 28}),
      // Alpha and blending.
      entry("exp_index_w", "index bits of the exp2 table", {3, 4, 5, 6, 8}),
      {.name = "exp_linear",
       .what = "the exp2 table alone, or chords between its entries (a multiplier a pixel)",
       .values = {{"table 64", {"exp_linear=0", "exp_index_w=6"}},
                  {"table 256", {"exp_linear=0", "exp_index_w=8"}},
                  {"table 1024", {"exp_linear=0", "exp_index_w=10"}},
                  {"chords 8", {"exp_linear=1", "exp_index_w=3"}},
                  {"chords 64", {"exp_linear=1", "exp_index_w=6"}}},
       .together = false},
      entry("alpha_w", "bits of alpha", {6, 7, 8, 9, 10, 12}),
      entry("t_w", "bits of transmittance", {14, 16, 19, 22, 24}),
      entry("color_w", "bits of a Gaussian's colour", {8, 10, 12, 14, 16}),
      entry("rgb_w", "bits of the accumulated colour", {10, 12, 14, 16}),
      entry("alpha_cut", "a pixel counts from alpha 1 / this on (the truth: 255)", {64, 128, 255, 512, 1023}),
      entry("t_cut", "a pixel stops before its transmittance falls below 1 / this (the truth: 10000)",
            {100, 1000, 10000, 100000}),
      // Order.
      entry("depth_w", "bits of the depth key", {13, 16, 20, 24, 30}, true),
      {.name = "layers",
       .what = "the grid's layers along an axis, or the exact order (which needs late = 1)",
       .values = {{"grid 1", layers_of_grid(1)},
                  {"grid 2", layers_of_grid(2)},
                  {"grid 4", layers_of_grid(4)},
                  {"grid 8", layers_of_grid(8)},
                  {"exact", {"late=1", "order=2", "records=2048", "bucket_bits=5", "grid=4"}}},
       .orders = true},
      // The record of a Gaussian.
      entry("pos_w", "bits of a mean's offset in its chunk", {12, 14, 16, 18, 20, 24}),
      entry("quat_w", "bits of a quaternion's component", {10, 12, 14, 16, 18}),
      entry("scale_m_w", "mantissa bits of a scale", {6, 8, 10, 12, 16}),
      entry("opacity_f", "fraction bits of -log2(opacity)", {8, 10, 12, 16}),
      entry("base_w", "bits of SH band 0", {8, 10, 12, 14, 16}),
      entry("sh_m_w", "mantissa bits of SH bands 1 to 3", {6, 7, 8, 9, 11}),
      {.name = "record",
       .what = "all fields of a Gaussian's record; only what no longer fits 256 bits changes the bytes: one record a "
               "line instead of two",
       .values = {{"172 bit", {"pos_w=12", "quat_w=10", "scale_m_w=6", "opacity_f=8", "base_w=8", "sh_m_w=6"}},
                  {"200 bit", {"pos_w=14", "quat_w=12", "scale_m_w=8", "opacity_f=10", "base_w=10", "sh_m_w=8"}},
                  {"227 bit", {"pos_w=17", "quat_w=14", "scale_m_w=10", "opacity_f=11", "base_w=11", "sh_m_w=9"}},
                  {"254 bit", {"pos_w=20", "quat_w=16", "scale_m_w=12", "opacity_f=12", "base_w=12", "sh_m_w=11"}},
                  {"302 bit", {"pos_w=24", "quat_w=18", "scale_m_w=16", "opacity_f=16", "base_w=16", "sh_m_w=11"}}},
       .together = false},
      {.name = "codes",
       .what = "bytes of a Gaussian in memory: 96 hold its fields as they are, 48 hold codes of them",
       .values = {{"48", {"record=48"}}, {"96", {"record=96"}}},
       .together = false},
      // The Gaussians themselves.
      {.name = "proxies",
       .what =
           "merged Gaussians stand for those of a group where these differ by less than so many pixels (which needs "
           "order = 2)",
       .values = {below(4), below(2), below(1), {"none", {"lod=0"}}},
       .together = false},
      entry("sh_degree", "highest SH degree of the colours", {0, 1, 2, 3}),
      entry("tile_test", "regions of a footprint: all of its box, or those that hold a pixel that counts", {0, 1}),
  };
}

}  // namespace

std::vector<std::string> layers_of_grid(int grid) {
  return {"order=0", "tight_boxes=0", "occlusion=0", "lod=0", fmt::format("grid={}", grid)};
}

const std::vector<Knob>& accuracy_knobs() {
  static const std::vector<Knob> knobs = table();
  return knobs;
}

std::vector<const Knob*> find_knobs(const std::vector<std::string>& names) {
  std::vector<const Knob*> found;
  std::string known;
  for (const Knob& knob : accuracy_knobs()) {
    known += (known.empty() ? "" : ", ") + knob.name;
    if (names.empty() || std::find(names.begin(), names.end(), knob.name) != names.end()) found.push_back(&knob);
  }
  for (const std::string& name : names) {
    if (std::none_of(found.begin(), found.end(), [&](const Knob* knob) { return knob->name == name; })) {
      throw ConfigError(fmt::format("--knobs: unknown knob '{}'; known: {}", name, known));
    }
  }
  return found;
}

Config with_value(const Config& base, const KnobValue& value) {
  Config config = base;
  for (const std::string& setting : value.settings) config_set(config, setting);
  config_check(config);
  return config;
}

}  // namespace pipegs
