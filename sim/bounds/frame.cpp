// SPDX-License-Identifier: Apache-2.0
// frame.cpp: see frame.hpp.
#include "sim/bounds/frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <numeric>
#include <unordered_map>

#include "cpp_model/dopu/dopu_origin.hpp"
#include "cpp_model/float/parallel.hpp"
#include "cpp_model/pu/front/pu_decode.hpp"
#include "cpp_model/pu/rows/pu_rows.hpp"
#include "cpp_model/ru/ru_resolve.hpp"

namespace pipegs {
namespace {

constexpr double kSlack = 1e-9;  // of the double arithmetic of the bounds themselves

// A Gaussian as all windows see it.
struct Entry {
  uint32_t index;
  GaussianBudget budget;
  double error;  // of its power
  Interval color[3];
};

struct Pixel {
  double t = 1, rgb[3] = {};  // the truth
  bool done = false;
  Interval t_run{1, 1}, rgb_run[3];    // of a machine that has not stopped
  Interval t_hull{1, 1}, rgb_hull[3];  // of all, those that may have stopped included
  bool may_run = true, may_have_stopped = false;

  void hold() {  // those that stop here keep what they have
    if (!may_have_stopped) {
      t_hull = t_run;
      std::copy_n(rgb_run, 3, rgb_hull);
    } else {
      widen(t_hull, t_run);
      for (int i = 0; i < 3; ++i) widen(rgb_hull[i], rgb_run[i]);
    }
    may_have_stopped = true;
  }
  static void widen(Interval& a, const Interval& b) { a = {std::min(a.low, b.low), std::max(a.high, b.high)}; }
};

struct Rounding {
  explicit Rounding(const Config& c)
      : weight(weight_rounding(c)),
        color(blend_rounding(c)),
        stop(stop_level(c)),
        top(4 - std::ldexp(1.0, 2 - c.rgb_w)) {}
  double weight, color, stop, top;
};

void blend_truth(Pixel& p, double alpha, const double (&color)[3]) {
  if (p.done || alpha == 0) return;
  const double next = p.t * (1 - alpha);
  if (next < kMinTransmittance) {
    p.done = true;
    return;
  }
  for (int i = 0; i < 3; ++i) p.rgb[i] += alpha * p.t * color[i];
  p.t = next;
}

void blend_interval(const Rounding& r, Pixel& p, Interval alpha, const Interval (&color)[3]) {
  if (!p.may_run || alpha.high == 0) return;
  const Interval weight{std::max(0.0, p.t_run.low * alpha.low - r.weight), p.t_run.high * alpha.high + r.weight};
  const Interval next{p.t_run.low * (1 - alpha.high) - r.weight, p.t_run.high * (1 - alpha.low) + r.weight};
  if (next.low < r.stop) p.hold();
  p.may_run = next.high >= r.stop;
  if (!p.may_run) return;
  for (int i = 0; i < 3; ++i) {
    const double low = p.rgb_run[i].low + std::max(0.0, weight.low * color[i].low - r.color);
    p.rgb_run[i] = {std::min(low, r.top), std::min(p.rgb_run[i].high + weight.high * color[i].high + r.color, r.top)};
  }
  p.t_run = {std::max(next.low, r.stop), std::min(next.high, p.t_run.high)};
}

// A colour in memory. Pixels of 32 bits (ru_unorm) hold it to the nearest of 1023 steps, and at most one.
double stored(const Config& c, double color) {
  if (c.pixel_w == 64) return color;
  constexpr double kSteps = kMostCode;
  return std::min(std::floor(color * kSteps + 0.5), kSteps) / kSteps;
}
Interval stored(const Config& c, Interval color) {
  return {stored(c, color.low - kSlack), stored(c, color.high + kSlack)};
}
// What the truth is of it: not rounded, but no more than a pixel can hold.
double storable(const Config& c, double color) { return c.pixel_w == 64 ? color : std::min(color, 1.0); }

void note(BudgetFigure& figure, double found, double truth, Interval bound) {
  figure.error = std::max(figure.error, std::abs(found - truth));
  figure.bound = std::max({figure.bound, bound.high - truth, truth - bound.low});
  figure.excess = std::max({figure.excess, found - bound.high - kSlack, bound.low - found - kSlack});
}

void join(BudgetFigure& sum, const BudgetFigure& part) {
  sum = {std::max(sum.error, part.error), std::max(sum.bound, part.bound), std::max(sum.excess, part.excess)};
}

// What the machine made of a Gaussian in each part of a window.
using Jobs = std::array<const RowJob*, kParts>;

class Walk {
 public:
  Walk(const Scene& scene, const Camera& camera, const SimulateOptions& options, const Simulation& simulation)
      : simulation_(simulation),
        config_(options.config),
        rounding_(config_),
        rows_(config_),
        near_(options.near_plane) {
    collect(scene, camera, options);
  }
  BudgetReport window(uint64_t x, uint64_t y) const;

