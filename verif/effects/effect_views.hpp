// SPDX-License-Identifier: Apache-2.0
// effect_views.hpp: views that call for one part of the machine each, and what the detectors say of a view on a
// machine.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "sim/effects/effects.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {

struct View {
  std::string name;
  Scene scene;
  Camera camera;
};

// A Gaussian in each of two windows, at one depth, far from the near plane; no SH.
inline Scene quiet_scene() { return scene_of({gaussian_at({-0.5f, 0, 2}), gaussian_at({0.6f, 0, 2})}); }

// The same of a training that compensates the dilation. Needs antialias = 1, so it is not one of views().
inline Scene antialiased_scene() {
  Scene scene = quiet_scene();
  scene.antialiased = true;
  return scene;
}

// The same with SH of degree 3, of which only one band is not zero.
inline Scene banded_scene(int band) {
  Scene scene = quiet_scene();
  scene.sh_degree = 3;
  scene.sh_rest.assign(scene.gaussians.size() * 45, 0);
  for (size_t i = 0; i < scene.gaussians.size(); ++i) {
    for (int k = sh_rest_count(band - 1); k < sh_rest_count(band); ++k)
      scene.sh_rest[i * 45 + static_cast<size_t>(3 * k)] = 0.3f;
  }
  return scene;
}

// One thing each, beside others that come with it.
inline Scene near_scene() {
  return scene_of({gaussian_at({0, 0, 0.19f}, 0.01f), gaussian_at({0.02f, 0, 0.5f}), gaussian_at({0.1f, 0, 8}),
                   gaussian_at({0.1f, 0.5f, 8})});
}
inline Scene behind_scene() {  // the camera, in one chunk with what it sees: the last ones make cells that large
  return scene_of(
      {gaussian_at({0, 0, -0.1f}, 0.5f), gaussian_at({0, 0, 2}), gaussian_at({0, 0, 20}), gaussian_at({0, 0, 21})});
}
inline Scene wide_scene() { return scene_of({gaussian_at({1.2f, 0, 2}, 0.4f)}); }
inline Scene bright_scene() {  // SH carries red above what a packed colour holds
  Scene scene = scene_of({gaussian_at({-0.5f, 0, 2}, 0.05f, 0.8, {12, 1, 0})});
  scene.sh_degree = 1;
  scene.sh_rest = {0, 0, 0, 0.6f, 0, 0, 0, 0, 0};
  return scene;
}
inline Scene opaque_scene() {
  std::vector<Gaussian> stack;
  for (int i = 0; i < 6; ++i) stack.push_back(gaussian_at({0.1f, 0, 2 + 0.1f * static_cast<float>(i)}, 0.2f, 0.98));
  return scene_of(stack);
}
inline Scene tied_scene(int count) {
  return scene_of(std::vector<Gaussian>(static_cast<size_t>(count), gaussian_at({0.3f, 0, 2}, 0.05f, 0.1)));
}
// Faint dots of one window; nearly all of one layer and of one step of depth, as one in 32 lies far behind.
inline Scene crowded_scene() {
  std::vector<Gaussian> dots;
  for (int i = 0; i < 12000; ++i) {
    const auto across = [](int n) { return 0.011f * static_cast<float>(n - 50); };
    const float depth = static_cast<float>(i) / 300000;
    dots.push_back(gaussian_at({across(i % 101), across(i * 7 % 103), (i % 32 == 0 ? 20 : 2) + depth}, 0.002f, 0.05));
  }
  return scene_of(dots);
}

// A camera that looks 30 degrees beside the axis of the slabs, and wide Gaussians of which the nearer slab holds the
// deeper ones.
inline Camera turned_camera() {
  Camera camera = test_camera(64, 64);
  const double c = std::sqrt(0.75);
  camera.world_to_camera = glm::dmat3(c, 0, 0.5, 0, 1, 0, -0.5, 0, c);
  return camera;
}
inline Scene turned_scene() {
  const auto at = [](double x, double z, glm::vec3 color) {
    return gaussian_at({x, 0, z}, 0.3f, 0.8, color);
  };  // depth (x + sqrt(3) z) / 2
  return scene_of(
      {at(1.55, 1.64, {2, 0, 0}), at(1.56, 1.65, {2, 0, 0}), at(0.55, 1.98, {0, 2, 0}), at(0.56, 1.99, {0, 2, 0})});
}

inline const std::vector<View>& views() {
  static const std::vector<View> all = {
      {"empty", scene_of({}), test_camera(100, 70)},     {"quiet", quiet_scene(), test_camera(128, 64)},
      {"band 1", banded_scene(1), test_camera(128, 64)}, {"band 2", banded_scene(2), test_camera(128, 64)},
      {"band 3", banded_scene(3), test_camera(128, 64)}, {"near", near_scene(), test_camera(64, 64)},
      {"behind", behind_scene(), test_camera(64, 64)},   {"wide", wide_scene(), test_camera(64, 64)},
      {"bright", bright_scene(), test_camera(128, 64)},  {"opaque", opaque_scene(), test_camera(64, 64)},
      {"two tied", tied_scene(2), test_camera(64, 64)},  {"twenty tied", tied_scene(20), test_camera(64, 64)},
      {"crowd", crowded_scene(), test_camera(64, 64)},   {"cloud", random_scene(3, 400, 3), test_camera(130, 66, 60)},
      {"turned", turned_scene(), turned_camera()},       {"flat cloud", random_scene(9, 300, 0), test_camera(128, 96)}};
  return all;
}

inline const View& find_view(const std::string& name) {
  return *std::find_if(views().begin(), views().end(), [&](const View& v) { return v.name == name; });
}

// A view's golden frame on the machine `asked`, and what it calls for.
struct Looked {
  explicit Looked(const std::string& name, const SimulateOptions& asked = {}) : view(find_view(name)), options(asked) {
    simulate_golden(view.scene, view.camera, options, simulation);
    findings = find_effects(effect_facts(view.scene, options, simulation, true));
  }
  const Effect::Verdict& verdict(std::string_view name) const {
    return std::find_if(findings.begin(), findings.end(),
                        [&](const EffectFinding& f) { return f.effect->name == name; })
        ->verdict;
  }
  std::vector<std::string> called() const {
    std::vector<std::string> names;
    for (const EffectFinding& f : findings) {
      if (f.verdict.called_for) names.emplace_back(f.effect->name);
    }
    return names;
  }
  // The golden pixels of another machine.
  std::vector<uint64_t> pixels(const SimulateOptions& other) const {
    Simulation lean;
    simulate_golden(view.scene, view.camera, other, lean);
    return lean.golden.pixels;
  }

  const View& view;
  SimulateOptions options;
  Simulation simulation;
  std::vector<EffectFinding> findings;
};

}  // namespace pipegs
