// SPDX-License-Identifier: Apache-2.0
// Against scenes/cameras: one camera in all its forms is one camera, and gives one picture to the bit.
//
// Idea    Three views that do not roll are written in every format (camera_file.hpp) and read again: they must agree to
//         the last bits that a format's formula keeps, and the golden model, whose rounding of a camera is coarser,
//         must draw the same picture of each. Where ../shared is, files of the tools' own forms are read as well.
#include <gtest/gtest.h>

#include "cpp_model/frame_setup.hpp"
#include "cpp_model/golden.hpp"
#include "cpp_model/pack/pack.hpp"
#include "scenes/input_error.hpp"
#include "verif/frame/scenes.hpp"
#include "verif/scenes/camera/camera_file.hpp"
#include "verif/scenes/scratch_folder.hpp"
#include "verif/support/shared.hpp"

namespace pipegs {
namespace {

namespace fs = std::filesystem;
using camera_file::Json;

std::vector<Camera> three_views() {
  std::vector<Camera> cameras = {look_at("a.png", 0, 96, 64, {0.5, -0.3, -2}, {0, 0, 3}, 50),
                                 look_at("b.png", 1, 96, 64, {-1, -1, 0.25}, {0.2, 0.1, 4}, 50),
                                 look_at("c.png", 2, 96, 64, {2, 0.4, 1}, {0, 0, 5}, 50)};
  return cameras;
}

void expect_same(const std::vector<Camera>& found, const std::vector<Camera>& wanted, double turn, double focal) {
  ASSERT_GE(found.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    SCOPED_TRACE(i);
    const Camera &a = found[i], &b = wanted[i];
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    EXPECT_NEAR(a.fx, b.fx, focal * b.fx);
    EXPECT_NEAR(a.fy, b.fy, focal * b.fy);
    EXPECT_EQ(a.cx, b.cx);
    EXPECT_EQ(a.cy, b.cy);
    EXPECT_LE(glm::length(a.position - b.position), turn * (1 + glm::length(b.position)));
    for (int c = 0; c < 3; ++c) EXPECT_LE(glm::length(a.world_to_camera[c] - b.world_to_camera[c]), turn);
  }
}

std::vector<double> picture_of(const Scene& scene, const Camera& camera) {
  const Config config;
  const PackedScene packed = pack_scene(config, scene, 8);
  const GoldenInput input{.packed = &packed, .frame = frame_setup(config, packed, camera)};
  std::vector<double> values;
  for (const glm::dvec3& rgb : golden_frame(input, {}).image.rgb) values.insert(values.end(), {rgb.x, rgb.y, rgb.z});
  return values;
}

struct Form {
  const char* name;
  Json (*write)(const std::vector<Camera>&);
  double turn, focal;  // relative tolerances of rotation with place, and of the focal length
  bool sized;
};

// Matrices hold the numbers of the camera themselves; an angle, a target and a quaternion are computed with.
const Form kForms[] = {{"nerfstudio", camera_file::nerfstudio, 2e-15, 0, true},
                       {"per frame", camera_file::nerfstudio_per_frame, 2e-15, 0, true},
                       {"applied", camera_file::nerfstudio_applied, 2e-15, 0, true},
                       {"instant-ngp", camera_file::instant_ngp, 2e-15, 0, true},
                       {"Blender", camera_file::blender, 2e-15, 4e-15, false},
                       {"frames list", camera_file::playcanvas_frames, 4e-15, 4e-15, false},
                       {"viewer", camera_file::supersplat_viewer, 4e-15, 4e-15, false},
                       {"editor", camera_file::supersplat_editor, 4e-15, 4e-15, false}};

TEST(CameraForms, OneCameraIsTheSameInEachAndGivesOnePicture) {
  const ScratchFolder scratch;
  const std::vector<Camera> wanted = three_views();
  const Scene scene = random_scene(5, 400, 1);
  std::vector<std::vector<double>> pictures;
  for (const Camera& camera : wanted) pictures.push_back(picture_of(scene, camera));
  EXPECT_NE(pictures[0], pictures[1]);
  const auto expect = [&](const std::vector<Camera>& found, double turn, double focal) {
    expect_same(found, wanted, turn, focal);
    for (std::size_t i = 0; i < wanted.size(); ++i)
      EXPECT_TRUE(picture_of(scene, found.at(i)) == pictures[i]) << "another picture of view " << i;
  };
  write_cameras(scratch / "cameras.json", wanted);
  expect(read_cameras(scratch / "cameras.json"), 2e-15, 0);
  for (const Form& form : kForms) {
    SCOPED_TRACE(form.name);
    const CameraReading reading = form.sized ? CameraReading{} : CameraReading{.width = 96, .height = 64};
    expect(read_cameras(scratch.write("form.json", form.write(wanted).dump()), reading), form.turn, form.focal);
  }
  for (const bool as_text : {false, true}) {
    SCOPED_TRACE(as_text ? "COLMAP, text" : "COLMAP, binary");
    const ScratchFolder folder;
    camera_file::colmap(wanted).write(folder / "", as_text);
    expect(read_cameras(folder / ""), 4e-15, 0);
    expect(read_cameras(folder / "sparse/0"), 4e-15, 0);
    expect(read_cameras(folder / (as_text ? "sparse/0/images.txt" : "sparse/0/cameras.bin")), 4e-15, 0);
  }
}

TEST(CameraForms, ThePrincipalPointOffTheCentreIsKept) {
  std::vector<Camera> wanted = three_views();
  for (Camera& camera : wanted) camera.cx += 7.5, camera.cy -= 4.25;
  const ScratchFolder scratch;
  for (const auto& write : {camera_file::nerfstudio, camera_file::nerfstudio_per_frame, camera_file::instant_ngp})
    expect_same(read_cameras(scratch.write("form.json", write(wanted).dump())), wanted, 2e-15, 0);
  camera_file::colmap(wanted).write(scratch / "");
  expect_same(read_cameras(scratch / ""), wanted, 4e-15, 0);
}

TEST(CameraForms, WorkedByHand) {
  // OpenGL's unit matrix looks along -z with y up: our x is its x, our y and z point the other way.
  const auto one = parse_cameras("t.json", R"({"w": 10, "h": 6, "fl_x": 5, "cx": 4, "frames": [{"transform_matrix":
    [[1,0,0,1],[0,1,0,2],[0,0,1,3],[0,0,0,1]]}]})")[0];
  EXPECT_EQ(one.position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(one.world_to_camera * glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0));
  EXPECT_EQ(one.world_to_camera * glm::dvec3(0, 0, -1), glm::dvec3(0, 0, 1));
  EXPECT_EQ(one.cx, 3.5);
  EXPECT_EQ(one.cy, 2.5);
  EXPECT_EQ(one.fy, 5);
  // 90 degrees of a width of 10: 5 pixels; x and y of PlayCanvas' world are the negative of ours.
  const CameraReading reading{.width = 10, .height = 4};
  const auto two = parse_cameras("s.json", R"({"cameras": [{"initial": {"position": [1, 2, -3], "target": [1, 2, 0],
    "fov": 90}}]})",
                                 reading)[0];
  EXPECT_EQ(two.position, glm::dvec3(-1, -2, -3));
  EXPECT_NEAR(two.fx, 5, 1e-14);
  EXPECT_EQ(two.world_to_camera, glm::dmat3(1));
  const auto three =
      parse_cameras("f.json", R"({"frames": [{"position": [0, 0, 0], "target": [0, 0, 1], "fov": 90}]})", reading)[0];
  EXPECT_NEAR(three.fx, 2, 1e-14) << "of the height";
}

