// SPDX-License-Identifier: Apache-2.0
// projection_models_test: the bit-accurate models from pu_project to pu_compensate against double precision, in the
// default widths (view_w=28), in coarse and in fine ones. Their RTL is compared in pu_shape_test.
#include "cpp_model/pu/project/pu_compensate.hpp"
#include "verif/pu/pu_chain.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

class ProjectionModels : public testing::TestWithParam<const char*> {
 protected:
  const Config config = config_with(GetParam());
  std::mt19937_64 rng{test_seed()};
  PuRandom random{config, rng};
};
using CompensateModel = ProjectionModels;

constexpr const char* kCoarse = "view_w=22 tan_f=24 mean_f=10 mantissa_w=20 window=16 scale_m_w=8 quat_w=12";
constexpr const char* kFine =
    "view_w=30 mantissa_w=28 scale_m_w=16 quat_w=18 tan_f=16 mean_f=14 depth_w=30 pos_w=24 world_w=43 opacity_f=16";
INSTANTIATE_TEST_SUITE_P(, ProjectionModels,
                         testing::Values("view_w=28", kCoarse, kFine, "order=1 mean_f=11", "guard_band=0"));
INSTANTIATE_TEST_SUITE_P(, CompensateModel, testing::Values("antialias=1", "antialias=1 opacity_f=16 mantissa_w=28"));

TEST_P(ProjectionModels, ProjectIsPrecise) {
  const auto real = [](auto m, int64_t e) { return std::ldexp(static_cast<double>(m), static_cast<int>(e)); };
  const double edge = real(1, config.mean_w() - 1 - config.mean_f);  // of a mean's range
  double inverse = 0, tangent = 0, near = 0, far = 0, turn = 0;
  for (int i = 0; i < 100000; ++i) {
    const Frame f = random.frame();
    const Visible v = random.visible(f);
    ProjectCounts counts;
    const auto [p, center, payload] = pu_project(config, f, v, &counts);
    const double x = static_cast<double>(v.view_x), y = static_cast<double>(v.view_y),
                 z = static_cast<double>(v.view_z);
    inverse =
        std::max(inverse, std::abs(real(p.inv_z_m, p.inv_z_e) * real(v.view_z, static_cast<int64_t>(v.view_exp)) - 1));
    const double limit = config.guard_band ? real(f.lens.limit_x, -config.tan_f) : 16;
    tangent = std::max(tangent, std::abs(std::clamp(x / z, -limit, limit) - real(p.tan_x, -config.tan_f)));
    const double centered = real(f.lens.focal_x, -config.focal_f()) * x / z;
    const double mean =
        centered + real(f.lens.center_x, -config.center_f()) - static_cast<double>(v.window_x) * config.window;
    if (std::abs(mean) < edge - 1 && counts.saturated == 0) {
      const double error = std::abs(mean - real(center.mean_x, -config.mean_f));
      near = std::abs(centered) < 4096 ? std::max(near, error) : near;
      far = std::abs(centered) < 4096 ? far : std::max(far, error / std::abs(centered));
    } else if (std::abs(mean) > edge + 1) {
      EXPECT_EQ(counts.saturated, 1u) << to_text(config, v);
    }
    const double a[3] = {x, y, z}, b[3] = {real(payload.dir_x, 0), real(payload.dir_y, 0), real(payload.dir_z, 0)};
    const double cross = std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
    turn = std::max(turn, cross / (std::hypot(x, y, z) * std::hypot(b[0], b[1], b[2])));
  }
  std::printf(
      "pu_project, %s: 1/z 2^%.2f relative; tan 2^%.2f; mean 2^%.2f px within 4096 px, 2^%.2f relative beyond; "
      "direction "
      "2^%.1f rad\n",
      GetParam(), std::log2(inverse), std::log2(tangent), std::log2(near), std::log2(far), std::log2(turn));
  if (config.mantissa_w < 26 || config.view_w < 28) return;  // the bounds are those of the default widths
  EXPECT_LT(inverse, std::ldexp(1.0, -25));
  EXPECT_LT(tangent,
            std::ldexp(config.guard_band ? 1.1 : 2, -config.tan_f));  // up to 16 the relative error of 1/z counts
  EXPECT_LT(near, std::ldexp(1.0, -10));
  EXPECT_LT(far, std::ldexp(1.0, -24) + std::ldexp(1.0, -config.mean_f - 12));
  EXPECT_LT(turn, std::ldexp(1.0, -15));
}

