// SPDX-License-Identifier: Apache-2.0
// explore.cpp: see explore.hpp.
#include "sim/studies/explore/explore.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <stdexcept>

#include "cpp_model/float/parallel.hpp"
#include "scenes/input_error.hpp"
#include "sim/progress.hpp"

namespace pipegs {

Explorer::Explorer(const View& view, const MeasurementStore& store, const FrameModel& silicon)
    : view_(view), store_(store), silicon_(silicon) {}

std::string Explorer::name(const Config& config, const Less& less) {
  return fmt::format("{} {} {} {} {}", config_difference(config), less.scale, less.without, less.rest, less.lod);
}

void Explorer::operator()(const char* stage, std::vector<Point>& points) {
  std::map<std::string, std::vector<Drawn>> missing;  // by what they share
  size_t count = 0;
  for (const Point& point : points) {
    const auto [place, fresh] = figures_.try_emplace(name(point.config, point.value.less));
    if (!fresh) continue;
    const Less& less = point.value.less;
    const auto read = [&](const nlohmann::ordered_json& json) { return figures_from_json(json, view_.measured()); };
    if (const std::optional<Figures> known = store_.with(view_.key(less)).load(point.config, read))
      place->second = *known, ++resumed;
    else missing[view_.shared(point.config, less)].emplace_back(point.config, less), ++count;
  }
  compute(stage, missing, count);
  for (Point& point : points) {
    point.figures = figures_.at(name(point.config, point.value.less));
    if (!point.figures.empty.empty())
      view_.tell({{"empty_frame", fmt::format("{} {}: {}", point.knob, point.value.label, point.figures.empty)}});
    if (point.figures.failure.empty())
      point.silicon = silicon_.cost(point.config, point.figures.cycles, point.figures.bytes);
  }
}

void Explorer::compute(const char* stage, const std::map<std::string, std::vector<Drawn>>& groups, size_t count) {
  Progress progress(stage);
  const Stopwatch watch;
  std::mutex mutex;
  double done = 0;
  for (const auto& [shared, drawn] : groups) {
    parallel_for(drawn.size(), 0, [&, &drawn = drawn](size_t i) {
      if (interrupted()) throw std::runtime_error("interrupted");
      const auto& [config, less] = drawn[i];
      const Figures figures = view_.measure(config, less);
      store_.with(view_.key(less)).save(config, to_json(figures, view_.measured()));
      const std::lock_guard lock(mutex);
      figures_[name(config, less)] = figures;
      ++computed, ++done;
      progress.update(done / static_cast<double>(count), fmt::format("{:.1f} points/min", 60 * done / watch.seconds()));
    });
  }
}

void must_fit(const std::vector<Point>& points) {
  for (const Point& point : points) {
    if (!point.figures.failure.empty()) throw InputError(point.figures.failure);
  }
}

std::vector<const Point*> front_of(const std::vector<Point>& points, const Quantity& x, const Quantity& y) {
  std::vector<const Point*> sorted, front;
  for (const Point& point : points) {
    if (!std::isnan(x(point)) && !std::isnan(y(point))) sorted.push_back(&point);
  }
  std::ranges::stable_sort(sorted, {}, [&](const Point* point) { return std::pair(x(*point), y(*point)); });
  for (const Point* point : sorted) {
    if (front.empty() || y(*point) < y(*front.back())) front.push_back(point);
  }
  return front;
}

void number_front(std::vector<Point>& points, const std::vector<const Point*>& front) {
  for (Point& point : points) {
    const auto found = std::find(front.begin(), front.end(), &point);
    point.front = found == front.end() ? 0 : static_cast<int>(found - front.begin()) + 1;
  }
}

double mean_square(double psnr) { return std::isinf(psnr) ? 0 : std::pow(10, -psnr / 10); }

}  // namespace pipegs
