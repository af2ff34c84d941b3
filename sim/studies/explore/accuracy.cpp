// SPDX-License-Identifier: Apache-2.0
// accuracy.cpp: see accuracy.hpp.
#include "sim/studies/explore/accuracy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <tuple>

namespace pipegs {
namespace {

constexpr double kBufferShares[] = {0.01, 1};  // of the two paths, beside a share of cycles of 1
constexpr double kValueShare = 1e-4;
constexpr double kLowest = 36;        // decibels: below, nothing is measured
constexpr double kCycleStep = 0.005;  // smaller differences of cycles are chance
constexpr double kLossStep = 0.002;   // and of the squared error, beside the base's: 0.01 dB
constexpr double kFinest = 0.02;      // of the base's squared error: no prediction goes below

// What a value of a knob adds to the base's squared error, and what it costs beside the others.
struct Choice {
  size_t value;
  double loss, cost;
};

// The values of one knob that no other beats, the most accurate first: each next one loses more and costs less.
std::vector<Choice> choices(const Point& base, const SweptKnob& swept, double buffer_share) {
  const auto loss = [&](const Figures& a) {
    return mean_square(a.numeric.psnr) + (swept.knob->orders ? mean_square(a.order.psnr) : 0);
  };
  std::vector<Choice> all;
  for (size_t i = 0; i < swept.points.size(); ++i) {
    const Figures& a = swept.points[i].figures;
    if (!a.failure.empty()) continue;
    // A wider record costs a line of memory only where all fields together no longer fit: that is not this knob's
    // alone.
    const bool same_lines = swept.points[i].config.gaussians_per_line() == base.config.gaussians_per_line();
    const double cycles = same_lines ? static_cast<double>(a.cycles) / static_cast<double>(base.figures.cycles) : 1;
    const double buffers = static_cast<double>(a.buffer_bits) / static_cast<double>(base.figures.buffer_bits);
    const double chance = kLossStep * mean_square(base.figures.numeric.psnr);
    all.push_back(
        {i, std::round((loss(a) - loss(base.figures)) / chance) * chance,
         std::round(cycles / kCycleStep) * kCycleStep + buffer_share * buffers + kValueShare * static_cast<double>(i)});
  }
  std::sort(all.begin(), all.end(),
            [](const Choice& a, const Choice& b) { return std::tie(a.loss, a.cost) < std::tie(b.loss, b.cost); });
  std::vector<Choice> unbeaten;
  for (const Choice& choice : all) {
    if (unbeaten.empty() || choice.cost < unbeaten.back().cost) unbeaten.push_back(choice);
  }
  return unbeaten;
}

struct Step {
  Config config;
  double decibels;  // predicted
};

class Path {
 public:
  Path(const Point& base, const std::vector<SweptKnob>& knobs, double buffer_share) : base_(base) {
    for (const SweptKnob& swept : knobs) {
      if (!swept.knob->together || swept.points.empty()) continue;
      swept_.push_back(&swept);
      choices_.push_back(choices(base, swept, buffer_share));
      at_.push_back(0);
    }
  }

  std::vector<Step> walk() {
    std::vector<Step> steps;
    do {
      if (const std::optional<Config> config = legal()) steps.push_back({*config, predicted()});
    } while (advance());
    return steps;
  }

 private:
  // The combination; nothing when its entries do not fit each other.
  std::optional<Config> legal() const {
    Config config = base_.config;
    for (size_t k = 0; k < swept_.size(); ++k) {
      if (choices_[k].empty()) continue;
      for (const std::string& setting : swept_[k]->points[choices_[k][at_[k]].value].value.settings)
        config_set(config, setting);
    }
    try {
      config_check(config);
    } catch (const ConfigError&) { return std::nullopt; }
    return config;
  }

  double predicted() const {
    double sum = mean_square(base_.figures.numeric.psnr) + mean_square(base_.figures.order.psnr);
    for (size_t k = 0; k < choices_.size(); ++k) sum += choices_[k].empty() ? 0 : choices_[k][at_[k]].loss;
    return -10 * std::log10(std::max({sum, kFinest * mean_square(base_.figures.numeric.psnr), 1e-12}));
  }

  // One knob one step coarser: the one that loses least for what it saves.
  bool advance() {
    size_t best = choices_.size();
    double least = 0;
    for (size_t k = 0; k < choices_.size(); ++k) {
      if (at_[k] + 1 >= choices_[k].size()) continue;
      const Choice &now = choices_[k][at_[k]], &next = choices_[k][at_[k] + 1];
      const double price = (next.loss - now.loss) / (now.cost - next.cost);
      if (best == choices_.size() || price < least) best = k, least = price;
    }
    if (best == choices_.size()) return false;
    ++at_[best];
    return true;
  }

