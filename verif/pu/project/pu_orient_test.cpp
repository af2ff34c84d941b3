// SPDX-License-Identifier: Apache-2.0
// pu_orient_test: rtl/pu/project/pu_orient.sv against its bit-accurate model, and the model against rotation
// matrices in double.
#include "cpp_model/pu/project/pu_orient.hpp"

#include "Vpu_orient.h"
#include "cpp_model/pu/project/pu_project.hpp"
#include "verif/pu/pu_stage.hpp"

namespace pipegs {
namespace {

PIPEGS_STAGE(pu_orient, Projected, projected, Oriented, oriented);

Projected make(PuRandom& random, const Frame& frame) {
  Projected p = pu_project(random.config, frame, random.visible(frame)).projected;
  if (random.chance(8)) p.qw = p.qx = p.qy = p.qz = -(int64_t{1} << (random.config.quat_w - 1));  // length 2: saturates
  return p;
}

TEST(PuOrient, EqualsItsModelAtEveryPace) { check_every_pace<Stage>(stage_run<Stage>(make, pu_orient)); }

TEST(PuOrient, TakesARecordEveryEightCycles) { check_pace<Stage>(stage_run<Stage>(make, pu_orient), 10); }

void matrix(const double (&q)[4], double (&m)[3][3]) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  const double rows[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                             {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                             {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
  for (int i = 0; i < 9; ++i) m[i / 3][i % 3] = rows[i / 3][i % 3];
}

TEST(PuOrient, ModelIsTheProductOfTheTwoRotations) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const Frame f = random.frame();
    const Projected p = pu_project(config, f, random.visible(f)).projected;
    const Oriented o = pu_orient(config, f, p);
    const double unit = std::ldexp(1.0, -(config.quat_w - 1));
    const double q[4] = {unit * p.qw, unit * p.qx, unit * p.qy, unit * p.qz};
    double r[3][3];
    matrix(q, r);
    const int64_t w[3][3] = {{f.camera.rotation.w00, f.camera.rotation.w01, f.camera.rotation.w02},
                             {f.camera.rotation.w10, f.camera.rotation.w11, f.camera.rotation.w12},
                             {f.camera.rotation.w20, f.camera.rotation.w21, f.camera.rotation.w22}};
    const int64_t found[3][3] = {{o.r00, o.r01, o.r02}, {o.r10, o.r11, o.r12}, {o.r20, o.r21, o.r22}};
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        double exact = 0;
        for (int k = 0; k < 3; ++k) exact += std::ldexp(static_cast<double>(w[row][k]), -config.rot_f()) * r[k][column];
        worst = std::max(
            worst, std::abs(exact - std::ldexp(static_cast<double>(found[row][column]), -(config.rotation_w() - 2))));
      }
    }
  }
  std::printf("pu_orient: worst entry differs by %.2g from W R (the stored quaternions' length included)\n", worst);
  EXPECT_LT(worst, std::ldexp(1.0, -(config.quat_w - 4)));  // the stretch that pu_cull allows for
}

}  // namespace
}  // namespace pipegs