TEST(CameraForms, ASizeIsAsked) {
  const std::string text = camera_file::blender(three_views()).dump();
  try {
    parse_cameras("t.json", text);
    FAIL() << "was accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "t.json: frames[0]: the file has no size, expected --size WxH");
  }
  // Or that of the picture beside the file, as wide and high as its header says.
  const ScratchFolder scratch;
  const std::string head("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x60\0\0\0\x40", 24);
  for (const char* name : {"a.png", "b.png", "c.png"}) scratch.write(name, head);
  expect_same(read_cameras(scratch.write("t.json", text)), three_views(), 2e-15, 4e-15);
  scratch.write("a.png", head.substr(0, 23));
  EXPECT_THROW(read_cameras(scratch / "t.json"), InputError);
  const std::string without_ending = text.substr(0, text.find("a.png") + 1) + text.substr(text.find("a.png") + 5);
  const std::filesystem::path path = scratch.write("u.json", without_ending);
  std::filesystem::remove(scratch / "a.png");
  const std::string jpeg("\xff\xd8\xff\xe1\0\6\xff\xc0xy\xff\xff\xc2\0\x11\10\0\x40\0\x60", 20);
  scratch.write("a.jpg", jpeg);
  EXPECT_EQ(read_cameras(path)[0].width, 96);
  EXPECT_EQ(read_cameras(path)[0].height, 64);
  for (std::size_t length = 0; length < jpeg.size(); ++length) {
    scratch.write("a.jpg", jpeg.substr(0, length));
    EXPECT_THROW(read_cameras(path), InputError) << length;
  }
  // A file with a size is made as large as was asked, as wide an angle as before.
  const Camera half =
      parse_cameras("n.json", camera_file::nerfstudio(three_views()).dump(), {.width = 48, .height = 32})[0];
  EXPECT_NEAR(half.fx, three_views()[0].fx / 2, 1e-12);
  EXPECT_EQ(half.cx, 23.5);
}

