// pu_factors_test: rtl/pu/pu_factors.sv against its twin; its precision is tested in pu_covariance_test.
#include "cpp_model/pu/pu_factors.hpp"

#include "Vpu_factors.h"
#include "verif/pu/pu_chain.hpp"
#include "verif/pu/pu_stage.hpp"

namespace pipegs {
namespace {

PIPEGS_STAGE(pu_factors, Jacobian, jacobian, Factors, factors);

TEST(PuFactors, EqualsItsTwinAtEveryPace) { check_every_pace<Stage>(stage_run<Stage>(random_jacobian, pu_factors)); }

TEST(PuFactors, TakesARecordEveryEightCycles) { check_pace<Stage>(stage_run<Stage>(random_jacobian, pu_factors), 10); }

}  // namespace
}  // namespace pipegs
