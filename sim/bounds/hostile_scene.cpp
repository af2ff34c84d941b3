// SPDX-License-Identifier: Apache-2.0
// hostile_scene.cpp: see hostile_scene.hpp.
#include "sim/bounds/hostile_scene.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>

#include "cpp_model/float/projection.hpp"
#include "scenes/generate/generate_random.hpp"

namespace pipegs {
namespace {

using generate::Random;

constexpr float kInf = std::numeric_limits<float>::infinity();

double log_uniform(Random& random, double low, double high) { return low * std::pow(high / low, random.uniform()); }
int below(Random& random, int n) { return static_cast<int>(random.bits() % static_cast<uint64_t>(n)); }
bool one_in(Random& random, int n) { return below(random, n) == 0; }
float log_of(double x) { return static_cast<float>(std::log(x)); }

glm::dquat any_rotation(Random& random) {
  const double w = random.normal(), x = random.normal(), y = random.normal(), z = random.normal();
  return glm::normalize(glm::dquat(w, x, y, z + 1e-9));
}

Camera any_camera(Random& random, const StressShape& shape) {
  Camera camera;
  camera.name = "stress";
  camera.width = shape.width > 0 ? shape.width : 1 + below(random, 160);
  camera.height = shape.height > 0 ? shape.height : 1 + below(random, 120);
  const double size = std::max(camera.width, camera.height);
  camera.fx = size * log_uniform(random, 0.3, 6);
  camera.fy = one_in(random, 3) ? camera.fx : camera.fx * log_uniform(random, 0.7, 1.4);
  camera.cx = (camera.width - 1) / 2.0, camera.cy = (camera.height - 1) / 2.0;
  if (one_in(random, 2)) {
    camera.cx += size * (random.uniform() - 0.5);
    camera.cy += size * (random.uniform() - 0.5);
  }
  if (!one_in(random, 4)) camera.world_to_camera = glm::mat3_cast(any_rotation(random));
  const double far = one_in(random, 3) ? log_uniform(random, 1, 1000) : 1;
  for (int i = 0; i < 3; ++i) camera.position[i] = one_in(random, 4) ? 0 : far * (2 * random.uniform() - 1);
  return camera;
}

// Draws Gaussians in the camera's space (x right, y down, z forward) and moves them to the world.
class Hostile {
 public:
  Hostile(Random& random, const StressView& view) : random_(random), camera_(view.camera), near_(view.near_plane) {
    shared_depth_ = near_ * log_uniform(random_, 1.1, 50);
    largest_ = one_in(random_, 3) ? log_uniform(random_, 1, 100) : 1;
  }

  Gaussian next() {
    Gaussian g{};
    const double z = depth();
    const glm::dvec2 at = place();
    mean_ = {at.x * z, at.y * z, z};
    size_ = z / camera_.fx;  // a pixel there
    shape(g);
    g.opacity_logit = opacity();
    for (int i = 0; i < 3; ++i) g.sh_dc[i] = color();
    place_in_world(g);
    if (one_in(random_, 40)) damage(g);
    return g;
  }
  float coefficient() {
    return one_in(random_, 50) ? static_cast<float>(40 * (random_.uniform() - 0.5))
                               : static_cast<float>(0.6 * (random_.uniform() - 0.5));
  }

