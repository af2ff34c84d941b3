// SPDX-License-Identifier: Apache-2.0
// Hard input: what a scene file may hold that no renderer should choke on (T1 to T3, T22 to T24, T30 of
// docs/numerics/stability.md).
#include <cmath>
#include <limits>

#include "scenes/check/scene_check.hpp"
#include "scenes/info.hpp"
#include "scenes/ply/ply.hpp"
#include "verif/scenes/ply_file.hpp"
#include "verif/scenes/scratch_folder.hpp"
#include "verif/stability/support/stability.hpp"

namespace pipegs {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();

std::vector<uint64_t> stable_pixels(const std::string& name, const Scene& scene, const Camera& camera) {
  Simulation simulation;
  expect_stable(name, scene, camera, simulation);
  return simulation.golden.pixels;
}

// Non-finite Gaussians are counted, never reach the machine, and change no pixel.
TEST(Stability, T01_NonFiniteInputIsCulledAndCounted) {
  const Scene good = random_scene(101, 120, 1);
  Scene bad = good;
  const float values[] = {kInf, -kInf, std::nanf("")};
  for (int i = 0; i < 12; ++i) {
    Gaussian g = gaussian_at({0, 0, 2});
    if (i % 4 == 0) g.mean.y = values[i / 4];
    if (i % 4 == 1) g.log_scale.x = i / 4 == 1 ? 89.0f : values[i / 4];  // -Inf is legal; exp(89) is infinite in float
    if (i % 4 == 2) g.rotation.z = values[i / 4];
    if (i % 4 == 3) g.sh_dc.x = values[i / 4];
    bad.gaussians.push_back(g);
    bad.sh_rest.insert(bad.sh_rest.end(), 9, 0.1f);
  }
  const Camera camera = test_camera(100, 70);
  Simulation simulation;
  expect_stable("T01", bad, camera, simulation);
  EXPECT_EQ(simulation.packed.counts.non_finite, 12u);
  EXPECT_EQ(simulation.golden.pixels, stable_pixels("T01 without", good, camera));
}

TEST(Stability, T02_ZeroQuaternionIsCulledAndTold) {
  Scene scene = random_scene(102, 100, 0);
  for (size_t i = 0; i < 30; ++i) scene.gaussians[3 * i].rotation = glm::vec4(0);
  Simulation simulation;
  expect_stable("T02", scene, test_camera(90, 60), simulation);
  EXPECT_EQ(simulation.packed.counts.zero_quaternion, 30u);
  EXPECT_NE(to_text(inspect(scene, check_scene(scene))).find("zero quaternion, culled: 30"), std::string::npos);
}

// The host normalises in double: any length gives the same record, so the same pixels.
TEST(Stability, T03_QuaternionsOfAnyLength) {
  const Scene unit = random_scene(103, 60, 0);
  const Camera camera = test_camera(64, 64);
  const std::vector<uint64_t> pixels = stable_pixels("T03", unit, camera);
  for (const int power : {-60, -20, 20, 60}) {  // powers of two: the float's mantissa stays
    Scene scaled = unit;
    for (Gaussian& g : scaled.gaussians) g.rotation *= std::ldexp(1.0f, power);
    Simulation simulation;
    simulate_golden(scaled, camera, stable_machine(), simulation);
    EXPECT_EQ(simulation.golden.pixels, pixels) << "length 2^" << power;
  }
}

// What the headers of the field say reaches the scene, and the machine that compensates stays within its bounds. The
// RTL of such a machine: Frame.AnAntialiasedSceneOnTheMachineThatCompensates.
TEST(Stability, T22_AntialiasedScenes) {
  const ScratchFolder scratch;
  for (const auto& [comment, expected] : {std::pair{"antialiased 1", true},
                                          {"antialiased 0", false},
                                          {"SplatRenderMode: mip", true},
                                          {"SplatRenderMode: default", false}}) {
    PlyText text;
    text.comments = {comment};
    EXPECT_EQ(read_ply(scratch.write("a.ply", text.build(plain_columns(1, 0)))).antialiased, expected) << comment;
  }
  Scene scene = random_scene(122, 150, 0);
  scene.antialiased = true;
  for (size_t i = 0; i < 50; ++i)
    scene.gaussians[i].log_scale = glm::vec3(i % 2 == 0 ? -kInf : -9.0f);  // the floor of 2.5e-5
  Simulation simulation;
  SimulateOptions options = stable_machine();
  options.config.antialias = 1;
  simulate_golden(scene, test_camera(96, 64), options, simulation);
  expect_bounded("T22", scene, test_camera(96, 64), options, simulation);
}

// Exported without the logarithm: the linter says so, and the machine renders the giants it was asked for.
TEST(Stability, T23_ScalesWithoutLogarithm) {
  Scene scene = random_scene(123, 40, 0);
  for (Gaussian& g : scene.gaussians) g.log_scale = glm::vec3(8);
  EXPECT_NE(to_text(inspect(scene, check_scene(scene))).find("scales look linear where logarithms are expected"),
            std::string::npos);
  expect_stable("T23", scene, test_camera(64, 48));
}

// A scene without any symmetry, seen along each axis: mirrored axes would put its one red Gaussian elsewhere.
TEST(Stability, T24_AxesAreNotMirrored) {
  const Camera camera = test_camera(64, 48);
  Simulation simulation;
  expect_stable("T24",
                scene_of({gaussian_at({0.3f, 0.1f, 2}, 0.02f, 0.9, {1.5f, -1, -1}),
                          gaussian_at({-0.2f, -0.15f, 3}, 0.02f, 0.9, {-1, -1, 1.5f})}),
                camera, simulation);
  const Image& image = simulation.golden.image;
  const auto brightest = [&](int channel) {
    size_t best = 0;
    for (size_t i = 0; i < image.rgb.size(); ++i) best = image.rgb[i][channel] > image.rgb[best][channel] ? i : best;
    return std::pair{static_cast<int>(best) % image.width, static_cast<int>(best) / image.width};
  };
  // x right, y down, z forward: 100 x / z + centre.
  EXPECT_EQ(brightest(0), (std::pair{46, 28}));  // 31.5 + 15, 23.5 + 5, of equal pixels the first
  EXPECT_EQ(brightest(2), (std::pair{25, 18}));
}

// f_rest missing or of each degree, comments, three formats: the same Gaussians.
TEST(Stability, T30_LoaderMatrix) {
  const ScratchFolder scratch;
  for (const int rest : {0, 9, 24, 45}) {
    const std::vector<Column> columns = plain_columns(3, rest);
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
      PlyText text;
      text.format = format;
      text.comments = {"made by a test", "", "end_header is not here"};
      const Scene scene = read_ply(scratch.write("a.ply", text.build(columns)));
      EXPECT_EQ(3 * sh_rest_count(scene.sh_degree), rest) << format;
      for (size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(scene.gaussians[i].mean.z, static_cast<float>(value_of(columns, "z", i)));
        EXPECT_EQ(scene.gaussians[i].rotation[3], static_cast<float>(value_of(columns, "rot_3", i)));
        if (rest > 0) {
          EXPECT_EQ(sh_rest_of(scene, i)[1],
                    static_cast<float>(value_of(columns, fmt::format("f_rest_{}", rest / 3), i)))
              << "channel-major to coefficient-major";
        }
      }
    }
  }
  EXPECT_EQ(read_ply(scratch.write("a.ply", PlyText{}.build(plain_columns(1, 72)))).sh_degree, 3) << "degree 4";
}

}  // namespace
}  // namespace pipegs
