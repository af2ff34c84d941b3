// SPDX-License-Identifier: Apache-2.0
// sample.cpp: see sample.hpp.
#include "sim/studies/budget/sample.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "cpp_model/dopu/dopu_origin.hpp"
#include "cpp_model/float/parallel.hpp"
#include "cpp_model/frame_setup.hpp"
#include "cpp_model/golden.hpp"
#include "cpp_model/pu/conic/pu_coeff.hpp"
#include "cpp_model/pu/front/pu_cull.hpp"
#include "cpp_model/pu/pu_parts.hpp"
#include "cpp_model/pu/rows/pu_rows.hpp"
#include "cpp_model/regions.hpp"
#include "scenes/generate/generate_random.hpp"
#include "sim/bounds/budget.hpp"
#include "sim/studies/budget/float.hpp"

namespace pipegs {
namespace {

using generate::Random;

constexpr int kSide = 1024, kPixels = 6;
constexpr double kFocal = 1024, kNear = 0.25;  // exact in every format, and so is a camera at the origin
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Camera sample_camera() {
  Camera camera;
  camera.name = "budget";
  camera.width = camera.height = kSide;
  camera.fx = camera.fy = kFocal;
  camera.cx = camera.cy = kSide / 2;
  return camera;
}

double log_uniform(Random& random, double low, double high) { return low * std::pow(high / low, random.uniform()); }

Scene sample_scene(uint64_t seed, size_t count) {
  Random random(generate::mixed(seed));
  Scene scene;
  for (size_t i = 0; i < count; ++i) {
    const double z = log_uniform(random, 2 * kNear, 256), pixel = z / kFocal;
    const double sigma = log_uniform(random, 0.05, 1000) * pixel, ratio = log_uniform(random, 1, 1e8);
    const double middle = random.bits() % 2 == 0 ? sigma / ratio : log_uniform(random, sigma / ratio, sigma);
    const double u = random.uniform() - 0.5, v = random.uniform() - 0.5;
    Gaussian g{};
    g.mean = {static_cast<float>(u * z), static_cast<float>(v * z), static_cast<float>(z)};
    g.log_scale = {static_cast<float>(std::log(sigma)), static_cast<float>(std::log(middle)),
                   static_cast<float>(std::log(sigma / ratio))};
    for (int k = 0; k < 4; ++k) g.rotation[k] = static_cast<float>(random.normal());
    const double opacity = log_uniform(random, 1.5 / 255, 1);
    g.opacity_logit = static_cast<float>(std::log(opacity) - std::log1p(-opacity));
    scene.gaussians.push_back(g);
  }
  return scene;
}

// What the packed record holds, without activation's normalisation.
ActivatedGaussian held(const PackedScene& packed, const Node& chunk, const GaussianRecord& g) {
  const Config& c = packed.config;
  const auto scaled = [&](int64_t v, int e) { return std::ldexp(static_cast<double>(v), e); };
  const int offset = static_cast<int>(chunk.offset_exp);
  ActivatedGaussian out;
  out.mean = {scaled(chunk.center_x, 0) + scaled(g.offset_x, offset),
              scaled(chunk.center_y, 0) + scaled(g.offset_y, offset),
              scaled(chunk.center_z, 0) + scaled(g.offset_z, offset)};
  out.mean *= std::ldexp(1.0, packed.scene_exponent);
  out.scale = glm::dvec3(scale_value(c, g.scale_0), scale_value(c, g.scale_1), scale_value(c, g.scale_2)) *
              std::ldexp(1.0, packed.scene_exponent);
  out.rotation = glm::dvec4(g.qw, g.qx, g.qy, g.qz) * std::ldexp(1.0, 1 - c.quat_w);
  out.opacity = std::exp2(-scaled(static_cast<int64_t>(g.opacity), -c.opacity_f));
  return out;
}

// The coefficients of a Gaussian where pixel (x, y) of a window lies.
std::optional<RowJob> job_of(const Config& c, const Frame& frame, const Chunk& chunk, const GaussianRecord& gaussian,
                             uint64_t slot, int x, int y) {
  const std::optional<Visible> visible = pu_cull(c, frame, golden_fetched(chunk, gaussian, slot));
  if (!visible) return std::nullopt;
  const uint64_t part = static_cast<uint64_t>(region_part(c, region_at(c, x / 8, y / 8)));
  const std::vector<PuPart> parts = pu_parts(c, golden_conic(c, frame, *visible).conic);
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const PuPart& one) { return one.part == part; });
  if (found == parts.end()) return std::nullopt;
  const Coeff coeff = pu_coeff(c, frame, found->conic);
  if (coeff.dead) return std::nullopt;
  RowJob job;
  job.a = coeff.a, job.b = coeff.b, job.c = coeff.c, job.d = coeff.d, job.e = coeff.e, job.f = coeff.f;
  return job;
}

