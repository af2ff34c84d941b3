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
#include <optional>

#include "scenes/cameras/forms.hpp"

namespace pipegs {
namespace {

glm::dvec3 turned(const glm::dvec3& v) { return {-v.x, -v.y, v.z}; }

struct Pose {
  glm::dvec3 position, target, up{0, 1, 0};
  double fov = 0;
  bool fov_of_longer_side = true;
};

constexpr RealRange kFov{.low = 0, .high = 179.9, .above = true};

Camera camera_of(const JsonNode& place, const Pose& pose, const CameraReading& reading) {
  const glm::dvec3 ahead = turned(pose.target - pose.position), down = -turned(pose.up);
  const double distance = glm::length(ahead), upright = glm::length(down);
  if (!(distance > 0) || !std::isfinite(distance))
    place.fail("found the position as its target, expected another point");
  if (!(upright > 0) || !std::isfinite(upright)) place.fail("found no direction in up, expected one");
  const glm::dvec3 z = ahead / distance, across = glm::cross(down / upright, z);
  if (!(glm::length(across) > 1e-9))
    place.fail("found the direction in which the camera looks in up, expected another");
  Camera camera;
  take_size(place, reading, camera);
  const glm::dvec3 x = glm::normalize(across);
  camera.position = turned(pose.position);
  camera.world_to_camera = glm::transpose(glm::dmat3(x, glm::cross(z, x), z));
  const int side = pose.fov_of_longer_side ? std::max(camera.width, camera.height) : camera.height;
  camera.fx = camera.fy = side / (2 * std::tan(glm::radians(pose.fov) / 2));
  camera.cx = (camera.width - 1) / 2.0;
  camera.cy = (camera.height - 1) / 2.0;
  return camera;
}

// `others` holds a fov for an entry that has none.
double fov_of(const JsonNode& entry, const std::optional<JsonNode>& others) {
  return (others && !entry.has("fov") ? *others : entry)["fov"].real(kFov);
}

Pose read_pose(const JsonNode& entry, const std::optional<JsonNode>& others = {}) {
  return {.position = triple(entry["position"]), .target = triple(entry["target"]), .fov = fov_of(entry, others)};
}

class Views {
 public:
  explicit Views(const CameraReading& reading) : reading_(reading) {}
  void add(const JsonNode& place, const Pose& pose, const std::string& name) {
    cameras_.push_back(camera_of(place, pose, reading_));
    cameras_.back().id = static_cast<int>(cameras_.size()) - 1;
    cameras_.back().name = name;
  }
  std::vector<Camera> take(const JsonNode& json) {
    if (cameras_.empty()) json.fail("found no camera in it, expected at least one");
    return std::move(cameras_);
  }

 private:
  const CameraReading& reading_;
  std::vector<Camera> cameras_;
};

void add_track(const JsonNode& track, std::size_t number, const std::optional<JsonNode>& start, Views& views) {
  const JsonNode keyframes = track["keyframes"], values = keyframes["values"];
  const std::size_t count = keyframes["times"].size();
  const auto must_hold = [&](const char* field, std::size_t numbers) {
    const JsonNode list = values[field];
    if (list.size() != numbers)
      list.fail(fmt::format("found {} numbers, expected {} of {} keyframes", list.size(), numbers, count));
  };
  must_hold("position", 3 * count);
  must_hold("target", 3 * count);
  const bool own_fov = values.has("fov");
  if (own_fov) must_hold("fov", count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto place = [&](const char* field) {
      const JsonNode list = values[field];
      return glm::dvec3(list[3 * i].real(), list[3 * i + 1].real(), list[3 * i + 2].real());
    };
    const double fov = own_fov ? values["fov"][i].real(kFov) : fov_of(values, start);
    views.add(values, {.position = place("position"), .target = place("target"), .fov = fov},
              fmt::format("track_{}_{}", number, i));
  }
}

std::vector<Camera> viewer_cameras(const JsonNode& json, Views& views) {
  std::vector<JsonNode> starts;
  if (json.has("cameras")) {
    const JsonNode list = json["cameras"];
    for (std::size_t i = 0; i < list.size(); ++i) starts.push_back(list[i]["initial"]);
  } else if (json.has("camera")) {
    starts.push_back(json["camera"]);
  }
  for (const JsonNode& start : starts) start.keys();  // an object
  if (json.has("animTracks")) {
    const JsonNode tracks = json["animTracks"];
    for (std::size_t t = 0; t < tracks.size(); ++t)
      add_track(tracks[t], t, starts.empty() ? std::nullopt : std::optional(starts[0]), views);
  }
  for (std::size_t i = 0; i < starts.size(); ++i) {
    // Old files have a camera without a place, for its fov alone.
    if (starts[i].has("position")) views.add(starts[i], read_pose(starts[i]), fmt::format("start_{}", i));
  }
  return views.take(json);
}

std::vector<Camera> editor_cameras(const JsonNode& json, Views& views) {
  std::optional<JsonNode> shared;
  if (json.has("camera")) shared = json["camera"];
  if (shared) shared->keys();  // an object
  const JsonNode sets = json["poseSets"];
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const JsonNode poses = sets[s]["poses"];
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const JsonNode pose = poses[i];
      views.add(pose, read_pose(pose, shared),
                pose.has("name") ? pose["name"].text() : fmt::format("pose_{}_{}", s, i));
    }
  }
  return views.take(json);
}

}  // namespace

std::vector<Camera> playcanvas_cameras(const JsonNode& json, const CameraReading& reading) {
  Views views(reading);
  if (json.has("poseSets")) return editor_cameras(json, views);
  if (!json.has("frames")) return viewer_cameras(json, views);
  const JsonNode frames = json["frames"];
  for (std::size_t i = 0; i < frames.size(); ++i) {
    Pose pose = read_pose(frames[i]);
    pose.fov_of_longer_side = false;
    if (frames[i].has("up")) pose.up = triple(frames[i]["up"]);
    views.add(frames[i], pose, fmt::format("frame_{}", i));
  }
  return views.take(json);
}

}  // namespace pipegs
