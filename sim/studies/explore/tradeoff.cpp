// SPDX-License-Identifier: Apache-2.0
// tradeoff.cpp: see tradeoff.hpp.
#include "sim/studies/explore/tradeoff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/studies/explore/knobs.hpp"

namespace pipegs {
namespace {

constexpr double kWorst = 30;  // dB: below, no prediction is measured

// Points of several knobs at once, and what is predicted of them.
struct Guess {
  std::vector<const Point*> points;
  double error, cycles;
};

// The guesses, and each of them with one of a knob's points on top.
std::vector<Guess> with_knob(const std::vector<Guess>& guesses, const std::vector<const Point*>& knob,
                             const Point& base) {
  std::vector<Guess> result = guesses;
  for (const Point* point : knob) {
    const double share = point->cycles() / base.cycles();
    const double more = std::max(0.0, mean_square(point->figures.total.psnr) - mean_square(base.figures.total.psnr));
    for (Guess guess : guesses) {
      guess.points.push_back(point);
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
  double least = mean_square(kWorst);
  for (const Guess& guess : guesses) {
    if (guess.error >= least) continue;
    least = guess.error;
    result.push_back(guess);
  }
  return result;
}

Point joined(const std::vector<const Point*>& points, const Config& base) {
  KnobValue value;
  for (const Point* point : points) {
    const KnobValue& one = point->value;
    value.label += fmt::format("{}{} {}", value.label.empty() ? "" : ", ", point->knob, one.label);
    value.less.scale *= one.less.scale;
    value.less.without = std::max(value.less.without, one.less.without);
    value.less.rest = std::max(value.less.rest, one.less.rest);
    value.less.lod = std::max(value.less.lod, one.less.lod);
    value.settings.insert(value.settings.end(), one.settings.begin(), one.settings.end());
  }
  return {.knob = kTogether, .value = value, .config = with_value(base, value)};
}

}  // namespace

std::vector<Point> less_alone(const Config& base, const Scene& scene) {
  std::vector<Point> points;
  const auto add = [&](const std::string& knob, const KnobValue& value) {
    points.push_back({.knob = knob, .value = value, .config = with_value(base, value)});
  };
  add(kBase, {.label = "all"});
  add("resolution", {.label = "3/4", .less = {.scale = 0.75}});
  add("resolution", {.label = "1/2", .less = {.scale = 0.5}});
  for (const int percent : {5, 10, 20, 40, 60})
    add("contribution", {.label = fmt::format("-{} %", percent), .less = {.without = percent / 100.0}});
  for (int degree = std::min(scene.sh_degree, base.sh_degree) - 1; degree >= 0; --degree)
    add("SH degree", {.label = std::to_string(degree), .settings = {fmt::format("sh_degree={}", degree)}});
  for (const int rest : {100000, 1000, 100, 20, 10}) {
    if (base.early_stop) add("rest", {.label = fmt::format("1/{}", rest), .less = {.rest = 1.0 / rest}});
  }
  if (base.order == 2 && base.bucket_bits >= Config::error_bits()) {
    for (const double pixels : {0.5, 1.0, 2.0, 4.0})
      add("proxies", {.label = fmt::format("below {} pixels", pixels), .settings = {"lod=1"}, .less = {.lod = pixels}});
  }
  if (!base.coded()) add("record", {.label = "48 bytes", .settings = {"record=48"}});
  for (const int cut : {512, 128, 64}) {
    if (cut != base.alpha_cut)
      add("alpha cut", {.label = fmt::format("1/{}", cut), .settings = {fmt::format("alpha_cut={}", cut)}});
  }
  // Lists have no order to give up.
  for (const int grid : {8, 4, 1}) {
    if (base.order == 1 || (base.order == 0 && grid == base.grid)) continue;
    add("order", {.label = fmt::format("layers of grid {}", grid), .settings = layers_of_grid(grid)});
  }
  return points;
}

std::vector<Point> less_together(const std::vector<Point>& alone, int most) {
  const Point& base = alone.front();
  std::vector<Guess> guesses = {{{}, mean_square(base.figures.total.psnr), base.cycles()}};
  for (auto first = alone.begin() + 1; first != alone.end();) {
    const auto end = std::find_if(first, alone.end(), [&](const Point& one) { return one.knob != first->knob; });
    std::vector<const Point*> knob;
    for (auto point = first; point != end; ++point) {
      if (point->figures.cycles < base.figures.cycles) knob.push_back(&*point);
    }
    guesses = with_knob(guesses, knob, base);
    first = end;
  }
  std::vector<Guess> front = unbeaten(guesses);
  std::erase_if(front, [](const Guess& guess) { return guess.points.size() < 2; });
  // The fastest that is predicted to reach each of `most` levels of decibels.
  std::vector<Point> points;
  if (front.empty() || most == 0) return points;
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
    points.push_back(joined(found->points, base.config));
  }
  return points;
}

std::vector<Point> tradeoff(const MeasurePoints& measure, const Config& base, const Scene& scene, int together) {
  std::vector<Point> points = less_alone(base, scene);
  measure("alone", points);
  must_fit(points);
  std::vector<Point> more = less_together(points, together);
  measure("together", more);
  must_fit(more);
  points.insert(points.end(), more.begin(), more.end());
  find_tradeoff_front(points);
  return points;
}

std::vector<const Point*> find_tradeoff_front(std::vector<Point>& points) {
  std::vector<const Point*> front = front_of(
      points, [](const Point& p) { return p.cycles(); }, [](const Point& p) { return -p.figures.total.psnr; });
  std::reverse(front.begin(), front.end());
  number_front(points, front);
  return front;
}

std::vector<PricedStep> price(const std::vector<const Point*>& front) {
  std::vector<PricedStep> steps;
  if (front.empty()) return steps;
  const Point* from = front.front();
  for (const double level : {50, 40, 30}) {
    const Point* to = from;
    for (const Point* point : front) {
      if (point->figures.total.psnr >= level && point->figures.cycles < to->figures.cycles) to = point;
    }
    const double best = from->figures.total.psnr, saved = from->cycles() - to->cycles();
    if (to == from || !std::isfinite(best)) continue;
    steps.push_back({from, to, saved, saved / (best - to->figures.total.psnr)});
    from = to;
  }
  return steps;
}

}  // namespace pipegs