// A Row Unit's power at pixel (x, y) of the part.
int64_t row_power(const Config& c, const RowJob& job, int x, int y) {
  RowJob one = job;
  const int bit = y / 8 * c.part_regions_x() + x / 8;
  one.mask = uint64_t{1} << bit;
  const Region start = pu_region(c, one, bit);
  Row row = pu_row_init(start, y % 8);
  for (int i = 0; i < x % 8; ++i) row = pu_row_unit(row, start.curve_x);
  return row.power;
}

double alpha_of(double power) { return power >= -std::log2(255.0) ? std::min(kMaxAlpha, std::exp2(power)) : 0; }
double grown(double worst, double error) { return std::isnan(error) ? kInfinity : std::max(worst, error); }

class Sampler {
 public:
  Sampler(const Config& config, uint64_t seed, size_t count)
      : config_(config),
        camera_(sample_camera()),
        scene_(sample_scene(seed, count)),
        packed_(pack_scene(config, scene_, 2 * kNear)),
        chunks_(packed_.own_chunks()),
        frame_(frame_setup(config, packed_, camera_, {}, kNear)),
        alpha_(config) {}
  size_t chunks() const { return chunks_.size(); }
  void chunk(size_t number, uint64_t seed, std::vector<BudgetSample>& samples) const;

 private:
  std::optional<BudgetSample> sample(const Node& node, uint64_t slot, Random& random) const;

  Config config_;
  Camera camera_;
  Scene scene_;
  PackedScene packed_;
  std::vector<Node> chunks_;  // of it
  Frame frame_;
  PuAlpha alpha_;
};

