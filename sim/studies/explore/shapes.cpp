// SPDX-License-Identifier: Apache-2.0
// shapes.cpp: see shapes.hpp.
#include "sim/studies/explore/shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pipegs {
namespace {

constexpr double kLeast = 1e-4;     // a smaller gain is none: a thousandth of the time over a tenth of the area
constexpr double kNoneThere = 2;    // where nothing so small was measured, the front counts as this much slower
constexpr size_t kRound = 4;        // shapes of a round, at most
constexpr size_t kRoundWithin = 2;  // of these, for the best within the wanted area

bool belongs(const Config& config, const ShapeEntry& entry) {
  if (entry.member == &Config::nearest_nodes || entry.member == &Config::mark_chunks) return config.has_watermarks();
  if (entry.member == &Config::bus_w) return config.bus_w != 0;
  return entry.member != &Config::window || config.window >= 64;
}

bool legal(const Config& config) {
  try {
    config_check(config);
  } catch (const ConfigError&) { return false; }
  return true;
}

// The configuration with the entry at this value; itself when there is no such machine.
Config with_shape(const Config& config, const ShapeEntry& entry, int value) {
  Config changed = config;
  changed.*entry.member = value;
  changed.fronts = changed.pu_fronts();
  return belongs(config, entry) && legal(changed) ? changed : config;
}

struct ShapeCandidate {
  Config config;
  double us, mm2, gain;  // predicted
};

class ShapeSweep {
 public:
  ShapeSweep(const MeasurePoints& measure, const FrameModel& silicon, const ShapeOptions& options)
      : measure_(measure), silicon_(silicon), options_(options) {}

  std::vector<Point> run(const Config& base) {
    add("base", {{.knob = kBase, .value = {}, .config = base}});
    std::vector<Point> alone;
    for (const Neighbour& one : known_neighbours(base)) {
      alone.push_back(
          {.knob = one.entry->name, .value = {.label = fmt::format("{}", one.value)}, .config = one.config});
    }
    add("alone", alone);
    for (std::vector<Point> round = next(); !round.empty(); round = next()) add("together", round);
    return std::move(shapes_);
  }

 private:
  // Those whose area is known.
  std::vector<Neighbour> known_neighbours(const Config& config) const {
    std::vector<Neighbour> found = neighbours(config);
    std::erase_if(found, [&](const Neighbour& one) { return !silicon_.area().knows(one.config); });
    return found;
  }

  // As many of them as may be measured.
  void add(const char* stage, std::vector<Point> points) {
    points.resize(std::min(points.size(), options_.runs - std::min<size_t>(options_.runs, shapes_.size())));
    measure_(stage, points);
    must_fit(points);
    shapes_.insert(shapes_.end(), points.begin(), points.end());
    number_front(shapes_, shape_front(shapes_));
  }

  const Point* find(const Config& config) const {
    const auto found =
        std::find_if(shapes_.begin(), shapes_.end(), [&](const Point& shape) { return shape.config == config; });
    return found == shapes_.end() ? nullptr : &*found;
  }

  // What the base takes with one entry at this value; null when that was not measured.
  const Point* alone(const ShapeEntry& entry, int value) const {
    return find(with_shape(shapes_.front().config, entry, value));
  }

  // What the front would gain, up to the wanted area or its own largest: relative time, summed over relative area.
  double gain(double us, double mm2) const {
    const std::vector<const Point*> front = shape_front(shapes_);
    const double end = std::max(options_.mm2, front.back()->mm2());
    double sum = 0, from = mm2, slowest = kNoneThere * front.front()->silicon->us;
    for (size_t i = 0; i <= front.size(); ++i) {
      const double to = i < front.size() ? front[i]->mm2() : end;
      if (to > from) sum += std::max(0.0, std::log(slowest / us)) * std::log(to / from), from = to;
      if (i < front.size()) slowest = front[i]->silicon->us;
    }
    return sum;
  }

  std::vector<ShapeCandidate> candidates() const {
    std::vector<ShapeCandidate> found;
    for (const Point* origin : shape_front(shapes_)) {
      for (const Neighbour& one : known_neighbours(origin->config)) {
        const Point *then = alone(*one.entry, one.value), *now = alone(*one.entry, origin->config.*one.entry->member);
        if (then == nullptr || now == nullptr || find(one.config) != nullptr) continue;
        const double ratio = then->cycles() / now->cycles();
        const auto cycles = static_cast<uint64_t>(origin->cycles() * ratio);
        const FrameCost cost = silicon_.cost(one.config, cycles, origin->figures.bytes).value();
        found.push_back({one.config, cost.us, cost.mm2.mid, gain(cost.us, cost.mm2.mid)});
      }
    }
    return found;
  }

