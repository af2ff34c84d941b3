// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/train/gradient/drawing: every gradient against central differences of the float64 truth.
//
// Idea    The loss is a random weight times each value of the picture. Each stored number is moved to both sides and
//         render_truth, which shares no line of the way back, is asked for the pictures. The order is held.
// Cuts    They have no gradient: a pixel in which another number of Gaussians is blended in one of the pictures
//         has no weight, and no more than kFewPixels of them may be so. Colours stay off 0, x/z off the guard band and
//         depths off the near plane by more than the step. Nor have pixels in which an alpha is nearly at its
//         cap.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <string>

#include "cpp_model/float/truth.hpp"
#include "sim/studies/train/gradient/drawing.hpp"
#include "sim/studies/train/test/gradient/gaussians.hpp"

namespace pipegs {
namespace {

constexpr double kTolerance = 1e-4;  // of the difference
constexpr double kLeast = 1e-6;      // of the largest of its kind: below is no more than rounding
constexpr double kNearCap = 2e-3;    // of an alpha
constexpr double kFewPixels = 0.05;  // of a picture, without weight

struct Case {
  std::string name;
  Parameters parameters;
  Camera camera;
  DrawOptions options;
};

glm::dvec3 random_vector(std::mt19937& random) {
  const auto uniform = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };
  const double x = uniform(), y = uniform(), z = uniform();
  return {x, y, z};
}

Case with_random(const std::string& name, Parameters parameters, const Camera& camera) {
  return {name, std::move(parameters), camera, {.background = {0.3f, 0.1f, 0.6f}, .threads = 1}};
}

Case random_case() { return with_random("random", random_gaussians(2, 14, 3), askance_camera(40, 30)); }

// A thousand times as long as wide, at every angle, with quaternions of every length.
Case needles() {
  std::mt19937 random(3);
  Parameters p;
  for (int i = 0; i < 10; ++i) {
    const glm::dvec3 axis = random_vector(random);
    const glm::dvec4 rotation = glm::dvec4(axis.x, axis.y, axis.z, 0.4) * (i % 2 != 0 ? 0.25 : 4.0);
    add_gaussian(p, 0.5 * random_vector(random) + glm::dvec3(0, 0, 3), {1, 0.001, 0.002}, rotation, 1,
                 glm::dvec3(0.5) + 0.3 * random_vector(random));
  }
  return with_random("needles", p, small_camera(40, 30, 40));
}

// Hardly behind the near plane, where a Gaussian covers the picture and J is large.
Case near_plane() {
  std::mt19937 random(4);
  Parameters p;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 at = 0.1 * random_vector(random);
    add_gaussian(p, {at.x, at.y, 0.205 + 0.02 * i}, {0.03, 0.01, 0.05}, {1, at.x * 5, at.y * 5, at.z * 5}, -1,
                 glm::dvec3(0.5) + 0.3 * random_vector(random));
  }
  return with_random("near_plane", p, small_camera(40, 30, 40));
}

// Means outside of the picture, beyond 1.3 tan(fov/2): x/z, y/z or both stand still in J.
Case guard_band() {
  Parameters p;
  const glm::dvec3 means[] = {{2.2, 0.1, 2},    {-2.5, 0.2, 2}, {0.3, 2, 2},
                              {0.1, -1.9, 2.1}, {1.9, 1.7, 2},  {0.2, 0.1, 2}};
  std::mt19937 random(5);
  for (const glm::dvec3& mean : means) {
    add_gaussian(p, mean, {0.9, 0.5, 0.7}, {1, 0.3, -0.2, 0.4}, 1, glm::dvec3(0.5) + 0.3 * random_vector(random));
  }
  return with_random("guard_band", p, small_camera(40, 30, 40));
}