TEST_P(ProjectionModels, TheDepthKeyOrdersByDepth) {
  const Frame f = random.frame();
  for (int i = 0; i < 20000; ++i) {
    Visible v = random.visible(f), w = random.visible(f);
    if (random.chance(2)) w.view_z = v.view_z + random.integer(0, 1), w.view_exp = v.view_exp;
    if (w.view_z >= int64_t{1} << (config.view_w - 1)) continue;
    const double dv = std::ldexp(static_cast<double>(v.view_z), static_cast<int>(v.view_exp));
    const double dw = std::ldexp(static_cast<double>(w.view_z), static_cast<int>(w.view_exp));
    const uint64_t kv = pu_project(config, f, v).payload.depth, kw = pu_project(config, f, w).payload.depth;
    if (dv < dw) { ASSERT_LE(kv, kw); }
    if (dv == dw) { ASSERT_EQ(kv, kw) << "the same depth in two units"; }
    if (dv > dw) { ASSERT_GE(kv, kw); }
  }
}

TEST_P(ProjectionModels, OrientIsTheProductOfTheTwoRotations) {
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const Frame f = random.frame();
    const Projected p = pu_project(config, f, random.visible(f)).projected;
    const Oriented o = pu_orient(config, f, p);
    const double unit = std::ldexp(1.0, -(config.quat_w - 1));
    const glm::dmat3 r = rotation_matrix({unit * p.qw, unit * p.qx, unit * p.qy, unit * p.qz});
    const int64_t w[3][3] = {{f.camera.rotation.w00, f.camera.rotation.w01, f.camera.rotation.w02},
                             {f.camera.rotation.w10, f.camera.rotation.w11, f.camera.rotation.w12},
                             {f.camera.rotation.w20, f.camera.rotation.w21, f.camera.rotation.w22}};
    const int64_t found[3][3] = {{o.r00, o.r01, o.r02}, {o.r10, o.r11, o.r12}, {o.r20, o.r21, o.r22}};
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        double exact = 0;
        for (int k = 0; k < 3; ++k) exact += std::ldexp(static_cast<double>(w[row][k]), -config.rot_f()) * r[column][k];
        worst = std::max(
            worst, std::abs(exact - std::ldexp(static_cast<double>(found[row][column]), -(config.rotation_w() - 2))));
      }
    }
  }
  std::printf("pu_orient, %s: worst entry differs by %.2g from W R (the stored quaternions' length included)\n",
              GetParam(), worst);
  EXPECT_LT(worst, std::ldexp(1.0, -(config.quat_w - 4)));  // the stretch that pu_cull allows for
}

