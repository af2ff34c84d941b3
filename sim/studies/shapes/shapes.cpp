// SPDX-License-Identifier: Apache-2.0
// shapes.cpp: see shapes.hpp.
#include "sim/studies/shapes/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "sim/studies/shapes/neighbours.hpp"

namespace pipegs {
namespace {

constexpr double kWorth = 1e-4;     // a smaller gain is none: a thousandth of the time over a tenth of the area
constexpr double kNoneThere = 2;    // where nothing so small was measured, the front counts as this much slower
constexpr size_t kRound = 4;        // shapes of a round, at most
constexpr size_t kRoundWithin = 2;  // of these, for the best within the wanted area

struct ShapeCandidate {
  Config config;
  double us, mm2, gain;  // predicted
};

class ShapeSweep {
 public:
  ShapeSweep(const FrameModel& silicon, const MeasureShapes& measure, const ShapeOptions& options)
      : silicon_(silicon), measure_(measure), options_(options) {}

  std::vector<Shape> run(const Config& base) {
    add({base}, Shape::Step::kBase);
    std::vector<Config> alone;
    for (const Neighbour& one : neighbours(base)) alone.push_back(one.config);
    add(alone, Shape::Step::kAlone);
    for (std::vector<Config> round = next(); !round.empty(); round = next()) add(round, Shape::Step::kTogether);
    return std::move(shapes_);
  }

 private:
  // As many of them as may be measured.
  void add(std::vector<Config> configs, Shape::Step step) {
    configs.resize(std::min(configs.size(), options_.runs - std::min<size_t>(options_.runs, shapes_.size())));
    const std::vector<EngineResult> frames = measure_(configs);
    for (size_t i = 0; i < configs.size(); ++i) {
      shapes_.push_back({.config = configs[i],
                         .frame = frames.at(i),
                         .cost = silicon_.cost(configs[i], frames[i].cycles, frames[i].bytes).value(),
                         .step = step});
    }
    find_front(shapes_);
  }

  const Shape* find(const Config& config) const {
    const auto found =
        std::find_if(shapes_.begin(), shapes_.end(), [&](const Shape& shape) { return shape.config == config; });
    return found == shapes_.end() ? nullptr : &*found;
  }

  // What the base takes with one entry at this value; null when that was not measured.
  const Shape* alone(const ShapeEntry& entry, int value) const {
    return find(with_shape(shapes_.front().config, entry, value));
  }

  // What the front would gain, up to the wanted area or its own largest: relative time, summed over relative area.
  double gain(double us, double mm2) const {
    const std::vector<const Shape*> front = front_of(shapes_);
    const double end = std::max(options_.mm2, front.back()->mm2());
    double sum = 0, from = mm2, slowest = kNoneThere * front.front()->us();
    for (size_t i = 0; i <= front.size(); ++i) {
      const double to = i < front.size() ? front[i]->mm2() : end;
      if (to > from) sum += std::max(0.0, std::log(slowest / us)) * std::log(to / from), from = to;
      if (i < front.size()) slowest = front[i]->us();
    }
    return sum;
  }

  std::vector<ShapeCandidate> candidates() const {
    std::vector<ShapeCandidate> found;
    for (const Shape* origin : front_of(shapes_)) {
      for (const Neighbour& one : neighbours(origin->config)) {
        const Shape *then = alone(*one.entry, one.value), *now = alone(*one.entry, origin->config.*one.entry->member);
        if (then == nullptr || now == nullptr || find(one.config) != nullptr) continue;
        const double ratio = static_cast<double>(then->frame.cycles) / static_cast<double>(now->frame.cycles);
        const auto cycles = static_cast<uint64_t>(static_cast<double>(origin->frame.cycles) * ratio);
        const FrameCost cost = silicon_.cost(one.config, cycles, origin->frame.bytes).value();
        found.push_back({one.config, cost.us, cost.mm2.mid, gain(cost.us, cost.mm2.mid)});
      }
    }
    return found;
  }

  std::vector<Config> next() const {
    std::vector<Config> round;
    if (shapes_.size() >= static_cast<size_t>(options_.runs)) return round;
    std::vector<ShapeCandidate> found = candidates();
    const auto take = [&](const ShapeCandidate& one, size_t most) {
      const bool known = std::find(round.begin(), round.end(), one.config) != round.end();
      if (!known && round.size() < most) round.push_back(one.config);
    };
    const Shape* best = best_within(shapes_, options_.mm2);
    const auto by_time = [](const ShapeCandidate& a, const ShapeCandidate& b) { return a.us < b.us; };
    std::stable_sort(found.begin(), found.end(), by_time);
    for (const ShapeCandidate& one : found) {
      const bool better = best == nullptr || one.us < (1 - kWorth) * best->us();
      if (better && one.mm2 <= options_.mm2) take(one, kRoundWithin);
    }
    const auto by_gain = [](const ShapeCandidate& a, const ShapeCandidate& b) { return a.gain > b.gain; };
    std::stable_sort(found.begin(), found.end(), by_gain);
    for (const ShapeCandidate& one : found) {
      if (one.gain > kWorth) take(one, kRound);
    }
    return round;
  }

  const FrameModel& silicon_;
  const MeasureShapes& measure_;
  const ShapeOptions options_;
  std::vector<Shape> shapes_;
};

}  // namespace

void check_shapes(const Config& base, const FrameModel& silicon) {
  if (silicon.area().knows(base)) return;
  throw ConfigError(
      "synth/data/points.csv has no machine of this kind: a line in synth/data/points.txt, then synth/depends.py and "
      "synth/points.py, add one");
}

std::vector<Shape> sweep_shapes(const Config& base, const FrameModel& silicon, const MeasureShapes& measure,
                                const ShapeOptions& options) {
  check_shapes(base, silicon);
  Config self = base;
  self.fronts = self.pu_fronts();
  return ShapeSweep(silicon, measure, options).run(self);
}

void find_front(std::vector<Shape>& shapes) {
  std::vector<Shape*> sorted;
  for (Shape& shape : shapes) sorted.push_back(&shape), shape.front = 0;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Shape* a, const Shape* b) {
    return std::tuple(a->mm2(), a->us()) < std::tuple(b->mm2(), b->us());
  });
  const Shape* last = nullptr;
  int place = 0;
  for (Shape* shape : sorted) {
    if (last != nullptr && shape->us() >= last->us()) continue;
    shape->front = ++place;
    last = shape;
  }
}

std::vector<const Shape*> front_of(const std::vector<Shape>& shapes) {
  std::vector<const Shape*> front;
  for (const Shape& shape : shapes) {
    if (shape.front > 0) front.push_back(&shape);
  }
  std::sort(front.begin(), front.end(), [](const Shape* a, const Shape* b) { return a->front < b->front; });
  return front;
}

const Shape* best_within(const std::vector<Shape>& shapes, double mm2) {
  const Shape* best = nullptr;
  for (const Shape& shape : shapes) {
    if (shape.mm2() > mm2) continue;
    if (best == nullptr || std::tuple(shape.us(), shape.mm2()) < std::tuple(best->us(), best->mm2())) best = &shape;
  }
  return best;
}

}  // namespace pipegs