Case opaque() {
  std::mt19937 random(6);
  Parameters p;
  for (int i = 0; i < 6; ++i) {
    add_gaussian(p, 0.8 * random_vector(random) + glm::dvec3(0, 0, 3), {0.3, 0.2, 0.4}, {1, 0.2, 0.1, -0.3},
                 5 + 0.5 * i, glm::dvec3(0.5) + 0.3 * random_vector(random));
  }
  return with_random("opaque", p, small_camera(40, 30, 40));
}

// Twenty sheets of alpha 0.2 to 0.7 behind each other: T comes to 1e-4, and what is behind does not count.
Case stopped() {
  std::mt19937 random(7);
  Parameters p;
  for (int i = 0; i < 20; ++i) {
    const glm::dvec3 at = 0.2 * random_vector(random);
    add_gaussian(p, {at.x, at.y, 2 + 0.1 * i}, {2.5, 2, 0.01}, {1, 0.02, 0.03, 0.2}, -1.4 + 0.11 * i,
                 glm::dvec3(0.5) + 0.3 * random_vector(random));
  }
  return with_random("stopped", p, small_camera(40, 30, 40));
}

// In the machine's order, with less SH than there is.
Case layered() {
  static const LayerGrid grid{4, glm::dvec3(-1), glm::dvec3(0.5)};
  Case c = with_random("layered", random_gaussians(8, 14, 3), askance_camera(40, 30));
  c.options.layers = &grid;
  c.options.sh_degree = 2;
  return c;
}

std::vector<std::uint32_t> rank_of(const Case& c) {
  const auto& p = c.parameters;
  std::vector<std::uint32_t> order(p.size()), rank(p.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto place = [&](std::uint32_t i) {
    const double depth = (c.camera.world_to_camera * (glm::dvec3(p.mean[i]) - c.camera.position)).z;
    if (c.options.layers == nullptr) return std::pair(0, depth);
    const int axis = principal_axis(c.camera), slab = c.options.layers->slab(axis, p.mean[i][axis]);
    return std::pair(layers_of_slabs(*c.options.layers, c.camera)[static_cast<std::size_t>(slab)], depth);
  };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return place(a) < place(b); });
  for (std::size_t n = 0; n < order.size(); ++n) rank[order[n]] = static_cast<std::uint32_t>(n);
  return rank;
}

// Of each kind that there is.
std::map<std::string, std::span<float>> floats_of(Parameters& p) {
  std::map<std::string, std::span<float>> all;
  each_array(p, [&](const char* name, auto& values) {
    if (!values.empty())
      all[name] = {reinterpret_cast<float*>(values.data()), values.size() * sizeof(values[0]) / sizeof(float)};
  });
  return all;
}

class DrawingSlopes : public testing::TestWithParam<Case (*)()> {
 protected:
  DrawingSlopes()
      : case_(GetParam()()), rank_(rank_of(case_)), drawing_(case_.parameters, case_.camera, case_.options) {
    std::mt19937 random(1);
    weights_.resize(drawing_.picture().size());
    for (glm::dvec3& weight : weights_) weight = random_vector(random);
    base_ = render();
    leave_out_caps();
  }

