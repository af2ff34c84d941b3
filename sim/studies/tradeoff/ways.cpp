// SPDX-License-Identifier: Apache-2.0
// ways.cpp: see ways.hpp.
#include "sim/studies/tradeoff/ways.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pipegs {
namespace {

constexpr double kWorst = 30;  // dB: below, nothing is predicted to be worth a measurement

double squared_error(double psnr) { return std::pow(10, -psnr / 10); }

// Some ways at once, and what is predicted of them.
struct Guess {
  std::vector<const Way*> ways;
  double error, cycles;
};

// The guesses, and each of them with one of a knob's points on top.
std::vector<Guess> with_knob(const std::vector<Guess>& guesses, const std::vector<const TradeoffPoint*>& knob,
                             const TradeoffPoint& base) {
  std::vector<Guess> result = guesses;
  for (const TradeoffPoint* point : knob) {
    const double share = static_cast<double>(point->cycles) / static_cast<double>(base.cycles);
    const double more = std::max(0.0, squared_error(point->psnr) - squared_error(base.psnr));
    for (Guess guess : guesses) {
      guess.ways.push_back(&point->way);
      guess.error += more;
      guess.cycles *= share;
      result.push_back(guess);
    }
  }
  return result;
}

// Those that no other beats, the fastest first.
std::vector<Guess> unbeaten(std::vector<Guess> guesses) {
  std::stable_sort(guesses.begin(), guesses.end(), [](const Guess& a, const Guess& b) { return a.cycles < b.cycles; });
  std::vector<Guess> result;
  double least = squared_error(kWorst);
  for (const Guess& guess : guesses) {
    if (guess.error >= least) continue;
    least = guess.error;
    result.push_back(guess);
  }
  return result;
}

Way joined(const std::vector<const Way*>& ways) {
  Way result{.knob = "together", .label = ""};
  for (const Way* way : ways) {
    result.label += fmt::format("{}{} {}", result.label.empty() ? "" : ", ", way->knob, way->label);
    result.scale *= way->scale;
    result.without = std::max(result.without, way->without);
    result.settings.insert(result.settings.end(), way->settings.begin(), way->settings.end());
  }
  return result;
}

bool beats(const TradeoffPoint& one, const TradeoffPoint& other) {
  return one.cycles <= other.cycles && one.psnr >= other.psnr && (one.cycles < other.cycles || one.psnr > other.psnr);
}

}  // namespace

Config config_of(const Config& base, const Way& way) {
  Config config = base;
  for (const std::string& setting : way.settings) config_set(config, setting);
  config_check(config);
  return config;
}

std::vector<Way> ways_alone(const Config& base, const Scene& scene) {
  std::vector<Way> ways = {{.knob = "base", .label = "all"}};
  ways.push_back({.knob = "resolution", .label = "3/4", .scale = 0.75});
  ways.push_back({.knob = "resolution", .label = "1/2", .scale = 0.5});
  for (const int percent : {5, 10, 20, 40, 60})
    ways.push_back({.knob = "contribution", .label = fmt::format("-{} %", percent), .without = percent / 100.0});
  for (int degree = std::min(scene.sh_degree, base.sh_degree) - 1; degree >= 0; --degree)
    ways.push_back(
        {.knob = "SH degree", .label = std::to_string(degree), .settings = {fmt::format("sh_degree={}", degree)}});
  for (const int cut : {100000, 1000, 100}) {
    if (cut != base.t_cut)
      ways.push_back({.knob = "T cut", .label = fmt::format("1/{}", cut), .settings = {fmt::format("t_cut={}", cut)}});
  }
  for (const int cut : {512, 128, 64}) {
    if (cut != base.alpha_cut)
      ways.push_back(
          {.knob = "alpha cut", .label = fmt::format("1/{}", cut), .settings = {fmt::format("alpha_cut={}", cut)}});
  }
  // Lists have no order to give up.
  for (const int grid : {8, 4, 1}) {
    if (base.order == 1 || (base.order == 0 && grid == base.grid)) continue;
    ways.push_back({.knob = "order",
                    .label = fmt::format("layers of grid {}", grid),
                    .settings = {"order=0", "tight_boxes=0", fmt::format("grid={}", grid)}});
  }
  return ways;
}

std::vector<Way> ways_together(const std::vector<TradeoffPoint>& alone, int most) {
  const TradeoffPoint& base = alone.front();
  std::vector<Guess> guesses = {{{}, squared_error(base.psnr), static_cast<double>(base.cycles)}};
  for (auto first = alone.begin() + 1; first != alone.end();) {
    const auto end = std::find_if(first, alone.end(), [&](const auto& one) { return one.way.knob != first->way.knob; });
    std::vector<const TradeoffPoint*> knob;
    for (auto point = first; point != end; ++point) {
      if (point->cycles < base.cycles) knob.push_back(&*point);
    }
    guesses = with_knob(guesses, knob, base);
    first = end;
  }
  std::vector<Guess> front = unbeaten(guesses);
  std::erase_if(front, [](const Guess& guess) { return guess.ways.size() < 2; });
  // The fastest that is predicted to reach each of `most` levels of decibels.
  std::vector<Way> ways;
  if (front.empty() || most == 0) return ways;
  const auto decibels = [](const Guess& guess) { return -10 * std::log10(guess.error); };
  const double low = decibels(front.front()), high = decibels(front.back());
  size_t taken = front.size();
  for (int i = 0; i < most; ++i) {
    const double level = low + (high - low) * i / std::max(1, most - 1) - 1e-9;
    const auto found =
        std::find_if(front.begin(), front.end(), [&](const Guess& guess) { return decibels(guess) >= level; });
    const auto place = static_cast<size_t>(found - front.begin());
    if (place == taken || found == front.end()) continue;
    taken = place;
    ways.push_back(joined(found->ways));
  }
  return ways;
}

void find_front(std::vector<TradeoffPoint>& points) {
  std::vector<TradeoffPoint*> front;
  for (TradeoffPoint& one : points) {
    one.front = 0;
    if (std::none_of(points.begin(), points.end(), [&](const TradeoffPoint& other) { return beats(other, one); }))
      front.push_back(&one);
  }
  std::stable_sort(front.begin(), front.end(),
                   [](const TradeoffPoint* a, const TradeoffPoint* b) { return a->cycles > b->cycles; });
  for (size_t i = 0; i < front.size(); ++i) front[i]->front = static_cast<int>(i + 1);
}

std::vector<const TradeoffPoint*> front_of(const std::vector<TradeoffPoint>& points) {
  std::vector<const TradeoffPoint*> front;
  for (const TradeoffPoint& point : points) {
    if (point.front > 0) front.push_back(&point);
  }
  std::sort(front.begin(), front.end(),
            [](const TradeoffPoint* a, const TradeoffPoint* b) { return a->front < b->front; });
  return front;
}

}  // namespace pipegs
