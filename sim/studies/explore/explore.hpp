// SPDX-License-Identifier: Apache-2.0
// explore.hpp: points of a view's design space, each measured once, and the front of those that no other one beats.
//
// Idea    A point is a knob at a value, on top of a base, and what was measured of it (view.hpp); area, clock and
//         energy are interpolated (frame_model.hpp) and not stored. A question (accuracy.hpp, tradeoff.hpp, shapes.hpp)
//         says which points to measure, alone and then together, and what the answer is.
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/report/measurement_store.hpp"
#include "sim/silicon/frame_model.hpp"
#include "sim/studies/explore/knobs.hpp"
#include "sim/studies/explore/view.hpp"

namespace pipegs {

inline constexpr char kBase[] = "base", kTogether[] = "together";  // in the place of a knob's name

struct Point {
  std::string knob;  // what was turned
  KnobValue value;   // and how far
  Config config;
  Figures figures = {};
  std::optional<FrameCost> silicon = std::nullopt;  // none of a machine whose area is not known
  int front = 0;                                    // its place on the question's front, 1 is the first; 0: beaten

  double cycles() const { return static_cast<double>(figures.cycles); }
  double bytes() const { return static_cast<double>(figures.bytes); }
  double mm2() const { return silicon ? silicon->mm2.mid : std::nan(""); }
  double joules() const { return silicon ? silicon->joules() : std::nan(""); }
  bool clock_known() const { return silicon && silicon->path_fo4; }
  double us() const { return clock_known() ? silicon->us : std::nan(""); }
};

// Adds what was measured to each point, in their order.
using MeasurePoints = std::function<void(const char* stage, std::vector<Point>& points)>;

class Explorer {
 public:
  // All must outlive it.
  Explorer(const View& view, const MeasurementStore& store, const FrameModel& silicon);

  // What the store holds is not measured again; the rest is, several at a time on one core each. Throws
  // std::runtime_error when interrupted; what was measured until then is in the store.
  void operator()(const char* stage, std::vector<Point>& points);

  size_t computed = 0, resumed = 0;  // points measured now, and taken from the store

 private:
  using Drawn = std::pair<Config, Less>;
  static std::string name(const Config& config, const Less& less);
  void compute(const char* stage, const std::map<std::string, std::vector<Drawn>>& groups, size_t count);

  const View& view_;
  const MeasurementStore store_;
  const FrameModel& silicon_;
  std::map<std::string, Figures> figures_;
};

// Throws InputError when one of them does not fit its configuration.
void must_fit(const std::vector<Point>& points);

// Points that no other one beats in both, the least `x` first; of equal ones the first. A quantity that is not a number
// leaves a point out.
using Quantity = std::function<double(const Point&)>;
std::vector<const Point*> front_of(const std::vector<Point>& points, const Quantity& x, const Quantity& y);
// Sets the places of all points.
void number_front(std::vector<Point>& points, const std::vector<const Point*>& front);

// Mean squared error of a PSNR, 0 for equal images.
double mean_square(double psnr);

}  // namespace pipegs