TEST(CameraForms, DistortionIsRefusedUnlessIgnored) {
  Json json = camera_file::nerfstudio(three_views());
  json["k2"] = -0.02;
  EXPECT_THROW(parse_cameras("t.json", json.dump()), InputError);
  expect_same(parse_cameras("t.json", json.dump(), {.ignore_distortion = true}), three_views(), 2e-15, 0);
  json["camera_model"] = "OPENCV_FISHEYE";
  EXPECT_THROW(parse_cameras("t.json", json.dump(), {.ignore_distortion = true}), InputError);
  struct Lens {
    int model;
    std::vector<double> parameters;
  };
  for (const Lens& lens :
       {Lens{2, {30, 20, 15, 0.1}}, Lens{3, {30, 20, 15, 0.1, 0}}, Lens{4, {30, 30, 20, 15, 0.1, 0, 0, 0}},
        Lens{6, {30, 30, 20, 15, 0.1, 0, 0, 0, 0, 0, 0, 0}}}) {
    ColmapModel model;
    model.model = lens.model, model.parameters = lens.parameters;
    EXPECT_THROW(parse_colmap_lenses("cameras.bin", model.cameras_bin()), InputError);
    const ColmapLens read = parse_colmap_lenses("cameras.bin", model.cameras_bin(), true).at(0);
    EXPECT_EQ(read.fx, 30);
    EXPECT_EQ(read.fy, 30);
    EXPECT_EQ(read.cx, 20);
    EXPECT_EQ(read.cy, 15);
  }
  ColmapModel fisheye;
  fisheye.model = 5, fisheye.parameters = {30, 30, 20, 15, 0, 0, 0, 0};
  EXPECT_THROW(parse_colmap_lenses("cameras.bin", fisheye.cameras_bin(), true), InputError);
}

// The files of three real views that tools wrote: all forms are those of cameras.json.
TEST(CameraForms, SharedFiles) {
  const fs::path folder = shared_folder() / "formats" / "cameras";
  if (!fs::exists(folder)) GTEST_SKIP() << "no " << folder;
  const std::vector<Camera> wanted = read_cameras(folder / "inria.cameras.json");
  const CameraReading sized{.width = wanted[0].width, .height = wanted[0].height};
  std::vector<Camera> off = wanted, square = wanted;
  for (Camera& camera : off) camera.cx += 7.5, camera.cy -= 4.25;
  for (Camera& camera : square) camera.fy = camera.fx;
  expect_same(read_cameras(folder / "nerfstudio_per_frame.transforms.json"), wanted, 2e-15, 0);
  expect_same(read_cameras(folder / "nerfstudio_applied.transforms.json"), wanted, 2e-15, 0);
  expect_same(read_cameras(folder / "instant_ngp.transforms.json"), wanted, 2e-15, 0);
  expect_same(read_cameras(folder / "nerfstudio.transforms.json", {.ignore_distortion = true}), off, 2e-15, 0);
  expect_same(read_cameras(folder / "blender.transforms_train.json", sized), square, 2e-15, 1e-14);
  for (const char* kind : {"bin", "txt"}) {  // COLMAP's text has 12 digits of the focal lengths
    SCOPED_TRACE(kind);
    expect_same(read_cameras(folder / "colmap_pinhole" / kind), wanted, 4e-15, 1e-11);
    expect_same(read_cameras(folder / "colmap_simple_pinhole" / kind), square, 4e-15, 1e-11);
    expect_same(read_cameras(folder / "colmap_off_centre" / kind), off, 4e-15, 1e-11);
    expect_same(read_cameras(folder / "colmap_opencv" / kind, {.ignore_distortion = true}), off, 4e-15, 1e-11);
    EXPECT_THROW(read_cameras(folder / "colmap_opencv" / kind), InputError);
  }
  EXPECT_THROW(read_cameras(folder / "nerfstudio.transforms.json"), InputError);
  std::vector<Camera> tall = wanted;
  for (Camera& camera : tall) camera.fx = camera.fy;
  expect_same(read_cameras(folder / "playcanvas_frames.json", sized), tall, 4e-15, 1e-14);
  // SuperSplat's have no roll, which these views have: the place and where they look are theirs.
  for (const char* name : {"supersplat_viewer.settings.json", "supersplat_editor.document.json"}) {
    const std::vector<Camera> found = read_cameras(folder / name, sized);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_LE(glm::length(found.at(i).position - wanted[i].position), 1e-15);
      const glm::dvec3 ahead(0, 0, 1);
      EXPECT_LE(glm::length(ahead * found[i].world_to_camera - ahead * wanted[i].world_to_camera), 4e-15);
      EXPECT_NEAR(found[i].fx, 750 / std::tan(glm::radians(20.564811145478853) / 2), 1e-9) << "of the longer side";
    }
  }
}

}  // namespace
}  // namespace pipegs
