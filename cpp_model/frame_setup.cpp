// SPDX-License-Identifier: Apache-2.0
// frame_setup: see frame_setup.hpp.
#include "cpp_model/frame_setup.hpp"

#include <fmt/format.h>

#include <cmath>

#include "cpp_model/control/job.hpp"

namespace pipegs {
namespace {

// A double without rounding; one that is no number becomes one that fits nowhere.
pipegs_number number(double value) {
  if (!std::isfinite(value)) return {1, 1 << 20};
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return {static_cast<int64_t>(std::ldexp(fraction, 53)), exponent - 53};
}

// Says why the driver refuses a frame.
struct Refusal {
  const Config& config;
  const PackedScene& scene;
  const Camera& camera;
  const std::optional<WindowRange>& windows;
  double near_plane;

  [[noreturn]] void fail(const char* what, double value, const std::string& limit) const {
    throw FrameError(fmt::format("camera '{}': {} is {:g}, {}", camera.name, what, value, limit));
  }
  [[noreturn]] void fail_signed(const char* what, double value, int bits) const {
    fail(what, value, fmt::format("its magnitude must be below {:g}", std::ldexp(1.0, bits)));
  }
  [[noreturn]] void fail_unsigned(const char* what, double value, int bits) const {
    fail(what, value, fmt::format("it must be at least 0 and below {:g}", std::ldexp(1.0, bits)));
  }
  [[noreturn]] void fail_side(const char* what, const char* in_windows, int pixels) const {
    if (pixels < 1 || pixels > kMaxImageSide) fail(what, pixels, fmt::format("it must be 1 to {}", kMaxImageSide));
    fail(in_windows, (pixels + config.window - 1) / config.window,
         fmt::format("at most {} fit: use larger windows", 1 << config.window_w()));
  }
  [[noreturn]] void fail_focal(const char* what, double value) const {
    if (value >= 0 && value < 1) fail(what, value, "it must be positive");
    fail_unsigned(what, value, config.focal_w() - config.focal_f());
  }
  [[noreturn]] void fail_rotation() const {
    double worst = 0;
    for (int i = 0; i < 9; ++i) {
      const double entry = camera.world_to_camera[i % 3][i / 3];
      if (!(std::abs(entry) <= std::abs(worst))) worst = entry;
    }
    fail_signed("a rotation entry", worst, config.rot_w() - config.rot_f() - 1);
  }
  [[noreturn]] void fail_windows(bool lists) const {
    const int columns = (camera.width + config.window - 1) / config.window,
              rows = (camera.height + config.window - 1) / config.window;
    const WindowRange range = windows.value_or(WindowRange{0, 0, columns - 1, rows - 1});
    if (lists) {
      throw FrameError(fmt::format("camera '{}': {} windows, but order = 1 has {} lists at most: use larger windows",
                                   camera.name, (range.last_x - range.first_x + 1) * (range.last_y - range.first_y + 1),
                                   1 << config.list_window_w()));
    }
    throw FrameError(fmt::format("camera '{}': windows ({}, {}) to ({}, {}) do not lie in {} x {} windows", camera.name,
                                 range.first_x, range.first_y, range.last_x, range.last_y, columns, rows));
  }
  double reach(double focal, double tangent) const {
    return std::sqrt(2 * std::log(config.alpha_cut)) * focal * std::hypot(1, kGuardBand * tangent);
  }
  [[noreturn]] void tell(pipegs_setup setup) const {
    const int world = config.world_w - 2 + scene.scene_exponent, center = config.center_w() - config.center_f() - 1;
    const int pixels = config.reach_w() - config.focal_f();
    const char* const guard_band = "the guard band 1.3 tan(fov/2)";
    const char* const unit_reach = "the reach of a unit scale in pixels";
    switch (setup) {
      case PIPEGS_SETUP_POSITION_X: fail_signed("the position x", camera.position.x, world);
      case PIPEGS_SETUP_POSITION_Y: fail_signed("the position y", camera.position.y, world);
      case PIPEGS_SETUP_POSITION_Z: fail_signed("the position z", camera.position.z, world);
      case PIPEGS_SETUP_ROTATION: fail_rotation();
      case PIPEGS_SETUP_FOCAL_X: fail_focal("the focal length fx", camera.fx);
      case PIPEGS_SETUP_FOCAL_Y: fail_focal("the focal length fy", camera.fy);
      case PIPEGS_SETUP_CENTER_X: fail_signed("the principal point cx", camera.cx, center);
      case PIPEGS_SETUP_CENTER_Y: fail_signed("the principal point cy", camera.cy, center);
      case PIPEGS_SETUP_GUARD_X: fail_unsigned(guard_band, kGuardBand * camera.tan_x(), 4);
      case PIPEGS_SETUP_GUARD_Y: fail_unsigned(guard_band, kGuardBand * camera.tan_y(), 4);
      case PIPEGS_SETUP_REACH_X: fail_unsigned(unit_reach, reach(camera.fx, camera.tan_x()), pixels);
      case PIPEGS_SETUP_REACH_Y: fail_unsigned(unit_reach, reach(camera.fy, camera.tan_y()), pixels);
      case PIPEGS_SETUP_NEAR_PLANE:
        fail_unsigned("the near plane", near_plane, config.world_w - 1 + scene.scene_exponent);
      case PIPEGS_SETUP_ANTIALIAS: throw FrameError("the scene is antialiased, the configuration has antialias = 0");
      case PIPEGS_SETUP_WIDTH: fail_side("the width", "the width in windows", camera.width);
      case PIPEGS_SETUP_HEIGHT: fail_side("the height", "the height in windows", camera.height);
      case PIPEGS_SETUP_WINDOWS: fail_windows(false);
      case PIPEGS_SETUP_LISTS: fail_windows(true);
      case PIPEGS_SETUP_MEMORY:
        throw FrameError(fmt::format("camera '{}': scene and pixels do not fit the machine's memory", camera.name));
      case PIPEGS_SETUP_EYES:
      case PIPEGS_SETUP_SCENE:
      case PIPEGS_SETUP_OK: break;
    }
    throw FrameError("the scene was packed for another configuration");
  }
};

}  // namespace

pipegs_configuration driver_configuration(const Config& config) {
  std::vector<uint32_t> values;
  for (const Register& reg : registers_of(config).registers) {
    if (reg.name.rfind("CONFIG_", 0) != 0) continue;
    for (const RegisterField& field : reg.fields) values.push_back(field.value);
  }
  pipegs_configuration configuration;
  size_t i = 0;
#define SET_FIELD(name, offset, low, width) configuration.name = values.at(i++);
  PIPEGS_CONFIGURATION(SET_FIELD)
#undef SET_FIELD
  return configuration;
}

pipegs_scene driver_scene(const PackedScene& scene) {
  pipegs_scene packed = {};
  packed.packed_for = driver_configuration(scene.config);
  packed.exponent = scene.scene_exponent;
  packed.sh_degree = static_cast<uint32_t>(scene.sh_degree);
  packed.antialias = scene.antialiased;
  for (size_t axis = 0; axis < 3; ++axis) {
    packed.grid_low[axis] = scene.grid.low[axis];
    packed.grid_scale[axis] = scene.grid.scale[axis];
  }
  const uint64_t line = packed.packed_for.line;
  packed.cells = scene.layout.cells * line;
  packed.groups = scene.layout.groups * line;
  packed.chunks = scene.layout.chunks * line;
  packed.gaussians = scene.layout.gaussians * line;
  packed.colors = scene.layout.colors * line;
  packed.size = scene.layout.pixels * line;
  packed.slots = scene.gaussians.size();
  return packed;
}

pipegs_camera driver_camera(const Camera& camera, double near_plane) {
  pipegs_camera taken = {};
  for (int row = 0; row < 3; ++row) {
    taken.position[row] = number(camera.position[row]);
    for (int column = 0; column < 3; ++column) {
      taken.rotation[row][column] = number(camera.world_to_camera[column][row]);  // column-major
    }
  }
  taken.focal[0] = number(camera.fx), taken.focal[1] = number(camera.fy);
  taken.center[0] = number(camera.cx), taken.center[1] = number(camera.cy);
  taken.near_plane = number(near_plane);
  taken.width = static_cast<uint32_t>(camera.width), taken.height = static_cast<uint32_t>(camera.height);
  taken.of_width = static_cast<uint32_t>(camera.of_width), taken.of_height = static_cast<uint32_t>(camera.of_height);
  return taken;
}

pipegs_job frame_job(const Config& config, const PackedScene& scene, const Camera& camera,
                     const std::optional<WindowRange>& windows, double near_plane) {
  const Refusal refusal{config, scene, camera, windows, near_plane};
  if (!(scene.config == config)) refusal.tell(PIPEGS_SETUP_SCENE);
  const pipegs_scene packed = driver_scene(scene);
  const pipegs_camera taken = driver_camera(camera, near_plane);
  pipegs_windows range = {};
  if (windows) {
    range = {static_cast<uint32_t>(windows->first_x), static_cast<uint32_t>(windows->first_y),
             static_cast<uint32_t>(windows->last_x), static_cast<uint32_t>(windows->last_y)};
  }
  const pipegs_memory memory = pipegs_place(&packed.packed_for, &packed, &taken, 0);
  pipegs_job job = {};
  const pipegs_setup setup =
      pipegs_setup_job(&packed.packed_for, &packed, &taken, windows ? &range : nullptr, &memory, &job);
  if (setup != PIPEGS_SETUP_OK) refusal.tell(setup);
  return job;
}

std::array<pipegs_number, 2> driver_half(const std::array<double, 2>& half) {
  return {number(half[0]), number(half[1])};
}

void frame_eyes(const Config& config, const PackedScene& scene, const std::array<double, 2>& half, Frame& frame) {
  pipegs_job job = frame_job(config, frame, Areas{});
  const pipegs_scene packed = driver_scene(scene);
  const std::array<pipegs_number, 2> halves = driver_half(half);
  if (pipegs_setup_eyes(&packed.packed_for, &packed, halves.data(), &job) != PIPEGS_SETUP_OK)
    throw FrameError(fmt::format("half the way between the eyes is {:g}, {:g}, its magnitude must be below {:g}",
                                 half[0], half[1], std::ldexp(1.0, config.half_eye_w() - 1 + scene.scene_exponent)));
  frame = job_frame(config, job);
}

Frame frame_setup(const Config& config, const PackedScene& scene, const Camera& camera,
                  const std::optional<WindowRange>& windows, double near_plane) {
  return job_frame(config, frame_job(config, scene, camera, windows, near_plane));
}

}  // namespace pipegs
