// SPDX-License-Identifier: Apache-2.0
// pu_squares_test: rtl/pu/project/pu_squares.sv against its bit-accurate model; its precision is tested in
// pu_covariance_test.
#include "cpp_model/pu/project/pu_squares.hpp"

#include "Vpu_squares.h"
#include "verif/pu/pu_chain.hpp"
#include "verif/pu/pu_stage.hpp"

namespace pipegs {
namespace {

PIPEGS_STAGE(pu_squares, Factors, factors, Squares, squares);

TEST(PuSquares, EqualsItsModelAtEveryPace) { check_every_pace<Stage>(stage_run<Stage>(random_factors, pu_squares)); }

TEST(PuSquares, TakesARecordEveryEightCycles) { check_pace<Stage>(stage_run<Stage>(random_factors, pu_squares), 11); }

}  // namespace
}  // namespace pipegs
