// SPDX-License-Identifier: Apache-2.0
// opacity_cli_test: `pipegs study opacity` on a scene of four Gaussians, and bad input.
#include <cmath>

#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

class OpacityCli : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    Scene scene = random_scene(1, 4, 0);
    const float odds[] = {0.001f, 0.25f, 0.999f, 0.5f};
    for (size_t i = 0; i < 4; ++i) scene.gaussians[i].opacity_logit = std::log(odds[i] / (1 - odds[i]));
    write_ply(folder_ / "four.ply", scene);
  }
};

TEST_F(OpacityCli, CountsByTenths) {
  const Outcome outcome = run("study opacity four.ply --json --out found");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json found = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(found["parts"], nlohmann::json({1, 0, 1, 0, 0, 1, 0, 0, 0, 1}));
  EXPECT_EQ(found["below_1_255"], 1);
  EXPECT_EQ(found["culled"], 0);
  EXPECT_EQ(text("found/opacity.csv").substr(0, 18), "from,to,gaussians\n");
  EXPECT_NE(run("study opacity four.ply").out.find("1 below 1/255, 0 culled"), std::string::npos);
}

TEST_F(OpacityCli, RefusesWhatIsNoScene) {
  expect_refused("study opacity none.ply", "none.ply");
  expect_refused("study opacity four.ply --page", "--page");
}

}  // namespace
}  // namespace pipegs