  std::vector<Point> next() const {
    std::vector<Point> round;
    if (shapes_.size() >= static_cast<size_t>(options_.runs)) return round;
    std::vector<ShapeCandidate> found = candidates();
    const auto take = [&](const ShapeCandidate& one, size_t most) {
      const bool known =
          std::any_of(round.begin(), round.end(), [&](const Point& other) { return other.config == one.config; });
      if (!known && round.size() < most) round.push_back({.knob = kTogether, .value = {}, .config = one.config});
    };
    const Point* best = best_within(shapes_, options_.mm2);
    const auto by_time = [](const ShapeCandidate& a, const ShapeCandidate& b) { return a.us < b.us; };
    std::stable_sort(found.begin(), found.end(), by_time);
    for (const ShapeCandidate& one : found) {
      const bool better = best == nullptr || one.us < (1 - kLeast) * best->silicon->us;
      if (better && one.mm2 <= options_.mm2) take(one, kRoundWithin);
    }
    const auto by_gain = [](const ShapeCandidate& a, const ShapeCandidate& b) { return a.gain > b.gain; };
    std::stable_sort(found.begin(), found.end(), by_gain);
    for (const ShapeCandidate& one : found) {
      if (one.gain > kLeast) take(one, kRound);
    }
    return round;
  }

  const MeasurePoints& measure_;
  const FrameModel& silicon_;
  const ShapeOptions options_;
  std::vector<Point> shapes_;
};

}  // namespace

const std::vector<ShapeEntry>& shape_entries() {
  static const std::vector<ShapeEntry> kEntries = {
      {"units", &Config::units, {1, 2, 4, 8}},
      {"fronts", &Config::fronts, {1, 2, 4}},
      {"window", &Config::window, {64, 128}},
      {"occlusion", &Config::occlusion, {0, 1}},
      {"tests", &Config::tests, {1, 2}},
      {"pace", &Config::pace, {4, 8}},
      {"records", &Config::records, {704, 1024, 1408, 2048, 2816}},
      {"bucket_bits", &Config::bucket_bits, {3, 4, 5, 6, 7}},
      {"nearest_nodes", &Config::nearest_nodes, {256, 512, 1024, 2048}},
      {"mark_chunks", &Config::mark_chunks, {4, 7, 8, 12}},
      {"bus_w", &Config::bus_w, {128, 256, 512}},
  };
  return kEntries;
}

std::vector<Neighbour> neighbours(const Config& config) {
  std::vector<Neighbour> found;
  Config self = config;
  self.fronts = self.pu_fronts();
  for (const ShapeEntry& entry : shape_entries()) {
    for (const int value : entry.values) {
      const Config changed = with_shape(self, entry, value);
      const bool known = changed == self || std::any_of(found.begin(), found.end(), [&](const Neighbour& other) {
                           return other.config == changed;
                         });
      if (!known) found.push_back({changed, &entry, value});
    }
  }
  return found;
}

void check_shapes(const Config& base, const FrameModel& silicon) {
  if (silicon.area().knows(base)) return;
  throw ConfigError(
      "synth/data/points.csv has no machine of this kind: a line in synth/data/points.txt, then synth/depends.py and "
      "synth/points.py, add one");
}

std::vector<Point> sweep_shapes(const MeasurePoints& measure, const FrameModel& silicon, const Config& base,
                                const ShapeOptions& options) {
  Config self = base;
  self.fronts = self.pu_fronts();
  return ShapeSweep(measure, silicon, options).run(self);
}

std::vector<const Point*> shape_front(const std::vector<Point>& shapes) {
  return front_of(
      shapes, [](const Point& p) { return p.mm2(); }, [](const Point& p) { return p.silicon->us; });
}

const Point* best_within(const std::vector<Point>& shapes, double mm2) {
  const Point* best = nullptr;
  const auto rank = [](const Point& shape) { return std::tuple(shape.silicon->us, shape.mm2()); };
  for (const Point& shape : shapes) {
    if (shape.mm2() <= mm2 && (best == nullptr || rank(shape) < rank(*best))) best = &shape;
  }
  return best;
}

}  // namespace pipegs
