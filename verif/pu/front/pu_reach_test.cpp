// SPDX-License-Identifier: Apache-2.0
// pu_reach_test: rtl/pu/front/pu_reach.sv against its bit-accurate model, and the model against the regions that the PU
// finds and against its own test in double precision.
#include "cpp_model/pu/front/pu_reach.hpp"

#include "Vpu_reach.h"
#include "cpp_model/golden.hpp"
#include "cpp_model/pu/conic/pu_coeff.hpp"
#include "cpp_model/pu/conic/pu_intersect.hpp"
#include "cpp_model/pu/pu_parts.hpp"
#include "cpp_model/pu/front/pu_cull.hpp"
#include "verif/pu/pu_chain.hpp"
#include "verif/pu/pu_stage.hpp"
#include "verif/pu/front/random_fetched.hpp"

namespace pipegs {
namespace {

PIPEGS_STAGE(pu_reach, Culled, culled, Visible, visible);

// A survivor of the cull: needles, discs and others, with their ends near the window.
Culled make(PuRandom& random, const Frame& frame) {
  Culled culled;
  for (std::optional<Visible> visible; !visible;) {
    Fetched in = random_fetched(random, frame);
    // Other scales below the largest, so that it stays where it is; mostly visible ones.
    uint64_t* const scales[3] = {&in.scale_0, &in.scale_1, &in.scale_2};
    const uint64_t largest = std::max({in.scale_0, in.scale_1, in.scale_2});
    const uint64_t shape = random.rng() % 4, first = random.rng() % 3;
    const auto smaller = [&] {
      const uint64_t down = static_cast<uint64_t>(random.uniform(0.5, 12) * (1 << random.config.scale_m_w));
      return largest > down ? largest - down : 0;
    };
    for (uint64_t k = 0; k < 3 && shape < 2; ++k)
      *scales[k] = shape == 0 ? (k == first ? largest : smaller()) : (k == first ? smaller() : largest);
    if (!random.chance(4)) in.opacity >>= random.rng() % 8;
    visible = pu_cull(random.config, frame, in, nullptr, &culled.gap);
    if (visible) culled.visible = *visible;
  }
  return culled;
}

auto make_run() {
  return [](PuRandom& random, int count) {
    StageRun<Stage> run;
    run.frame = random.frame();
    for (int i = 0; i < count; ++i) {
      run.inputs.push_back(make(random, run.frame));
      if (!random.chance(10)) continue;
      run.inputs.emplace_back();  // pu_cull sends ends with all other fields zero
      run.inputs.back().visible.kind = random.chance(3) ? kWindowEnd : kLayerEnd;
    }
    for (const Culled& in : run.inputs) {
      if (in.visible.kind != kData || pu_reach(random.config, run.frame, in.visible, in.gap))
        run.expected.push_back(in.visible);
    }
    return run;
  };
}

TEST(PuReach, EqualsItsModelAtEveryPace) { check_every_pace<Stage>(make_run()); }

// A Gaussian comes out after 12 cycles, and then one in each: those that are dropped leave gaps.
TEST(PuReach, TakesAGaussianEveryCycle) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  const StageRun<Stage> run = make_run()(random, 500);
  std::vector<uint64_t> expected;
  for (size_t i = 0; i < run.inputs.size(); ++i) {
    const Culled& in = run.inputs[i];
    if (in.visible.kind != kData || pu_reach(config, run.frame, in.visible, in.gap)) expected.push_back(i + 12);
  }
  EXPECT_EQ(check_run<Stage>(config, run, Pace::kAlways, Pace::kAlways), expected);
}

// The test in double precision, along the axis that pu_reach takes, from the fields that the machine works with.
bool exact_drop(const PuRandom& random, const Frame& frame, const Visible& v, const Gap& gap) {
  const Config& config = random.config;
  const auto real = [](auto value, int down) { return std::ldexp(static_cast<double>(value), -down); };
  const bool along_x = gap.gap_x >= gap.gap_y;
  const double g = real(along_x ? gap.gap_x : gap.gap_y, 4 - static_cast<int>(gap.cut) - static_cast<int>(v.view_exp));
  if (gap.untested || g <= 0) return false;
  const Oriented o = pu_orient(config, frame, pu_project(config, frame, v).projected);
  const double z = real(v.view_z, -static_cast<int>(v.view_exp));
  const double focal = real(along_x ? frame.lens.focal_x : frame.lens.focal_y, config.focal_f());
  const double slope = real(along_x ? o.tan_x : o.tan_y, config.tan_f);
  const int64_t across[3] = {along_x ? o.r00 : o.r10, along_x ? o.r01 : o.r11, along_x ? o.r02 : o.r12};
  const int64_t forward[3] = {o.r20, o.r21, o.r22};
  const uint64_t scales[3] = {v.scale_0, v.scale_1, v.scale_2};
  double variance = 0;
  for (int k = 0; k < 3; ++k) {
    const double u = scale_value(config, scales[k]) * focal / z *
                     (real(across[k], config.rotation_w() - 2) - slope * real(forward[k], config.rotation_w() - 2));
    variance += u * u;
  }
  const double left = std::log2(config.alpha_cut) - real(v.opacity, config.opacity_f);
  return g / z >= std::sqrt(2 * std::log(2) * std::max(0.0, left) * variance);
}

bool has_region(const Config& config, const Frame& frame, const Visible& visible, ProjectCounts& counts) {
  for (const PuPart& part : pu_parts(config, golden_conic(config, frame, visible, &counts).conic, visible.walk)) {
    if (pu_intersect(config, frame, pu_coeff(config, frame, part.conic)).mask != 0) return true;
  }
  return false;
}

TEST(PuReach, ModelDropsNothingThatHasARegion) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  int kept = 0, dropped = 0, exactly = 0, both = 0;
  for (int i = 0; i < 3000; ++i) {
    const Frame frame = random.frame();
    for (int k = 0; k < 10; ++k) {
      const Culled in = make(random, frame);
      const bool keeps = pu_reach(config, frame, in.visible, in.gap);
      const bool exact = exact_drop(random, frame, in.visible, in.gap);
      ProjectCounts counts;
      // A saturated mean is not where the Gaussian is.
      const bool seen = has_region(config, frame, in.visible, counts) && counts.saturated == 0;
      if (seen) { ASSERT_TRUE(keeps) << to_text(config, in) << "\n" << to_text(config, frame); }
      kept += keeps;
      dropped += !keeps;
      if (!keeps) { ASSERT_TRUE(exact) << to_text(config, in) << "\n" << to_text(config, frame); }
      // The figure is of Gaussians that a scene has: not larger than their distance, which has some bits.
      const double size = scale_value(config, std::max({in.visible.scale_0, in.visible.scale_1, in.visible.scale_2}));
      const int64_t z = in.visible.view_z;
      if (z < 1 << 14 || size > std::ldexp(static_cast<double>(z), static_cast<int>(in.visible.view_exp))) continue;
      exactly += exact;
      both += exact && !keeps;
    }
  }
  std::printf("pu_reach: %d kept, %d dropped; %d of the %d that the test drops in double precision (%.1f %%)\n", kept,
              dropped, both, exactly, 100.0 * both / exactly);
  EXPECT_GT(kept, 1000);
  EXPECT_GT(both, (config.quat_w < 16 ? 0.8 : 0.9) * exactly);
}

}  // namespace
}  // namespace pipegs
