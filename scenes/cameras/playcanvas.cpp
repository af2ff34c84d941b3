// SPDX-License-Identifier: Apache-2.0
// playcanvas: cameras as PlayCanvas' tools write them: lists of frames, SuperSplat's viewer and its editor.
//
// Layout  frames list      {"frames": [{position, target, up, fov}]}
//         settings.json    of the viewer: animTracks[].keyframes.values holds position, target, fov, one behind the
//                          other; cameras[].initial (in old files "camera") has position, target, fov
//         document.json    of the editor: poseSets[].poses[] with position, target, fov
// Idea    Their world is that of the .ply turned by 180 degrees about z: x and y are negated. A camera looks from
//         position to target; without "up" it does not roll. fov is in degrees: from top to bottom in a list of frames
//         (as splat-transform takes it), along the longer side of the picture in SuperSplat's files.
// Rule    None of them has a size. Views: the keyframes, then the cameras at the start, each track and set in order.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenes/cameras/entry.hpp"
#include "scenes/cameras/forms.hpp"
#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;

glm::dvec3 turned(const glm::dvec3& v) { return {-v.x, -v.y, v.z}; }

struct Pose {
  glm::dvec3 position, target, up{0, 1, 0};
  double fov = 0;
  bool fov_of_longer_side = true;
};

constexpr RealRange kFov{.low = 0, .high = 179.9, .above = true};

Camera camera_of(const CameraEntry& entry, const Pose& pose, const CameraReading& reading) {
  const glm::dvec3 ahead = turned(pose.target - pose.position), down = -turned(pose.up);
  const double distance = glm::length(ahead), upright = glm::length(down);
  if (!(distance > 0) || !std::isfinite(distance))
    entry.fail("target", "found that of position, expected another point");
  if (!(upright > 0) || !std::isfinite(upright)) entry.fail("up", "found no direction, expected one");
  const glm::dvec3 z = ahead / distance, across = glm::cross(down / upright, z);
  if (!(glm::length(across) > 1e-9))
    entry.fail("up", "found the direction in which the camera looks, expected another");
  Camera camera;
  take_size(entry, reading, camera);
  const glm::dvec3 x = glm::normalize(across);
  camera.position = turned(pose.position);
  camera.world_to_camera = glm::transpose(glm::dmat3(x, glm::cross(z, x), z));
  const int side = pose.fov_of_longer_side ? std::max(camera.width, camera.height) : camera.height;
  camera.fx = camera.fy = side / (2 * std::tan(glm::radians(pose.fov) / 2));
  camera.cx = (camera.width - 1) / 2.0;
  camera.cy = (camera.height - 1) / 2.0;
  return camera;
}

Pose read_pose(const CameraEntry& entry) {
  entry.must_be_object();
  Pose pose;
  pose.position = entry.triple("position");
  pose.target = entry.triple("target");
  pose.fov = entry.number("fov", kFov);
  return pose;
}

const Json& list_in(const CameraEntry& entry, const std::string& field) {
  const Json& list = entry.at(field);
  if (!list.is_array()) entry.fail(field, fmt::format("found {}, expected a list", quote(json_text(list))));
  return list;
}

class Views {
 public:
  explicit Views(const CameraReading& reading) : reading_(reading) {}
  void add(const CameraEntry& entry, const Pose& pose, const std::string& name) {
    cameras_.push_back(camera_of(entry, pose, reading_));
    cameras_.back().id = static_cast<int>(cameras_.size()) - 1;
    cameras_.back().name = name;
  }
  std::vector<Camera> take(const std::string& file) {
    if (cameras_.empty()) throw InputError(file, "top level", "found no camera in it, expected at least one");
    return std::move(cameras_);
  }

 private:
  const CameraReading& reading_;
  std::vector<Camera> cameras_;
};

// Three numbers of a list of 3 times as many as there are keyframes.
glm::dvec3 triple_of(const CameraEntry& values, const std::string& field, std::size_t i) {
  const Json& list = values.json[field];
  return values.triple(Json::array({list[3 * i], list[3 * i + 1], list[3 * i + 2]}), fmt::format("{} {}", field, i));
}

