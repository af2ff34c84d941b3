// SPDX-License-Identifier: Apache-2.0
// pu_factors_test: rtl/pu/project/pu_factors.sv against its bit-accurate model; its precision is tested in
// projection_models_test.
#include "cpp_model/pu/project/pu_factors.hpp"

#include "Vpu_factors.h"
#include "verif/pu/pu_chain.hpp"
#include "verif/pu/pu_stage.hpp"

namespace pipegs {
namespace {

PIPEGS_STAGE(pu_factors, Jacobian, jacobian, Factors, factors);

TEST(PuFactors, EqualsItsModelAtEveryPace) { check_every_pace<Stage>(stage_run<Stage>(random_jacobian, pu_factors)); }

// The first component of a row is zero although its exponent is the largest: by a zero scale or by a zero mantissa. It
// must not set the row's exponent.
Jacobian zero_first_jacobian(PuRandom& random, const Frame& frame) {
  Jacobian j = random_jacobian(random, frame);
  const auto scale = [&](int64_t e) {
    const int64_t mantissa = random.integer(0, (int64_t{1} << random.config.scale_m_w) - 1);
    return static_cast<uint64_t>((e << random.config.scale_m_w) | mantissa);
  };
  const int64_t power = random.integer(1, 40);
  j.scale_0 = scale(power + random.integer(0, 3));
  j.scale_1 = scale(power + random.integer(0, 3));
  j.scale_2 = scale(power + random.integer(0, 3));
  switch (random.integer(0, 3)) {
    case 0: j.scale_0 = scale(0); break;         // u0_0, u1_0, t_1, t_2
    case 1: j.scale_1 = scale(0); break;         // u0_1, u1_1, t_0, t_2
    case 2: j.scale_2 = scale(0); break;         // u0_2, u1_2, t_0, t_1
    default: j.v0_0_m = j.v1_0_m = j.n_0_m = 0;  // the first ones themselves
  }
  const int64_t down = power + 3;  // a zero scale counts with exponent 0: still the zero has the larger sum
  const auto lower = [&](int64_t first, int64_t& second, int64_t& third) {
    second = first - down - random.integer(0, 6);
    third = first - down - random.integer(0, 6);
  };
  lower(j.v0_0_e, j.v0_1_e, j.v0_2_e);
  lower(j.v1_0_e, j.v1_1_e, j.v1_2_e);
  lower(j.n_0_e, j.n_1_e, j.n_2_e);
  return j;
}

TEST(PuFactors, AZeroFirstComponentDoesNotSetTheExponent) {
  check_every_pace<Stage>(stage_run<Stage>(zero_first_jacobian, pu_factors));
}

TEST(PuFactors, TakesARecordEveryEightCycles) { check_pace<Stage>(stage_run<Stage>(random_jacobian, pu_factors), 11); }

}  // namespace
}  // namespace pipegs
