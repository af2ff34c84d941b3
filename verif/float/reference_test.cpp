// SPDX-License-Identifier: Apache-2.0
// Against cpp_model/float/truth: INRIA semantics on a real trained scene equal an independent
// float64 renderer (numpy) to 8-bit rounding.
//
// Needs   scenes/plushdog of the shared folder, found by PIPEGS_SHARED or beside the repository;
//         skipped with a message when it is not there. Nothing of it is part of the repository.
#include <gtest/gtest.h>

#include "cpp_model/float/truth.hpp"
#include "scenes/ply/ply.hpp"
#include "verif/support/shared.hpp"

namespace pipegs {
namespace {

TEST(Reference, PlushdogEqualsTheNumpyRenderer) {
  const auto folder = shared_folder() / "scenes" / "plushdog";
  const auto ply = folder / "point_cloud_29999_clean.ply";
  if (!std::filesystem::exists(ply)) GTEST_SKIP() << "skipped: no " << ply << " (set PIPEGS_SHARED)";
  const Scene scene = read_ply(ply);
  EXPECT_EQ(scene.gaussians.size(), 15105u);
  EXPECT_EQ(scene.sh_degree, 3);
  const auto cameras = read_cameras(folder / "cameras.json");
  TruthOptions options;
  options.semantics = Semantics::kInria;
  for (std::size_t v = 0; v < cameras.size(); ++v) {
    const Rgb8 found = to_rgb8(render_truth(scene, cameras[v], options), {0, 0, 0});
    const Rgb8 wanted =
        read_png8(folder / (v == 0 ? std::string("reference.png") : "reference_" + std::to_string(v) + ".png"));
    ASSERT_EQ(found.data.size(), wanted.data.size());
    std::size_t differing = 0;
    int worst = 0;
    for (std::size_t i = 0; i < found.data.size(); ++i) {
      const int error = std::abs(int{found.data[i]} - int{wanted.data[i]});
      differing += error > 0;
      worst = std::max(worst, error);
    }
    EXPECT_LE(worst, 1) << "view " << v;
    EXPECT_LE(differing, found.data.size() / 100000) << "view " << v;
  }
}

}  // namespace
}  // namespace pipegs