std::optional<BudgetSample> Sampler::sample(const Node& node, uint64_t slot, Random& random) const {
  const GaussianRecord record = packed_.gaussians[slot];
  const uint32_t index = packed_.slot_to_index[slot];
  const ActivatedGaussian exact = held(packed_, node, record);
  ActivatedGaussian wanted;
  if (activate(scene_, index, wanted) != Cull::kNone) return std::nullopt;
  const ProjectionOptions options{Semantics::kExact, kNear, false, 0};
  BudgetUnits units{.world = std::ldexp(1.0, packed_.scene_exponent)};
  units.offset = std::ldexp(units.world, static_cast<int>(node.offset_exp));
  units.view = std::ldexp(units.world, static_cast<int>(dopu_origin(config_, frame_, node, 0, 0).view_exp));
  const GaussianBudget ours = gaussian_budget(config_, camera_, options, exact, {}, nullptr, 0, units, true);
  const GaussianBudget whole = gaussian_budget(config_, camera_, options, wanted, {}, nullptr, 0, units);
  if (!ours.truth.visible || !whole.truth.visible) return std::nullopt;
  const FloatSplat<float> in32 = float_splat<float>(camera_, exact);
  const FloatSplat<half> in16 = float_splat<half>(camera_, exact);

  const TruthProjection& t = ours.truth;
  BudgetSample out;
  const double smallest = std::min({wanted.scale.x, wanted.scale.y, wanted.scale.z}),
               largest = std::max({wanted.scale.x, wanted.scale.y, wanted.scale.z});
  out.ratio = largest / smallest;
  out.sigma = std::sqrt((t.a + t.c) / 2 + std::sqrt((t.a - t.c) * (t.a - t.c) / 4 + t.b * t.b));
  out.bound = ours.power.total(), out.record_bound = whole.power.record;
  int seen = 0;
  // Points of the ellipse of pixels that count: S^1/2 of a disc, by the Cholesky factor of the covariance.
  const double reach = std::sqrt(2 * std::log(255 * t.opacity));
  const double l0 = std::sqrt(t.a), l1 = t.b / l0, l2 = std::sqrt(t.det / t.a);
  for (int i = 0; i < kPixels; ++i) {
    const double far = reach * std::sqrt(random.uniform()), angle = 6.283185307179586 * random.uniform();
    const double px = t.mean.x + l0 * far * std::cos(angle),
                 py = t.mean.y + l1 * far * std::cos(angle) + l2 * far * std::sin(angle);
    const int x = static_cast<int>(std::lround(std::clamp(px, -1.0, kSide + 1.0))),
              y = static_cast<int>(std::lround(std::clamp(py, -1.0, kSide + 1.0)));
    if (x < 0 || y < 0 || x >= kSide || y >= kSide) continue;
    const double power = budget_power(t, x, y);
    if (power < -std::log2(255.0)) continue;
    const std::optional<RowJob> job =
        job_of(config_, frame_, dopu_origin(config_, frame_, node, x / config_.window, y / config_.window), record,
               slot, x % config_.window, y % config_.window);
    if (!job) continue;
    ++seen;
    const int64_t row = row_power(config_, *job, x % config_.part_side(), y % config_.part_side());
    const double error = std::abs(std::ldexp(static_cast<double>(row), -config_.power_f) - power),
                 alpha = std::ldexp(alpha_(row), -config_.alpha_w);
    const double log2_opacity = std::log2(exact.opacity), p32 = in32.power(x, y), p16 = in16.power(x, y);
    out.power = std::max(out.power, error);
    out.power_excess = std::max(out.power_excess, error - out.bound);
    out.power32 = grown(out.power32, std::abs(p32 * std::log2(std::exp(1.0)) + log2_opacity - power));
    out.power16 = grown(out.power16, std::abs(p16 * std::log2(std::exp(1.0)) + log2_opacity - power));
    out.record = std::max(out.record, std::abs(budget_power(whole.truth, x, y) - power));
    const double truth = alpha_of(power);
    const Interval interval = alpha_interval(config_, power, out.bound);
    out.alpha = std::max(out.alpha, std::abs(alpha - truth));
    out.alpha_bound = std::max({out.alpha_bound, interval.high - truth, truth - interval.low});
    out.alpha_excess = std::max({out.alpha_excess, alpha - interval.high, interval.low - alpha});
    out.alpha32 = std::max(out.alpha32, std::abs(in32.alpha(p32) - truth));
    out.alpha16 = std::max(out.alpha16, std::abs(in16.alpha(p16) - truth));
  }
  return seen > 0 ? std::optional(out) : std::nullopt;
}

void Sampler::chunk(size_t number, uint64_t seed, std::vector<BudgetSample>& samples) const {
  const Node& node = chunks_[number];
  Random random(generate::mixed(seed ^ generate::mixed(number)));
  for (uint64_t slot = node.first; slot < node.first + node.count; ++slot) {
    if (const std::optional<BudgetSample> one = sample(node, slot, random)) samples.push_back(*one);
  }
}

}  // namespace

std::vector<BudgetSample> budget_samples(const Config& config, uint64_t seed, size_t count,
                                         const std::function<void(double)>& progress) {
  std::vector<BudgetSample> all;
  for (uint64_t round = 0; all.size() < count; ++round) {
    const Sampler sampler(config, generate::mixed(seed + round),
                          std::clamp<size_t>((count - all.size()) * 5 / 4, 1000, 250000));
    std::vector<std::vector<BudgetSample>> parts(sampler.chunks());
    parallel_for(parts.size(), 0, [&](size_t i) { sampler.chunk(i, seed, parts[i]); });
    for (const std::vector<BudgetSample>& part : parts) all.insert(all.end(), part.begin(), part.end());
    if (progress) progress(std::min(1.0, static_cast<double>(all.size()) / static_cast<double>(count)));
  }
  all.resize(count);
  return all;
}

}  // namespace pipegs
