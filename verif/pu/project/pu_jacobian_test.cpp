// SPDX-License-Identifier: Apache-2.0
// pu_jacobian_test: rtl/pu/project/pu_jacobian.sv against its bit-accurate model; its precision is tested in
// pu_covariance_test.
#include "cpp_model/pu/project/pu_jacobian.hpp"

#include "Vpu_jacobian.h"
#include "verif/pu/pu_chain.hpp"
#include "verif/pu/pu_stage.hpp"

namespace pipegs {
namespace {

PIPEGS_STAGE(pu_jacobian, Oriented, oriented, Jacobian, jacobian);

TEST(PuJacobian, EqualsItsModelAtEveryPace) { check_every_pace<Stage>(stage_run<Stage>(random_oriented, pu_jacobian)); }

TEST(PuJacobian, TakesARecordEveryEightCycles) {
  check_pace<Stage>(stage_run<Stage>(random_oriented, pu_jacobian), 11);
}

}  // namespace
}  // namespace pipegs