 private:
  void collect(const Scene& scene, const Camera& camera, const SimulateOptions& options);
  void splat(const Entry& entry, const Jobs& jobs, const GoldenWindow& window, std::vector<Pixel>& pixels,
             BudgetReport& report) const;

  const Simulation& simulation_;
  const Config& config_;
  Rounding rounding_;
  PuRows rows_;
  double near_;
  std::vector<Entry> entries_;  // by rank
};

void Walk::collect(const Scene& scene, const Camera& camera, const SimulateOptions& options) {
  const PackedScene& packed = simulation_.packed;
  const ProjectionOptions projection{Semantics::kExact, options.near_plane, scene.antialiased, config_.sh_degree};
  BudgetUnits units{.world = std::ldexp(1.0, packed.scene_exponent)};
  for (const Node& chunk : packed.own_chunks()) {
    units.offset = std::ldexp(units.world, static_cast<int>(chunk.offset_exp));
    if (config_.coded()) {
      units.offset = std::ldexp(units.offset, config_.pos_w - Config::offset_code_w());
      const uint64_t least = decode_scale(config_, kNoScale - 1, chunk.scale_max >> config_.scale_m_w);
      units.scale = units.world * scale_value(config_, least);
    }
    units.view =
        std::ldexp(units.world, static_cast<int>(dopu_origin(config_, simulation_.input.frame, chunk, 0, 0).view_exp));
    for (uint64_t slot = chunk.first; slot < chunk.first + chunk.count; ++slot) {
      const uint32_t index = packed.slot_to_index[slot];
      ActivatedGaussian gaussian;
      if (activate(scene, index, gaussian) != Cull::kNone) continue;
      const glm::vec3& dc = scene.gaussians[index].sh_dc;
      GaussianBudget budget =
          gaussian_budget(config_, camera, projection, gaussian, dc, sh_rest_of(scene, index), scene.sh_degree, units);
      if (!budget.truth.visible) continue;
      Entry entry{index, budget, budget.power.total(), {}};
      for (int i = 0; i < 3; ++i) {
        entry.budget.truth.rgb[i] = std::clamp(budget.rgb[i], 0.0, 4.0);
        entry.color[i] = color_interval(config_, budget.rgb[i], budget.color);
      }
      entries_.push_back(std::move(entry));
    }
  }
  const std::vector<uint32_t>& rank = simulation_.golden.rank;
  std::sort(entries_.begin(), entries_.end(),
            [&](const Entry& a, const Entry& b) { return rank[a.index] < rank[b.index]; });
}

void Walk::splat(const Entry& entry, const Jobs& jobs, const GoldenWindow& window, std::vector<Pixel>& pixels,
                 BudgetReport& report) const {
  const TruthProjection& truth = entry.budget.truth;
  const double cut = -std::log2(255.0), one = std::ldexp(1.0, config_.alpha_w);
  // The oriented box (tile_test = 2) ends at three standard deviations: a pixel beyond them may lie in no region.
  const double boxed = config_.oriented() ? std::log2(truth.opacity) - 4.5 * std::numbers::log2e + entry.error
                                          : -std::numeric_limits<double>::infinity();
  const double rgb[3] = {truth.rgb.x, truth.rgb.y, truth.rgb.z};
  const Image& image = simulation_.golden.image;
  bool drawn = false;
  for (int region = 0; region < config_.regions(); ++region) {
    uint16_t codes[kRegionPixels] = {};
    const RowJob* job = jobs[static_cast<size_t>(region_part(config_, region))];
    const int bit = region_bit(config_, region);
    if (job != nullptr && (job->mask >> bit & 1) != 0) pu_region_line(rows_, *job, bit, codes);
    for (int i = 0; i < kRegionPixels; ++i) {
      const int x = static_cast<int>(window.x) * config_.window + 8 * region_x(config_, region) + i % 8;
      const int y = static_cast<int>(window.y) * config_.window + 8 * region_y(config_, region) + i / 8;
      if (x >= image.width || y >= image.height) continue;
      const double power = budget_power(truth, x, y);
      Interval alpha = alpha_interval(config_, power, entry.error);
      if (!entry.budget.certain || power < boxed) alpha.low = 0;
      if (alpha.high == 0 && codes[i] == 0) continue;
      Pixel& pixel = pixels[static_cast<size_t>(region) * kRegionPixels + i];
      const double exact = power >= cut && truth.depth > near_ ? std::min(kMaxAlpha, std::exp2(power)) : 0;
      drawn = true;
      ++report.pairs;
      report.vacuous += !std::isfinite(entry.error);
      const double before = report.alpha.excess;
      note(report.alpha, codes[i] / one, exact, alpha);
      if (report.alpha.excess > before && !report.first) {
        report.first = fmt::format(
            "pixel {},{}: alpha of Gaussian {} is {}, truth {:.9f}, bound {:.9f} to {:.9f}, power {:.6f} +- {:.3g}", x,
            y, entry.index, codes[i] / one, exact, alpha.low, alpha.high, power, entry.error);
      }
      blend_truth(pixel, exact, rgb);
      blend_interval(rounding_, pixel, alpha, entry.color);
    }
  }
  if (drawn && std::isfinite(entry.error)) report.power_bound = std::max(report.power_bound, entry.error);
}

BudgetReport Walk::window(uint64_t wx, uint64_t wy) const {
  const Image& image = simulation_.golden.image;
  const GoldenWindow window = golden_window(simulation_.input, wx, wy);
  std::unordered_map<uint64_t, Jobs> jobs;
  for (const GoldenLayer& layer : window.layers) {
    for (const GoldenSplat& one : layer.splats)
      jobs[simulation_.packed.scene_index(one.splat.index)][one.splat.part] = &one.job;
  }
  BudgetReport report;
  std::vector<Pixel> pixels(static_cast<size_t>(config_.regions()) * kRegionPixels);
  for (const Entry& entry : entries_) {
    const auto found = jobs.find(entry.index);
    splat(entry, found == jobs.end() ? Jobs{} : found->second, window, pixels, report);
  }
  for (size_t i = 0; i < pixels.size(); ++i) {
    const int region = static_cast<int>(i / kRegionPixels), in = static_cast<int>(i % kRegionPixels);
    const int x = static_cast<int>(wx) * config_.window + 8 * region_x(config_, region) + in % 8;
    const int y = static_cast<int>(wy) * config_.window + 8 * region_y(config_, region) + in / 8;
    if (x >= image.width || y >= image.height) continue;
    Pixel& pixel = pixels[i];
    if (pixel.may_run) pixel.hold();
    const size_t at = image.at(x, y);
    const double worst = std::max(report.t.excess, report.color.excess);
    note(report.t, image.transmittance[at], pixel.t, pixel.t_hull);
    for (int k = 0; k < 3; ++k) {
      pixel.rgb_hull[k] = stored(config_, pixel.rgb_hull[k]);
      note(report.color, image.rgb[at][k], storable(config_, pixel.rgb[k]), pixel.rgb_hull[k]);
    }
    if (std::max(report.t.excess, report.color.excess) > worst && !report.first) {
      report.first =
          fmt::format("pixel {},{}: T {:.7f} ({:.7f} to {:.7f}), colour {:.6f} {:.6f} {:.6f} (red {:.6f} to {:.6f})", x,
                      y, image.transmittance[at], pixel.t_hull.low, pixel.t_hull.high, image.rgb[at].x, image.rgb[at].y,
                      image.rgb[at].z, pixel.rgb_hull[0].low, pixel.rgb_hull[0].high);
    }
  }
  return report;
}

}  // namespace

BudgetReport budget_frame(const Scene& scene, const Camera& camera, const SimulateOptions& options,
                          const Simulation& simulation) {
  const Walk walk(scene, camera, options, simulation);
  const Frame& frame = simulation.input.frame;
  const uint64_t columns = frame.raster.windows.last_x - frame.raster.windows.first_x + 1;
  std::vector<BudgetReport> parts(columns * (frame.raster.windows.last_y - frame.raster.windows.first_y + 1));
  parallel_for(parts.size(), 0, [&](size_t i) {
    parts[i] = walk.window(frame.raster.windows.first_x + i % columns, frame.raster.windows.first_y + i / columns);
  });
  BudgetReport sum;
  for (BudgetReport& part : parts) {
    join(sum.alpha, part.alpha), join(sum.t, part.t), join(sum.color, part.color);
    sum.power_bound = std::max(sum.power_bound, part.power_bound);
    sum.pairs += part.pairs, sum.vacuous += part.vacuous;
    if (!sum.first) sum.first = std::move(part.first);
  }
  return sum;
}

}  // namespace pipegs
