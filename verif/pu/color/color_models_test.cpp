// SPDX-License-Identifier: Apache-2.0
// color_models_test: the bit-accurate models of the stages of pu_color, each against double precision. Their RTL is
// compared in pu_color_test, which holds the whole chain against double precision, too.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cpp_model/pu/color/pu_color_basis.hpp"
#include "cpp_model/pu/color/pu_color_normalise.hpp"
#include "cpp_model/pu/color/pu_color_rotate.hpp"
#include "cpp_model/pu/color/pu_color_sum.hpp"
#include "verif/pu/color/pu_color_support.hpp"

namespace pipegs {
namespace {

// Calls `visit` with random cameras' frames and view directions.
template <class Visit>
void each_direction(const Config& config, Visit&& visit) {
  std::mt19937_64 rng(1);
  for (int i = 0; i < 200000 && !testing::Test::HasFatalFailure(); ++i) {
    Frame frame;
    set_rotation(config, frame, rng);
    visit(frame, random_direction(config, rng));
  }
}

TEST(ColorModels, RotateIsCloseToDouble) {
  const Config config;
  double worst = 0;
  each_direction(config, [&](const Frame& frame, const ViewDirection& view) {
    const WorldDirection world = pu_color_rotate(config, frame, view);
    const glm::dvec3 v(view.x, view.y, view.z), exact = to_world(config, frame, v);
    const glm::dvec3 error = glm::abs(glm::dvec3(world.x, world.y, world.z) * 0.5 - exact);
    worst = std::max({worst, error.x, error.y, error.z});
    ASSERT_EQ(static_cast<double>(world.length2), glm::dot(v, v));
  });
  fmt::print("pu_color_rotate: worst error {:.3f} units of the view direction\n", worst);
  EXPECT_LT(worst, 1.7);  // 2^-17.2 of a length of up to 2^17.8, and the last half unit
}

TEST(ColorModels, NormaliseIsCloseToDouble) {
  const Config config;
  double worst = 0;
  each_direction(config, [&](const Frame& frame, const ViewDirection& view) {
    const glm::dvec3 v(view.x, view.y, view.z);
    if (glm::length(v) < 65536) return;  // not block-normalised: correct, but coarse
    const UnitDirection unit = pu_color_normalise(config, pu_color_rotate(config, frame, view));
    const glm::dvec3 exact = glm::normalize(to_world(config, frame, v));
    const glm::dvec3 error =
        glm::abs(glm::dvec3(unit.x, unit.y, unit.z) * std::ldexp(1.0, -config.unit_direction_f()) - exact);
    worst = std::max({worst, error.x, error.y, error.z});
  });
  fmt::print("pu_color_normalise: worst error of a component 2^{:.2f}, rotation included\n", std::log2(worst));
  EXPECT_LT(worst, std::exp2(-15));
  EXPECT_EQ(pu_color_normalise(config, {}), UnitDirection{}) << "zero stays zero";
}

UnitDirection to_fixed(const Config& config, const glm::dvec3& d) {
  const double scale = std::ldexp(1.0, config.unit_direction_f());
  return {.x = std::llround(d.x * scale), .y = std::llround(d.y * scale), .z = std::llround(d.z * scale)};
}

TEST(ColorModels, BasisIsCloseToDouble) {
  const Config config;
  std::mt19937_64 rng(1);
  double worst = 0;
  for (int i = 0; i < 300000; ++i) {
    const auto axis = static_cast<int>(rng() % 32);
    glm::dvec3 direction(0);
    if (axis < 6) direction[axis / 2] = axis % 2 == 0 ? 1 : -1;
    else direction = glm::normalize(draw_normals(rng));
    const UnitDirection unit = to_fixed(config, direction);
    const auto exact = sh_basis(glm::normalize(glm::dvec3(unit.x, unit.y, unit.z)));
    const auto found = functions(pu_color_basis(unit));
    for (size_t k = 0; k < 15; ++k)
      worst = std::max(worst, std::abs(std::ldexp(found[k], -config.basis_f()) - exact[k + 1]));
  }
  fmt::print("pu_color_basis: worst error 2^{:.2f}\n", std::log2(worst));
  EXPECT_LT(worst, std::exp2(-13));
  for (const int64_t b : functions(pu_color_basis({}))) EXPECT_LT(std::abs(b), int64_t{1} << config.basis_f());
}

// For the same basis, in the default widths and in fine ones.
TEST(ColorModels, SumIsCloseToDouble) {
  Config fine;
  fine.base_w = 16, fine.sh_m_w = 6, fine.color_w = 8;
  for (const Config& config : {Config{}, fine}) {
    std::mt19937_64 rng(1);
    double worst = 0, squares = 0;
    const int count = 200000;
    for (int i = 0; i < count; ++i) {
      const Frame frame{.tables = {.sh_degree = static_cast<uint64_t>(config.sh_degree)}};
      const auto line = random_line(config, rng, 16, 25);
      ColorTask task = random_record<ColorTask>(config, rng);
      task.kind = kData;
      const glm::dvec3 direction = glm::normalize(draw_normals(rng));
      const ShBasis basis =
          rng() % 8 == 0 ? random_record<ShBasis>(config, rng) : pu_color_basis(to_fixed(config, direction));
      const auto b = functions(basis);
      double exact = std::ldexp(task.base_g, 3 - config.base_w);
      for (int k = 0; k < 15; ++k) {
        exact += coefficient(config, frame, line.data(), task.quarter, k, 1) * std::ldexp(b[k], -config.basis_f());
      }
      const double unit = std::ldexp(1.0, 2 - config.color_w);
      exact = std::clamp(exact, 0.0, 4 - unit) / unit;
      const double error =
          std::abs(static_cast<double>(pu_color_sum(config, frame, task, line.data(), basis).green) - exact);
      worst = std::max(worst, error);
      squares += error * error;
    }
    fmt::print("pu_color_sum, color_w={}: worst error {:.3f} units of the colour, rms {:.3f}\n", config.color_w, worst,
               std::sqrt(squares / count));
    EXPECT_LE(worst, 0.5 + 0.125 + 1e-9);
  }
}

TEST(ColorModels, SumCountsSaturatedChannels) {
  const Config config;
  const Frame frame{.tables = {.sh_degree = 3}};
  std::array<uint32_t, 16> line{};
  line[0] = 31 | 0x3ffu << config.sh_e_w;  // the first red coefficient is large
  ShBasis basis;
  basis.b1 = 32000;
  ColorCounts counts;
  EXPECT_EQ(pu_color_sum(config, frame, {}, line.data(), basis, &counts).red, (uint64_t{1} << config.color_w) - 1);
  EXPECT_EQ(counts.saturated, 1u);
}

}  // namespace
}  // namespace pipegs