// From the fields of `oriented` on: what quantisation of the record costs is not counted.
TEST_P(ProjectionModels, TheCovarianceIsPreciseForNeedlesPancakesAndAllSizes) {
  double a = 0, b = 0, c = 0, det = 0;
  for (int i = 0; i < 50000; ++i) {
    const Frame f = random.frame();
    for (int k = 0; k < 4; ++k) {
      const Oriented o = random_oriented(random, f);
      const ExactCovariance exact = exact_covariance(random, f, o);
      const Covariance found =
          pu_covariance(config, f, pu_squares(config, f, pu_factors(config, f, pu_jacobian(config, f, o))), {});
      if (exact.a > 0x1p100 || exact.c > 0x1p100) continue;  // exponents saturate
      const auto real = [](auto m, auto e) { return std::ldexp(static_cast<double>(m), static_cast<int>(e)); };
      const auto worst = [&](double& error, double found_value, double exact_value, double scale) {
        error = std::max(error, std::abs(found_value - exact_value) / scale);
      };
      worst(a, real(found.a_m, found.a_e), exact.a, exact.a);
      worst(c, real(found.c_m, found.c_e), exact.c, exact.c);
      worst(det, real(found.det_m, found.det_e), exact.det, exact.det);
      worst(b, real(found.b_m, found.b_e), exact.b, std::sqrt(exact.a) * std::sqrt(exact.c));
      for (const uint64_t m : {found.a_m, found.c_m, found.det_m})
        ASSERT_EQ(m >> (config.mantissa_w - 1), 1u) << "normalised";
    }
  }
  std::printf("pu_covariance, %s: relative error of a 2^%.2f, c 2^%.2f, det 2^%.2f, of b to sqrt(ac) 2^%.2f\n",
              GetParam(), std::log2(a), std::log2(c), std::log2(det), std::log2(b));
  const int lost = std::max(0, 26 - config.mantissa_w);  // the bounds are those of the default width
  EXPECT_LT(a, std::ldexp(1.0, lost - 21));
  EXPECT_LT(c, std::ldexp(1.0, lost - 21));
  EXPECT_LT(det, std::ldexp(1.0, lost - 21));
  EXPECT_LT(b, std::ldexp(1.0, lost - 22));
}

TEST_P(ProjectionModels, AScaleOfZeroLeavesTheDilation) {
  const Frame f = random.frame();
  Oriented o = random_oriented(random, f);
  o.scale_0 = o.scale_1 = o.scale_2 = 0;
  const Covariance found =
      pu_covariance(config, f, pu_squares(config, f, pu_factors(config, f, pu_jacobian(config, f, o))), {});
  const auto real = [](auto m, auto e) { return std::ldexp(static_cast<double>(m), static_cast<int>(e)); };
  EXPECT_NEAR(real(found.a_m, found.a_e), 0.3, 1e-5);
  EXPECT_NEAR(real(found.c_m, found.c_e), 0.3, 1e-5);
  EXPECT_NEAR(real(found.det_m, found.det_e), 0.09, 1e-5);
  EXPECT_EQ(found.b_m, 0);
}

TEST_P(CompensateModel, IsWithinItsStatedErrorOfDouble) {
  const double bound = 5.4e-5 + std::ldexp(0.5, -config.opacity_f);
  double worst = 0;
  int floored = 0;
  for (int i = 0; i < 20000; ++i) {
    Frame f = random.frame();
    f.tables.antialias = 1;
    const Covariance in = pu_covariance(config, f, random_squares(random, f), random.center());
    const double det = std::ldexp(static_cast<double>(in.det_m), static_cast<int>(in.det_e));
    const double sharp = std::ldexp(static_cast<double>(in.sharp_m),
                                    static_cast<int>(in.sharp_e) + config.mantissa_w - config.sharp_w());
    const double fall = -0.5 * std::log2(std::max(2.5e-5, sharp / det)),
                 all = std::ldexp(static_cast<double>(in.opacity), -config.opacity_f) + fall;
    const double found = std::ldexp(static_cast<double>(pu_compensate(config, f, in).opacity), -config.opacity_f);
    floored += sharp < 2.5e-5 * det;
    if (all < 15.99) worst = std::max(worst, std::abs(found - all));
    else EXPECT_GT(found, 15.9);
  }
  std::printf("pu_compensate, %s: error %.3g of -log2(opacity), %d of 20000 at the floor\n", GetParam(), worst,
              floored);
  EXPECT_LT(worst, bound);
  EXPECT_GT(floored, 100);
}

}  // namespace
}  // namespace pipegs
