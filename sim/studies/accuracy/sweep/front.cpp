// SPDX-License-Identifier: Apache-2.0
// front.cpp: see front.hpp.
#include "sim/studies/accuracy/sweep/front.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <tuple>

namespace pipegs {
namespace {

constexpr double kBufferShares[] = {0.01, 1};  // of the two paths, beside a share of cycles of 1
constexpr double kValueShare = 1e-4;
constexpr double kLowest = 36;        // decibels: below, nothing is worth measuring
constexpr double kCycleStep = 0.005;  // smaller differences of cycles are chance
constexpr double kLossStep = 0.002;   // and of the squared error, beside the base's: 0.01 dB
constexpr double kFinest = 0.02;      // of the base's squared error: no prediction goes below

// What a value of a knob adds to the base's squared error, and what it costs beside the others.
struct Choice {
  size_t value;
  double loss, cost;
};

// The values worth having of one knob, the most accurate first: each next one loses more and costs less.
std::vector<Choice> choices(const MeasuredPoint& base, const SweptKnob& swept, double buffer_share) {
  const auto loss = [&](const Accuracy& a) {
    return mean_square(a.numeric.psnr) + (swept.knob->orders ? mean_square(a.order.psnr) : 0);
  };
  std::vector<Choice> all;
  for (size_t i = 0; i < swept.points.size(); ++i) {
    const Accuracy& a = swept.points[i].figures;
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
  std::vector<Choice> kept;
  for (const Choice& choice : all) {
    if (kept.empty() || choice.cost < kept.back().cost) kept.push_back(choice);
  }
  return kept;
}

struct Step {
  Config config;
  double decibels;  // predicted
};

class Path {
 public:
  Path(const MeasuredPoint& base, const std::vector<SweptKnob>& knobs, double buffer_share) : base_(base) {
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
      for (const std::string& setting : swept_[k]->values[choices_[k][at_[k]].value]->settings)
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

  const MeasuredPoint& base_;
  std::vector<const SweptKnob*> swept_;
  std::vector<std::vector<Choice>> choices_;
  std::vector<size_t> at_;
};

}  // namespace

std::vector<Config> together_path(const MeasuredPoint& base, const std::vector<SweptKnob>& knobs, int count) {
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

bool has_cost(const MeasuredPoint& point, Cost cost) {
  if (cost == Cost::kTime) return point.silicon && point.silicon->path_fo4;
  return point.silicon.has_value() || (cost != Cost::kArea && cost != Cost::kEnergy);
}

double cost_of(const MeasuredPoint& point, Cost cost) {
  switch (cost) {
    case Cost::kCycles: return static_cast<double>(point.figures.cycles);
    case Cost::kTime: return point.silicon->us;
    case Cost::kBytes: return static_cast<double>(point.figures.bytes);
    case Cost::kBuffers: return point.figures.buffer_kb();
    case Cost::kArea: return point.silicon->mm2.mid;
    default: return point.silicon->joules();
  }
}

bool reaches(const Accuracy& figures, double decibels) {
  return figures.failure.empty() && figures.numeric.psnr >= decibels &&
         figures.order.psnr >= std::min(decibels, kOrderFloor);
}

std::vector<const MeasuredPoint*> pareto_front(const std::vector<MeasuredPoint>& points, Cost cost) {
  std::vector<const MeasuredPoint*> sorted, front;
  for (const MeasuredPoint& point : points) {
    if (has_cost(point, cost) && reaches(point.figures, point.figures.numeric.psnr)) sorted.push_back(&point);
  }
  std::stable_sort(sorted.begin(), sorted.end(), [&](const MeasuredPoint* a, const MeasuredPoint* b) {
    const double ca = cost_of(*a, cost), cb = cost_of(*b, cost);
    return ca != cb ? ca < cb : a->figures.numeric.psnr > b->figures.numeric.psnr;
  });
  for (const MeasuredPoint* point : sorted) {
    if (front.empty() || point->figures.numeric.psnr > front.back()->figures.numeric.psnr) front.push_back(point);
  }
  return front;
}

const MeasuredPoint* cheapest(const std::vector<MeasuredPoint>& points, double decibels) {
  uint64_t fewest = ~uint64_t{0};
  for (const MeasuredPoint& point : points) {
    if (reaches(point.figures, decibels)) fewest = std::min(fewest, point.figures.cycles);
  }
  const MeasuredPoint* best = nullptr;
  for (const MeasuredPoint& point : points) {
    if (!reaches(point.figures, decibels) ||
        static_cast<double>(point.figures.cycles) > 1.01 * static_cast<double>(fewest))
      continue;
    const auto rank = [](const MeasuredPoint& p) {
      return std::tuple(p.figures.buffer_bits, p.figures.bytes, p.figures.cycles);
    };
    if (best == nullptr || rank(point) < rank(*best)) best = &point;
  }
  return best;
}

}  // namespace pipegs