 private:
  double depth() {
    switch (below(random_, 10)) {
      case 0: return near_ * (1 + 1e-7 * (below(random_, 5) - 2));  // on the near plane
      case 1: return near_ * log_uniform(random_, 1.0001, 1.1);
      case 2: return -near_ * log_uniform(random_, 0.1, 10);  // behind
      case 3: return shared_depth_;
      case 4: return near_ * log_uniform(random_, 100, 1e5);
      default: return near_ * log_uniform(random_, 1.2, 100);
    }
  }
  // x/z and y/z.
  glm::dvec2 place() {
    const double tx = camera_.width / (2 * camera_.fx), ty = camera_.height / (2 * camera_.fy);
    const glm::dvec2 center{(((camera_.width - 1) / 2.0) - camera_.cx) / camera_.fx,
                            (((camera_.height - 1) / 2.0) - camera_.cy) / camera_.fy};
    switch (below(random_, 8)) {
      case 0: {  // the edge of the guard band
        constexpr double kBy[] = {1.29, 1.3, 1.3000001, 1.31, 5};
        return {tx * kBy[below(random_, 5)] * (one_in(random_, 2) ? 1 : -1), ty * (2 * random_.uniform() - 1)};
      }
      case 1:
        return {tx * (random_.uniform() - 0.5) * 200,
                ty * (random_.uniform() - 0.5) * 200};  // thousands of pixels away
      case 2:
        return {(below(random_, camera_.width) - camera_.cx) / camera_.fx,
                (below(random_, camera_.height) - camera_.cy) / camera_.fy};  // on a pixel
      default:
        return center + glm::dvec2(tx * 1.2 * (2 * random_.uniform() - 1), ty * 1.2 * (2 * random_.uniform() - 1));
    }
  }
  void shape(Gaussian& g) {
    double pixels = log_uniform(random_, 0.3, 60);
    if (one_in(random_, 6)) pixels = log_uniform(random_, 1e-6, 1);
    if (one_in(random_, 6)) pixels = log_uniform(random_, 50, 3e4);
    if (one_in(random_, 30)) pixels = std::ldexp(1.0, below(random_, 61) - 30);
    const double ratio = one_in(random_, 2) ? log_uniform(random_, 1, 1e8) : log_uniform(random_, 1, 10);
    const double small = pixels * size_ / ratio,
                 middle = one_in(random_, 2) ? small : log_uniform(random_, small, pixels * size_);
    g.log_scale = {log_of(pixels * size_), log_of(middle), log_of(small)};
    if (one_in(random_, 12)) g.log_scale[below(random_, 3)] = -kInf;
    glm::dquat q = any_rotation(random_);
    if (one_in(random_, 2)) {  // in the image plane at a multiple of 7.5 degrees, a little out of it
      q = glm::angleAxis(glm::radians(7.5 * below(random_, 48)), glm::dvec3(0, 0, 1)) *
          glm::angleAxis(glm::radians(7.5 * below(random_, 3)), glm::dvec3(0, 1, 0));
    }
    turn_ = q;
  }
  float opacity() {
    switch (below(random_, 10)) {
      case 0: return kInf;
      case 1: return -kInf;
      case 2: return -5.5373344f + 4e-7f * static_cast<float>(below(random_, 5) - 2);  // 1/255 and its neighbours
      case 3: return 4.595f;                                                           // 0.99
      case 4: return static_cast<float>(10 * random_.uniform());
      default: return log_of(log_uniform(random_, 1.0 / 300, 1)) + 0.7f;
    }
  }
  float color() {
    return static_cast<float>((one_in(random_, 12) ? 60 : one_in(random_, 3) ? 8 : 3.5) * (random_.uniform() - 0.5));
  }
  void place_in_world(Gaussian& g) {
    const glm::dmat3 to_world = glm::transpose(camera_.world_to_camera);
    const glm::dvec3 world = to_world * mean_ + camera_.position;
    for (int i = 0; i < 3; ++i) g.mean[i] = static_cast<float>(world[i] * (one_in(random_, 200) ? largest_ : 1));
    const glm::dquat q = glm::normalize(glm::quat_cast(to_world) * turn_);
    const double length = one_in(random_, 8) ? log_uniform(random_, 1e-18, 1e18) : 1;
    g.rotation = {static_cast<float>(q.w * length), static_cast<float>(q.x * length), static_cast<float>(q.y * length),
                  static_cast<float>(q.z * length)};
  }
  void damage(Gaussian& g) {
    const float bad = one_in(random_, 2) ? std::numeric_limits<float>::quiet_NaN() : one_in(random_, 2) ? kInf : -kInf;
    switch (below(random_, 6)) {
      case 0: g.mean[below(random_, 3)] = bad; break;
      case 1: g.log_scale[below(random_, 3)] = bad; break;
      case 2: g.rotation = glm::vec4(0); break;
      case 3: g.rotation[below(random_, 4)] = bad; break;
      case 4: g.opacity_logit = std::numeric_limits<float>::quiet_NaN(); break;
      default: g.sh_dc[below(random_, 3)] = bad; break;
    }
  }

  Random& random_;
  const Camera& camera_;
  double near_, shared_depth_, largest_, size_ = 1;
  glm::dvec3 mean_{0};
  glm::dquat turn_{1, 0, 0, 0};
};

}  // namespace

StressView stress_view(uint64_t seed, const StressShape& shape) {
  Random random(generate::mixed(seed + 1));
  StressView view;
  view.near_plane = one_in(random, 4) ? log_uniform(random, 0.001, 1) : 0.2;
  view.camera = any_camera(random, shape);
  view.scene.name = "stress";
  view.scene.sh_degree = below(random, 4);
  const int count = shape.gaussians > 0 ? shape.gaussians : static_cast<int>(log_uniform(random, 10, 300));
  Hostile hostile(random, view);
  for (int i = 0; i < count; ++i) {
    view.scene.gaussians.push_back(hostile.next());
    for (int k = 0; k < 3 * sh_rest_count(view.scene.sh_degree); ++k)
      view.scene.sh_rest.push_back(hostile.coefficient());
  }
  return view;
}

}  // namespace pipegs
