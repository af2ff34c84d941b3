// SPDX-License-Identifier: Apache-2.0
// `pipegs study stress` itself: hostile views on three machines, and the shrinker against a failure that is injected.
#include <cmath>

#include "sim/studies/stress/stress.hpp"
#include "verif/stability/support/stability.hpp"

namespace pipegs {
namespace {

// On those of every hard case. A pair without a bound is a Gaussian whose record is clipped: at most a fifth of them.
TEST(Stress, HostileViewsOnThreeMachines) {
  for (SimulateOptions options : stable_machines()) {
    StressFigures figures;
    for (uint64_t seed = 1; seed <= 15; ++seed) {
      options.memory.seed = options.rtl.seed = seed;
      const std::optional<std::string> what = stress_check(stress_view(seed), options, true, &figures);
      EXPECT_FALSE(what) << "seed " << seed << ", " << config_difference(options.config) << ": " << *what;
    }
    const double unbounded = static_cast<double>(figures.vacuous) / static_cast<double>(figures.pairs);
    fmt::print("stress {}: {} views, {} pairs, {:.1f} % without a bound; worst alpha {:.5f}, T {:.5f}, colour {:.5f}\n",
               config_difference(options.config), figures.views, figures.pairs, 100 * unbounded, figures.alpha,
               figures.t, figures.color);
    EXPECT_LT(unbounded, 0.2) << config_difference(options.config);
  }
}

TEST(Stress, TheSameSeedIsTheSameView) {
  const StressView a = stress_view(7), b = stress_view(7), c = stress_view(8);
  ASSERT_EQ(a.scene.gaussians.size(), b.scene.gaussians.size());
  EXPECT_EQ(a.scene.sh_rest, b.scene.sh_rest);
  EXPECT_EQ(a.camera.fx, b.camera.fx);
  EXPECT_NE(a.camera.fx, c.camera.fx);
}

// A failure that needs two certain Gaussians and an image of at least 20x7: exactly that is what remains.
TEST(Stress, ShrinksToWhatTheFailureNeeds) {
  StressView view = stress_view(3, {.gaussians = 150, .width = 160, .height = 120});
  view.scene.gaussians[37].sh_dc.x = 1234;
  view.scene.gaussians[111].sh_dc.x = 4321;
  const StressPredicate injected = [](const StressView& v) -> std::optional<std::string> {
    bool one = false, two = false;
    for (const Gaussian& g : v.scene.gaussians) one |= g.sh_dc.x == 1234, two |= g.sh_dc.x == 4321;
    if (one && two && v.camera.width >= 20 && v.camera.height >= 7) return "injected";
    return std::nullopt;
  };
  const StressShrunk small = stress_shrink(view, injected);
  EXPECT_EQ(small.view.scene.gaussians.size(), 2u);
  EXPECT_EQ(small.view.scene.sh_rest.size(), 2 * 3 * static_cast<size_t>(sh_rest_count(view.scene.sh_degree)));
  EXPECT_EQ(small.view.camera.width, 20);
  EXPECT_EQ(small.view.camera.height, 7);
  EXPECT_LT(small.tried, 300);
  EXPECT_TRUE(injected(small.view));
  EXPECT_THROW(stress_shrink(stress_view(1), injected), std::invalid_argument);
}

// A real difference: the golden model of another alpha width stands for a broken one, and one Gaussian shows it.
TEST(Stress, ShrinksARealDifferenceToOneGaussian) {
  const StressPredicate differs = [](const StressView& v) -> std::optional<std::string> {
    Simulation good, broken;
    SimulateOptions options = stable_machine(), other = stable_machine({"alpha_w=9"});
    options.near_plane = other.near_plane = v.near_plane;
    simulate_golden(v.scene, v.camera, options, good);
    simulate_golden(v.scene, v.camera, other, broken);
    return good.golden.pixels == broken.golden.pixels ? std::nullopt : std::optional<std::string>("pixels differ");
  };
  const StressShrunk small = stress_shrink(stress_view(5, {.gaussians = 40, .width = 64, .height = 64}), differs);
  EXPECT_EQ(small.view.scene.gaussians.size(), 1u);
  EXPECT_EQ(small.view.camera.width * small.view.camera.height, 1);
}

}  // namespace
}  // namespace pipegs