  // Takes the weight of pixels in which an alpha is nearly at its cap.
  void leave_out_caps() {
    const Scene scene = scene_of(case_.parameters, "");
    std::size_t left_out = 0;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      const int x = static_cast<int>(i) % case_.camera.width, y = static_cast<int>(i) / case_.camera.width;
      for (const TruthStep& step : explain_truth(scene, case_.camera, truth_options(), x, y)) {
        const double opacity = 1 / (1 + std::exp(-double{case_.parameters.opacity_logit[step.index]}));
        if (std::abs(opacity * std::exp(step.power) - kMaxAlpha) > kNearCap) continue;
        weights_[i] = glm::dvec3(0);
        ++left_out;
        break;
      }
    }
    EXPECT_LE(left_out, static_cast<std::size_t>(kFewPixels * static_cast<double>(weights_.size())));
  }

  TruthOptions truth_options() const {
    TruthOptions options;
    options.rank = &rank_;
    options.threads = 1;
    options.sh_degree = case_.options.sh_degree;
    return options;
  }

  Image render() const { return render_truth(scene_of(case_.parameters, ""), case_.camera, truth_options()); }

  // The difference, and the weights of the pixels that it is of.
  double difference(float& value, std::vector<glm::dvec3>& weights) {
    std::map<int, Image> moved;
    central_difference(value, [&](int steps) { return moved[steps] = render(), 0.0; });
    weights = weights_;
    std::size_t cut = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (std::all_of(moved.begin(), moved.end(),
                      [&](const auto& entry) { return entry.second.blended[i] == base_.blended[i]; }))
        continue;
      weights[i] = glm::dvec3(0);
      ++cut;
    }
    EXPECT_LE(cut, static_cast<std::size_t>(kFewPixels * static_cast<double>(weights.size())));
    return central_difference(value, [&](int steps) { return loss(moved[steps], weights); });
  }

  double loss(const Image& image, const std::vector<glm::dvec3>& weights) const {
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      sum += glm::dot(weights[i], image.rgb[i] + image.transmittance[i] * glm::dvec3(case_.options.background));
    }
    return sum;
  }

  // Compares one kind of numbers.
  void compare(const std::string& name, std::span<float> values) {
    Gradient whole = zero_gradient(case_.parameters);
    drawing_.backward(weights_, whole, nullptr);
    double largest = 0;
    const std::span<float> slopes = floats_of(whole).at(name);
    for (const float slope : slopes) largest = std::max(largest, std::abs(double{slope}));
    EXPECT_GT(largest, 1e-3) << name;
    std::vector<glm::dvec3> weights;
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double wanted = difference(values[k], weights);
      Gradient gradient = zero_gradient(case_.parameters);
      drawing_.backward(weights, gradient, nullptr);
      const double found = floats_of(gradient).at(name)[k];
      EXPECT_NEAR(found, wanted, kTolerance * std::abs(wanted) + kLeast * largest) << name << " " << k;
    }
  }

  Case case_;
  std::vector<std::uint32_t> rank_;
  BasicDrawing<double> drawing_;
  std::vector<glm::dvec3> weights_;
  Image base_;
};

TEST_P(DrawingSlopes, AreThoseOfTheTruth) {
  double worst = 0;
  for (std::size_t i = 0; i < base_.rgb.size(); ++i) {
    const glm::dvec3 wanted = base_.rgb[i] + base_.transmittance[i] * glm::dvec3(case_.options.background);
    worst = std::max(worst, glm::length(wanted - drawing_.picture()[i]));
  }
  ASSERT_LT(worst, 1e-9) << "the pictures are one and the same";
  for (const auto& [name, values] : floats_of(case_.parameters)) compare(name, values);
}

// What float32 in the pixels costs: the same gradients, relative to the largest of their kind.
TEST_P(DrawingSlopes, InFloatAreNearlyThoseInDouble) {
  Gradient in_double = zero_gradient(case_.parameters), in_float = zero_gradient(case_.parameters);
  drawing_.backward(weights_, in_double, nullptr);
  const Drawing drawing(case_.parameters, case_.camera, case_.options);
  drawing.backward(std::vector<glm::vec3>(weights_.begin(), weights_.end()), in_float, nullptr);
  for (const auto& [name, wanted] : floats_of(in_double)) {
    const std::span<float> found = floats_of(in_float).at(name);
    double largest = 0, worst = 0;
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      largest = std::max(largest, std::abs(double{wanted[k]}));
      worst = std::max(worst, std::abs(double{wanted[k]} - found[k]));
    }
    EXPECT_LE(worst, 1e-4 * largest) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, DrawingSlopes,
                         testing::Values(random_case, needles, near_plane, guard_band, opaque, stopped, layered),
                         [](const auto& info) { return info.param().name; });

}  // namespace
}  // namespace pipegs
