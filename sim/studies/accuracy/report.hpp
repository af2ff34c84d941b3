// SPDX-License-Identifier: Apache-2.0
// report.hpp: a sweep as text, CSV, JSON, charts and sentences.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/studies/accuracy/sweep/sweep.hpp"
#include "sim/report/chart.hpp"

namespace pipegs {

std::string accuracy_text(const AccuracySweep& sweep);
std::string accuracy_csv(const AccuracySweep& sweep);
nlohmann::ordered_json accuracy_json(const AccuracySweep& sweep);

// What the knob's last decibel costs: one sentence.
std::string knob_sentence(const SweptKnob& knob);

// The fronts: numeric PSNR over cycles, bytes, buffers, area and energy; over time where a clock is known.
std::vector<Chart> front_charts(const AccuracySweep& sweep);
Chart knob_chart(const SweptKnob& knob);

// mm2 and mJ of a frame with DRAM, mid; with ~ when extrapolated.
std::string area_text(const MeasuredPoint& point);
std::string energy_text(const MeasuredPoint& point);
// GHz that the longest path allows, with ~ when extrapolated, and us of a frame; "-" where no path is known.
std::string clock_text(const MeasuredPoint& point);
std::string time_text(const MeasuredPoint& point);

// "65.2", "inf"
std::string decibels(double psnr);
// The entries in which a configuration differs from the base, "base" if in none.
std::string difference(const Config& config, const Config& base);
// All of a configuration as lines for --config: it is the same one on every design point.
std::string config_file(const Config& config, const std::string& comment);

}  // namespace pipegs
