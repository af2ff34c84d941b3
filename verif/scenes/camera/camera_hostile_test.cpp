// SPDX-License-Identifier: Apache-2.0
// Against scenes/cameras: hostile files of every format are read whole or refused in one line.
//
// Idea    Good files of camera_file.hpp are cut at every byte and changed in one place, where the message must name the
//         frame and the field. Random bytes are the work of verif/fuzz.
#include <random>

#include "scenes/cameras/framing.hpp"
#include "verif/frame/scenes.hpp"
#include "verif/scenes/camera/camera_file.hpp"
#include "verif/scenes/refused.hpp"
#include "verif/support/draws.hpp"

namespace pipegs {
namespace {

using camera_file::Json;

const CameraReading kSized{.width = 64, .height = 48};

std::vector<Camera> two_views() {
  return {look_at("a.png", 0, 64, 48, {0, 0, -2}, {0, 0, 0}, 60),
          look_at("b.png", 1, 64, 48, {1, -1, -2}, {0, 0, 0}, 60)};
}

void expect_refused(const std::string& text, const std::vector<std::string>& words) {
  expect_one_line([&] { parse_cameras("c.json", text, kSized); }, words, text);
}

// `json` with the value at a JSON pointer replaced, or taken out.
std::string with(Json json, const std::string& pointer, const Json& value) {
  json[Json::json_pointer(pointer)] = value;
  return json.dump();
}
std::string without(Json json, const std::string& inside, const std::string& field) {
  json[Json::json_pointer(inside)].erase(field);
  return json.dump();
}

TEST(CameraHostile, TransformsNameFrameAndField) {
  const Json good = camera_file::nerfstudio(two_views());
  const std::string matrix = "/frames/1/transform_matrix";
  expect_refused(with(good, "/frames", Json::array()), {"frames", "at least one"});
  expect_refused(with(good, "/frames", 3), {"frames: found '3'"});
  expect_refused(with(good, "/frames/0", "a"), {"frames[0]", "transform_matrix or position"});
  expect_refused(with(good, "/frames/1", 7), {"frames[1]", "an object"});
  expect_refused(without(good, "/frames/1", "transform_matrix"), {"frames[1]: 'transform_matrix' is missing"});
  expect_refused(with(good, matrix, 1), {"frames[1].transform_matrix: found '1', expected an array"});
  expect_refused(with(good, matrix + "/2", {1, 2, 3}), {"frames[1].transform_matrix[2]: found 3 numbers, expected 4"});
  expect_refused(with(good, matrix + "/2/1", nullptr), {"frames[1].transform_matrix[2][1]", "null"});
  expect_refused(with(good, matrix + "/3", {0, 0, 0, 2}), {"frames[1].transform_matrix[3]", "expected 0, 0, 0, 1"});
  Json changed = good;
  for (int r = 0; r < 3; ++r) changed["frames"][1]["transform_matrix"][r] = {0, 0, 0, 0};
  expect_refused(changed.dump(), {"frames[1].transform_matrix", "orthonormal"});
  changed = good;
  for (int r = 0; r < 3; ++r) changed["frames"][1]["transform_matrix"][r][r] = 1e308;
  expect_refused(changed.dump(), {"frames[1].transform_matrix", "orthonormal"});
  changed = good;
  for (int r = 0; r < 3; ++r) {
    Json& first = changed["frames"][1]["transform_matrix"][r][0];
    first = -first.get<double>();
  }
  expect_refused(changed.dump(), {"frames[1].transform_matrix", "mirrored"});
  expect_refused(with(good, "/w", 0), {" w: found '0'", "from 1 to 16384"});
  expect_refused(with(good, "/fl_x", 0), {" fl_x: ", "above 0"});
  expect_refused(with(good, "/fl_y", "long"), {" fl_y: ", "long"});
  expect_refused(with(good, "/k1", 0.1), {" k1: ", "colmap image_undistorter", "--ignore-distortion"});
  expect_refused(with(good, "/camera_model", "EQUIRECTANGULAR"), {"camera_model", "EQUIRECTANGULAR"});
  expect_refused(with(good, "/camera_model", 3), {"camera_model", "expected a text"});
  expect_refused(with(good, "/is_fisheye", true), {"is_fisheye"});
  expect_refused(with(good, "/applied_scale", 0), {"applied_scale"});
  expect_refused(with(good, "/applied_transform", {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}}), {"applied_transform"});
  expect_refused(with(good, "/applied_transform", {{1, 0, 0}, {0, 1, 0}}), {"applied_transform", "3 or 4 rows"});
  expect_refused(with(camera_file::blender(two_views()), "/camera_angle_x", 3.15), {"camera_angle_x"});
  expect_refused(without(camera_file::blender(two_views()), "", "camera_angle_x"), {"frames[0]: 'fl_x' is missing"});
}

TEST(CameraHostile, PlayCanvasNamesFrameAndField) {
  const Json frames = camera_file::playcanvas_frames(two_views()), viewer = camera_file::supersplat_viewer(two_views()),
             editor = camera_file::supersplat_editor(two_views());
  const std::string values = "/animTracks/0/keyframes/values";
  expect_refused(with(frames, "/frames/1/fov", 0), {"frames[1].fov", "above 0"});
  expect_refused(with(frames, "/frames/1/fov", 180), {"frames[1].fov"});
  expect_refused(with(frames, "/frames/1/target", frames["frames"][1]["position"]), {"frames[1]", "target"});
  expect_refused(with(frames, "/frames/1/up", {0, 0, 0}), {"frames[1]", "no direction in up"});
  expect_refused(with(frames, "/frames/0/up", {0, 0, 1}), {"frames[0]", "in which the camera looks"});
  expect_refused(with(frames, "/frames/0/position", {1e308, 1e308, 1e308}), {"frames[0]"});
  expect_refused(with(frames, "/frames/0/position", {1, 2}), {"frames[0].position: found 2 numbers, expected 3"});
  expect_refused(with(viewer, values + "/fov", {50}),
                 {"animTracks[0].keyframes.values.fov: found 1 numbers, expected 2"});
  expect_refused(with(viewer, values + "/target/4", "x"), {"values.target[4]", "'\"x\"'"});
  expect_refused(with(viewer, values, 3), {"animTracks[0].keyframes.values", "an object"});
  expect_refused(with(viewer, "/animTracks", 3), {"animTracks", "expected an array"});
  expect_refused(with(viewer, "/cameras/0", 3), {"cameras[0]", "an object"});
  expect_refused(with(viewer, "/cameras/0/initial/fov", nullptr), {"cameras[0].initial.fov"});
  expect_refused(R"({"cameras": []})", {"no camera"});
  expect_refused(with(editor, "/poseSets/0/poses/1/position", nullptr), {"poseSets[0].poses[1].position"});
  expect_refused(with(editor, "/poseSets", Json::object()), {"poseSets", "expected an array"});
  expect_refused(with(editor, "/poseSets", Json::array()), {"no camera"});
  expect_refused(R"({"poseSets": [], "camera": 1})", {"camera", "an object"});
  expect_refused(R"({"animals": []})", {"none of the known formats"});
  expect_refused("7", {"none of the known formats"});
}

TEST(CameraHostile, AFileThatIsCutIsRefused) {
  for (const auto& write : {camera_file::nerfstudio, camera_file::playcanvas_frames, camera_file::supersplat_viewer,
                            camera_file::supersplat_editor}) {
    const std::string text = write(two_views()).dump();
    EXPECT_NO_THROW(parse_cameras("c.json", text, kSized));
    for (std::size_t n = 0; n < text.size(); ++n)
      EXPECT_THROW(parse_cameras("c.json", text.substr(0, n), kSized), InputError) << n;
  }
}

TEST(CameraHostile, ThousandsOfFramesAreRead) {
  const std::vector<Camera> many(5000, two_views()[0]);
  EXPECT_EQ(parse_cameras("c.json", camera_file::nerfstudio(many).dump()).size(), 5000u);
  EXPECT_EQ(parse_cameras("c.json", camera_file::supersplat_viewer(many).dump(), kSized).size(), 5001u);
}

// A folder without COLMAP's files, one without photographs, one with half of a pair.
TEST(CameraHostile, ColmapFoldersAreWholeOrRefused) {
  const ScratchFolder scratch;
  EXPECT_THROW(read_cameras(scratch / ""), InputError);
  camera_file::colmap(two_views()).write(scratch / "");
  EXPECT_EQ(read_cameras(scratch / "").size(), 2u);
  std::filesystem::remove(scratch / "sparse/0/images.bin");
  EXPECT_THROW(read_cameras(scratch / ""), InputError);
  EXPECT_THROW(read_cameras(scratch / "sparse/0/cameras.bin"), InputError);
  ColmapModel none = camera_file::colmap(two_views());
  none.poses.clear();
  none.write(scratch / "");
  EXPECT_THROW(read_cameras(scratch / ""), InputError);
  // 91 photographs: a binary file that begins with a bracket, as JSON does.
  ColmapModel many = camera_file::colmap(two_views());
  for (int i = 2; i < '['; ++i) {
    many.poses.push_back(many.poses[0]);
    many.poses.back().name = std::to_string(i);
  }
  many.write(scratch / "");
  EXPECT_EQ(read_cameras(scratch / "sparse/0/images.bin").size(), 91u);
}

// Framing: what is there fills the picture, whatever is far off; nothing to see is said.
TEST(CameraHostile, AFramingShowsTheScene) {
  Scene scene = scene_of({});
  std::mt19937_64 random(3);
  const auto within = [&] { return static_cast<float>(draw_uniform(random, -1, 1)); };
  for (int i = 0; i < 2000; ++i)
    scene.gaussians.push_back(gaussian_at({5 + within(), 3 * within(), -7 + within()}, 0.02f));
  const auto expect_shown = [&](const Camera& camera) {
    double highest = 0;
    for (int i = 0; i < 2000; ++i) {
      const glm::dvec3 p = camera.world_to_camera * (glm::dvec3(scene.gaussians[i].mean) - camera.position);
      EXPECT_GT(p.z, 0);
      highest = std::max(highest, std::abs(camera.fy * p.y / p.z) / (camera.height / 2.0));
    }
    EXPECT_GT(highest, 0.85);
    EXPECT_LT(highest, 1.05);
    EXPECT_LT((camera.world_to_camera * glm::dvec3(0, -1, 0)).y, 0) << "up is not up";
  };
  expect_shown(framed_cameras(scene, {}).at(0));
  for (int i = 0; i < 20; ++i) scene.gaussians.push_back(gaussian_at({1e4f * within(), 9e3f, 1e4f}, 300));
  scene.gaussians.push_back(gaussian_at({std::nanf(""), 0, 0}));
  expect_shown(framed_cameras(scene, {}).at(0));
  const std::vector<Camera> orbit = framed_cameras(scene, {.views = 4});
  ASSERT_EQ(orbit.size(), 4u);
  EXPECT_LT(glm::length((orbit[0].position + orbit[2].position) - (orbit[1].position + orbit[3].position)), 1e-9);
  const Camera given = framed_cameras(scene, {.from = glm::dvec3(0, 0, -3), .look_at = glm::dvec3(0, 0, 2)})[0];
  EXPECT_EQ(given.position, glm::dvec3(0, 0, -3));
  EXPECT_LT(glm::length(given.world_to_camera[2] - glm::dvec3(0, 0, 1)), 1e-15);
  EXPECT_THROW(framed_cameras(scene, {.from = glm::dvec3(0, 0, 0), .look_at = glm::dvec3(0, 3, 0)}), InputError);
  EXPECT_THROW(framed_cameras(scene, {.from = glm::dvec3(1), .look_at = glm::dvec3(1)}), InputError);
  EXPECT_THROW(framed_cameras(scene_of({}), {}), InputError);
  EXPECT_THROW(framed_cameras(scene_of({gaussian_at({0, 0, 0}, 1, 1e-4)}), {}), InputError);
  EXPECT_NO_THROW(framed_cameras(scene_of({gaussian_at({1, 2, 3})}), {}));
}

}  // namespace
}  // namespace pipegs
