// SPDX-License-Identifier: Apache-2.0
// ways.hpp: what a frame can do without, what of it is worth doing together, and the front of what was measured.
//
// Idea    Squared errors of different ways add and their shares of the time multiply (nearly): so ways that were
//         measured alone predict every combination. Of those that no other is predicted to beat, a few, evenly spaced
//         in decibels, are measured.
#pragma once

#include <string>
#include <vector>

#include "cpp_model/config.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

struct Way {
  std::string knob;    // what is done without; "together" for several
  std::string label;   // how much of it
  double scale = 1;    // of the picture's sides
  double without = 0;  // share of the Gaussians that is left out
  std::vector<std::string> settings = {};
};

struct TradeoffPoint {
  Way way;
  Config config;
  int width = 0, height = 0;
  uint64_t gaussians = 0, cycles = 0, bytes = 0;
  double psnr = 0, ssim = 0;  // of the picture at full size
  int front = 0;              // place on the front, 1 is the most accurate; 0: beaten
};

// The base's configuration with the way's settings. Throws ConfigError when that is none.
Config config_of(const Config& base, const Way& way);

// Each way that the base and the scene allow, the base itself first. A value that the base has is left out.
std::vector<Way> ways_alone(const Config& base, const Scene& scene);

// At most `most` ways of several knobs, predicted from `alone`, whose first point is the base.
std::vector<Way> ways_together(const std::vector<TradeoffPoint>& alone, int most);

// Sets every point's place.
void find_front(std::vector<TradeoffPoint>& points);
// The points of the front by their places.
std::vector<const TradeoffPoint*> front_of(const std::vector<TradeoffPoint>& points);

}  // namespace pipegs