  const Point& base_;
  std::vector<const SweptKnob*> swept_;
  std::vector<std::vector<Choice>> choices_;
  std::vector<size_t> at_;
};

// The values of a knob that are legal on the base; the figures come later.
SweptKnob swept(const Config& base, const Knob& knob, bool window_fixed, std::vector<std::string>& skipped) {
  SweptKnob result{.knob = &knob, .points = {}};
  for (const KnobValue& value : knob.values) {
    try {
      const Config config = with_value(base, value);
      if (window_fixed && config.window != base.window) throw ConfigError("with --window its side is fixed");
      result.points.push_back({.knob = knob.name, .value = value, .config = config});
    } catch (const ConfigError& error) {
      skipped.push_back(fmt::format("{} {}: {}", knob.name, value.label, error.what()));
    }
  }
  return result;
}

}  // namespace

std::vector<Point> AccuracySweep::all() const {
  std::vector<Point> points = {base};
  const auto add = [&](const Point& point) {
    const bool known = std::any_of(points.begin(), points.end(), [&](const Point& other) {
      return other.config == point.config && other.value.less == point.value.less;
    });
    if (!known) points.push_back(point);
  };
  for (const SweptKnob& knob : knobs) {
    for (const Point& point : knob.points) add(point);
  }
  for (const Point& point : together) add(point);
  return points;
}

AccuracySweep accuracy_sweep(const MeasurePoints& measure, const Config& config, const SweepOptions& options) {
  std::vector<Point> base = {{.knob = kBase, .value = {}, .config = config}};
  measure("base", base);
  must_fit(base);
  AccuracySweep sweep{.base = base.front(), .knobs = {}, .together = {}, .skipped = {}};

  // All alone at once, so that all cores have work.
  std::vector<Point> alone;
  for (const Knob* knob : options.knobs) {
    sweep.knobs.push_back(swept(config, *knob, options.window_fixed, sweep.skipped));
    alone.insert(alone.end(), sweep.knobs.back().points.begin(), sweep.knobs.back().points.end());
  }
  measure("alone", alone);
  auto measured = alone.begin();
  for (SweptKnob& knob : sweep.knobs) {
    for (Point& point : knob.points) point = *measured++;
  }

  for (const Config& one : together_path(sweep.base, sweep.knobs, options.points)) {
    const std::string number = fmt::format("{}", sweep.together.size() + 1);
    sweep.together.push_back({.knob = kTogether, .value = {.label = number}, .config = one});
  }
  measure("together", sweep.together);
  return sweep;
}

std::vector<Config> together_path(const Point& base, const std::vector<SweptKnob>& knobs, int count) {
  std::vector<Config> chosen;
  for (const double buffer_share : kBufferShares) {
    // Errors add, so the prediction falls from step to step.
    const std::vector<Step> steps = Path(base, knobs, buffer_share).walk();
    const int part = (count + (buffer_share < 1 ? 1 : 0)) / 2;
    if (steps.empty()) continue;
    const double high = steps.front().decibels, low = std::max(kLowest, steps.back().decibels);
    for (int i = 0; i < part; ++i) {
      const double wanted = high - (high - low) * i / std::max(1, part - 1);
      // Of the steps that promise so much the last one costs least.
      const auto after =
          std::find_if(steps.begin(), steps.end(), [&](const Step& step) { return step.decibels < wanted - 1e-9; });
      const Config& config = after == steps.begin() ? steps.front().config : std::prev(after)->config;
      if (std::find(chosen.begin(), chosen.end(), config) == chosen.end()) chosen.push_back(config);
    }
  }
  return chosen;
}

bool reaches(const Figures& figures, double decibels) {
  return figures.failure.empty() && figures.numeric.psnr >= decibels &&
         figures.order.psnr >= std::min(decibels, kOrderFloor);
}

const std::vector<Cost>& costs() {
  static const std::vector<Cost> kCosts = {
      {"cycles", "Accuracy against cycles", "kilocycles of the frame", 1e3, [](const Point& p) { return p.cycles(); }},
      {"time", "Accuracy against time", "us of a frame", 1, [](const Point& p) { return p.us(); }},
      {"bytes", "Accuracy against memory traffic", "MB a frame", 1e6, [](const Point& p) { return p.bytes(); }},
      {"buffers", "Accuracy against buffers", "KB of SRAM", 1, [](const Point& p) { return p.figures.buffer_kb(); }},
      {"area", "Accuracy against area", "mm2 in 28 nm, mid, interpolated", 1, [](const Point& p) { return p.mm2(); }},
      {"energy", "Accuracy against energy", "mJ a frame with DRAM, mid, interpolated", 1e-3,
       [](const Point& p) { return p.joules(); }},
  };
  return kCosts;
}

std::vector<const Point*> accuracy_front(const std::vector<Point>& points, const Cost& cost) {
  const auto good = [&](const Point& p) {
    return reaches(p.figures, p.figures.numeric.psnr) ? cost.of(p) : std::nan("");
  };
  return front_of(points, good, [](const Point& p) { return -p.figures.numeric.psnr; });
}

const Point* cheapest(const std::vector<Point>& points, double decibels) {
  uint64_t fewest = ~uint64_t{0};
  for (const Point& point : points) {
    if (reaches(point.figures, decibels)) fewest = std::min(fewest, point.figures.cycles);
  }
  const Point* best = nullptr;
  for (const Point& point : points) {
    if (!reaches(point.figures, decibels) ||
        static_cast<double>(point.figures.cycles) > 1.01 * static_cast<double>(fewest))
      continue;
    const auto rank = [](const Point& p) {
      return std::tuple(p.figures.buffer_bits, p.figures.bytes, p.figures.cycles);
    };
    if (best == nullptr || rank(point) < rank(*best)) best = &point;
  }
  return best;
}

}  // namespace pipegs
