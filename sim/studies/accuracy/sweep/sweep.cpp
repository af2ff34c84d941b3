// SPDX-License-Identifier: Apache-2.0
// sweep.cpp: see sweep.hpp.
#include "sim/studies/accuracy/sweep/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <stdexcept>

#include "cpp_model/float/parallel.hpp"
#include "scenes/input_error.hpp"
#include "sim/progress.hpp"
#include "sim/studies/accuracy/accuracy_json.hpp"

namespace pipegs {
namespace {

// What has been measured, by configuration.
class Measured {
 public:
  Measured(const AccuracyView& view, const MeasurementStore& store, bool resume)
      : view_(view), store_(store), resume_(resume) {}

  const Accuracy& at(const Config& config) const { return figures_.at(config_difference(config)); }

  // Measures what is not yet there.
  void add(const char* stage, const std::vector<Config>& configs) {
    std::map<std::string, Config> missing;
    for (const Config& config : configs) {
      const std::string name = config_difference(config);
      if (figures_.contains(name)) continue;
      const std::optional<Accuracy> known = resume_ ? store_.load(config, accuracy_from_json) : std::nullopt;
      if (known) figures_[name] = *known, ++kept;
      else missing.emplace(name, config);
    }
    const std::vector<std::pair<std::string, Config>> work(missing.begin(), missing.end());
    Progress progress(stage);
    const Stopwatch watch;
    size_t done = 0;
    parallel_for(work.size(), 0, [&](size_t i) {
      if (interrupted()) throw std::runtime_error("interrupted");
      const Accuracy accuracy = view_.measure(work[i].second);
      store_.save(work[i].second, to_json(accuracy));
      const std::lock_guard lock(mutex_);
      figures_[work[i].first] = accuracy;
      ++computed, ++done;
      progress.update(static_cast<double>(done) / static_cast<double>(work.size()),
                      fmt::format("{:.1f} points/min", 60 * static_cast<double>(done) / watch.seconds()));
    });
  }

  size_t computed = 0, kept = 0;

 private:
  const AccuracyView& view_;
  const MeasurementStore& store_;
  const bool resume_;
  std::map<std::string, Accuracy> figures_;
  std::mutex mutex_;
};

// The values of a knob that are legal on the base; the figures come later.
SweptKnob swept(const AccuracyView& view, const Config& base, const Knob& knob, std::vector<std::string>& skipped) {
  SweptKnob result{.knob = &knob, .values = {}, .points = {}};
  for (const KnobValue& value : knob.values) {
    try {
      const Config config = with_value(base, value);
      if (!view.can_show(config)) throw ConfigError("with --window its side is fixed");
      result.values.push_back(&value);
      result.points.push_back({config, {}});
    } catch (const ConfigError& error) {
      skipped.push_back(fmt::format("{} {}: {}", knob.name, value.label, error.what()));
    }
  }
  return result;
}

}  // namespace

std::vector<MeasuredPoint> AccuracySweep::all() const {
  std::vector<MeasuredPoint> points = {base};
  const auto add = [&](const MeasuredPoint& point) {
    const bool known = std::any_of(points.begin(), points.end(),
                                   [&](const MeasuredPoint& other) { return other.config == point.config; });
    if (!known) points.push_back(point);
  };
  for (const SweptKnob& knob : knobs) {
    for (const MeasuredPoint& point : knob.points) add(point);
  }
  for (const MeasuredPoint& point : together) add(point);
  return points;
}

AccuracySweep accuracy_sweep(const AccuracyView& view, const MeasurementStore& store, const FrameModel& silicon,
                             const Config& config, const SweepOptions& options) {
  const Stopwatch watch;
  Measured measured(view, store, options.resume);
  const auto point = [&](const Config& one) {
    const Accuracy& figures = measured.at(one);
    return MeasuredPoint{one, figures,
                         figures.failure.empty() ? silicon.cost(one, figures.cycles, figures.bytes) : std::nullopt};
  };
  AccuracySweep sweep{.base = {config, {}}, .flips_sampled = view.flips_sampled()};
  measured.add("base", {config});
  sweep.base = point(config);
  if (!sweep.base.figures.failure.empty()) throw InputError(sweep.base.figures.failure);

  std::vector<Config> alone;
  for (const Knob* knob : options.knobs) {
    sweep.knobs.push_back(swept(view, config, *knob, sweep.skipped));
    for (const MeasuredPoint& point : sweep.knobs.back().points) alone.push_back(point.config);
  }
  measured.add("alone", alone);
  for (SweptKnob& knob : sweep.knobs) {
    for (MeasuredPoint& one : knob.points) one = point(one.config);
  }

  const std::vector<Config> path = together_path(sweep.base, sweep.knobs, options.points);
  measured.add("together", path);
  for (const Config& one : path) sweep.together.push_back(point(one));
  sweep.computed = measured.computed;
  sweep.kept = measured.kept;
  sweep.seconds = watch.seconds();
  return sweep;
}

}  // namespace pipegs