// `shared` holds a fov for a track that has none.
void add_track(const std::string& file, std::size_t track, const Json& json, const Json* shared, Views& views) {
  const std::string where = fmt::format("animTracks {}", track);
  const CameraEntry whole{file, where, json};
  whole.must_be_object();
  const CameraEntry keyframes{file, where + ", keyframes", whole.at("keyframes")};
  keyframes.must_be_object();
  const CameraEntry values{file, where + ", values", keyframes.at("values")};
  values.must_be_object();
  const std::size_t count = list_in(keyframes, "times").size();
  const auto must_hold = [&](const std::string& field, std::size_t numbers) {
    if (const std::size_t found = list_in(values, field).size(); found != numbers)
      values.fail(field, fmt::format("found {} numbers, expected {} of {} keyframes", found, numbers, count));
  };
  must_hold("position", 3 * count);
  must_hold("target", 3 * count);
  const bool own_fov = values.find("fov") != nullptr;
  if (own_fov) must_hold("fov", count);
  for (std::size_t i = 0; i < count; ++i) {
    Pose pose;
    pose.position = triple_of(values, "position", i);
    pose.target = triple_of(values, "target", i);
    const Json fov = own_fov ? Json{{"fov", values.json["fov"][i]}} : Json::object();
    pose.fov = CameraEntry{file, fmt::format("{}, keyframe {}", where, i), fov, shared}.number("fov", kFov);
    views.add(values, pose, fmt::format("track_{}_{}", track, i));
  }
}

std::vector<Camera> viewer_cameras(const std::string& file, const Json& json, Views& views) {
  const CameraEntry top{file, "top level", json};
  std::vector<CameraEntry> starts;
  if (top.find("cameras") != nullptr) {
    const Json& list = list_in(top, "cameras");
    for (std::size_t i = 0; i < list.size(); ++i) {
      const CameraEntry camera{file, fmt::format("cameras {}", i), list[i]};
      camera.must_be_object();
      starts.push_back({file, fmt::format("cameras {}, initial", i), camera.at("initial")});
    }
  } else if (const Json* camera = top.find("camera"); camera != nullptr) {
    starts.push_back({file, "camera", *camera});
  }
  for (const CameraEntry& start : starts) start.must_be_object();
  if (top.find("animTracks") != nullptr) {
    const Json& tracks = list_in(top, "animTracks");
    for (std::size_t t = 0; t < tracks.size(); ++t)
      add_track(file, t, tracks[t], starts.empty() ? nullptr : &starts[0].json, views);
  }
  for (std::size_t i = 0; i < starts.size(); ++i) {
    // Old files have a camera without a place, for its fov alone.
    if (starts[i].find("position") != nullptr) views.add(starts[i], read_pose(starts[i]), fmt::format("start_{}", i));
  }
  return views.take(file);
}

std::vector<Camera> editor_cameras(const std::string& file, const Json& json, Views& views) {
  const CameraEntry top{file, "top level", json};
  const Json* shared = top.find("camera");
  if (shared != nullptr) CameraEntry{file, "camera", *shared}.must_be_object();
  const Json& sets = list_in(top, "poseSets");
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const CameraEntry set{file, fmt::format("poseSets {}", s), sets[s]};
    set.must_be_object();
    const Json& poses = list_in(set, "poses");
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const CameraEntry entry{file, fmt::format("poseSets {}, pose {}", s, i), poses[i], shared};
      views.add(entry, read_pose(entry), entry.text_or("name", fmt::format("pose_{}_{}", s, i)));
    }
  }
  return views.take(file);
}

}  // namespace

std::vector<Camera> playcanvas_cameras(const std::string& file, const Json& json, const CameraReading& reading) {
  Views views(reading);
  if (json.contains("poseSets")) return editor_cameras(file, json, views);
  if (!json.contains("frames")) return viewer_cameras(file, json, views);
  for (std::size_t i = 0; i < json["frames"].size(); ++i) {
    const CameraEntry entry{file, fmt::format("frame {}", i), json["frames"][i]};
    Pose pose = read_pose(entry);
    pose.fov_of_longer_side = false;
    if (entry.find("up") != nullptr) pose.up = entry.triple("up");
    views.add(entry, pose, fmt::format("frame_{}", i));
  }
  return views.take(file);
}

}  // namespace pipegs
