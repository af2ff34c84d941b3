// SPDX-License-Identifier: Apache-2.0
// eye_pair_test: two cameras as eyes of one between them.
#include "scenes/cameras/eye_pair.hpp"

#include <numbers>

#include "verif/scenes/refused.hpp"

namespace pipegs {
namespace {

// Eyes: what is not parallel, of one lens and side by side is refused, and the line says by how much.
TEST(EyePair, ThatIsParallelHasACameraBetween) {
  const Camera left = look_at("left", 0, 640, 480, {1, -2, 3}, {0.1, 0.2, 9}, 60);
  const glm::dvec3 right_axis = glm::transpose(left.world_to_camera)[0], down = glm::transpose(left.world_to_camera)[1],
                   front = glm::transpose(left.world_to_camera)[2];
  Camera right = left;
  right.name = "right";
  right.position += 0.06 * right_axis + 0.01 * down;
  const EyePair pair = eye_pair(left, right);
  EXPECT_NEAR(pair.half[0], 0.03, 1e-12);
  EXPECT_NEAR(pair.half[1], 0.005, 1e-12);
  EXPECT_NEAR(glm::length(pair.middle.position - (left.position + right.position) / 2.0), 0, 1e-12);
  EXPECT_EQ(pair.middle.world_to_camera, left.world_to_camera);
  EXPECT_EQ(eye_pair(left, left).half, (std::array{0.0, 0.0}));

  Camera turned = right;
  const double angle = 0.5 * std::numbers::pi / 180;
  turned.world_to_camera =
      glm::dmat3(std::cos(angle), 0, -std::sin(angle), 0, 1, 0, std::sin(angle), 0, std::cos(angle)) *
      left.world_to_camera;
  EXPECT_EQ(refusal([&] { eye_pair(left, turned); }),
            "views 'left' and 'right': they are turned by 0.5 degrees, expected parallel eyes");
  Camera ahead = right;
  ahead.position = left.position + 0.06 * right_axis + 0.08 * front;
  EXPECT_EQ(refusal([&] { eye_pair(left, ahead); }),
            "views 'left' and 'right': the second one stands 0.08 before the first one, of a way of 0.1, expected "
            "eyes side by side");
  Camera longer = right;
  longer.fx = 2 * left.fx;
  EXPECT_NE(refusal([&] { eye_pair(left, longer); }).find(": fx: found "), std::string::npos);
  Camera larger = right;
  larger.width = 641;
  EXPECT_NE(refusal([&] { eye_pair(left, larger); }).find("found 640x480 and 641x480 pixels"), std::string::npos);
}

}  // namespace
}  // namespace pipegs
