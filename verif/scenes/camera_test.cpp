// SPDX-License-Identifier: Apache-2.0
// Against scenes/camera: INRIA's cameras.json is read as field by field defined, or refused in one line.
//
// Idea    A good file is written by hand here; each bad one differs from it in one place and its
//         message must name the camera and the field.
#include "scenes/camera.hpp"

#include <tuple>

#include "verif/scenes/refused.hpp"

namespace pipegs {
namespace {

const std::string kGood = R"([{"id": 4, "img_name": "a.jpg", "width": 1000, "height": 501, "position": [1, 2, 3],
  "rotation": [[0, 0, 1], [1, 0, 0], [0, 1, 0]], "fx": 800.5, "fy": 801},
 {"id": 5, "img_name": "b.jpg", "width": 1, "height": 16384, "position": [0, 0, 0],
  "rotation": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "fx": 1, "fy": 1}])";

void expect_refused(const std::string& content, const std::vector<std::string>& words) {
  const ScratchFolder scratch;
  expect_one_line([&] { read_cameras(scratch.write("cameras.json", content)); }, words, content);
}

TEST(Camera, ReadsRowsOfCameraToWorld) {
  const ScratchFolder scratch;
  const auto cameras = read_cameras(scratch.write("cameras.json", kGood));
  ASSERT_EQ(cameras.size(), 2u);
  const Camera& c = cameras[0];
  EXPECT_EQ(c.id, 4);
  EXPECT_EQ(c.name, "a.jpg");
  EXPECT_EQ(c.cx, 499.5);
  EXPECT_EQ(c.cy, 250.0);
  EXPECT_EQ(c.fx, 800.5);
  // The third column of camera-to-world is where the camera looks: (1, 0, 0).
  EXPECT_EQ(c.world_to_camera * glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1));
  EXPECT_EQ(c.world_to_camera * glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0));
}

TEST(Camera, WriterRoundTrip) {
  const ScratchFolder scratch;
  const std::vector<Camera> out = {look_at("one", 0, 640, 480, {1, -2, 3}, {0.1, 0.2, 9}, 60),
                                   look_at("two", 7, 31, 17, {0, 0, 0}, {-1, 1, -1}, 90)};
  write_cameras(scratch / "c.json", out);
  const auto in = read_cameras(scratch / "c.json");
  ASSERT_EQ(in.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(in[i].name, out[i].name);
    EXPECT_EQ(in[i].position, out[i].position);
    EXPECT_EQ(in[i].fx, out[i].fx);
    for (int column = 0; column < 3; ++column)
      EXPECT_LT(glm::length(in[i].world_to_camera[column] - out[i].world_to_camera[column]), 1e-14);
  }
  EXPECT_EQ(scratch.files(), 1u);
}

// INRIA's file has no principal point; ours keeps one that is off the centre, to the last bit.
TEST(Camera, KeepsThePrincipalPoint) {
  const ScratchFolder scratch;
  Camera camera = look_at("off", 1, 64, 48, {0, 0, -2}, {0, 0, 0}, 60);
  camera.cx = 11.123456789012345, camera.cy = -3.7;
  write_cameras(scratch / "c.json", {camera, look_at("centred", 2, 64, 48, {0, 0, -2}, {0, 0, 0}, 60)});
  const auto cameras = read_cameras(scratch / "c.json");
  EXPECT_EQ(cameras.at(0).cx, camera.cx);
  EXPECT_EQ(cameras.at(0).cy, camera.cy);
  EXPECT_EQ(cameras.at(1).cx, 31.5);
  expect_refused(replaced(kGood, "\"fx\": 800.5", "\"cx\": \"left\", \"fx\": 800.5"), {"[0].cx"});
}

TEST(Camera, LookAtPutsTheTargetInTheMiddleAndUpUp) {
  const Camera c = look_at("", 0, 100, 100, {3, -2, -5}, {0, -1, 0}, 60);
  const glm::dvec3 target = c.world_to_camera * (glm::dvec3(0, -1, 0) - c.position);
  EXPECT_NEAR(target.x, 0, 1e-12);
  EXPECT_NEAR(target.y, 0, 1e-12);
  EXPECT_GT(target.z, 0);
  EXPECT_LT((c.world_to_camera * glm::dvec3(0, -1, 0)).y, 0);  // up is smaller y
  EXPECT_NEAR(glm::determinant(c.world_to_camera), 1, 1e-12);
}

TEST(Camera, MakesANearlyOrthonormalRotationOrthonormal) {
  const ScratchFolder scratch;
  const auto cameras = read_cameras(
      scratch.write("c.json", replaced(kGood, "[0, 0, 1], [1, 0, 0]", "[0.00003, 0, 0.99998], [1, 0.00002, 0]")));
  const glm::dmat3 m = cameras[0].world_to_camera, product = m * glm::transpose(m);
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) EXPECT_NEAR(product[a][b], a == b, 1e-15);
  }
}

TEST(Camera, RefusesEachBadFieldByName) {
  expect_refused(replaced(kGood, "\"width\": 1,", "\"width\": 0,"), {"[1].width", "from 1 to 16384"});
  expect_refused(replaced(kGood, "16384", "16385"), {"[1].height", "16385"});
  expect_refused(replaced(kGood, "501", "501.5"), {"[0].height"});
  expect_refused(replaced(kGood, "\"width\": 1000, ", ""), {"[0]: 'width' is missing"});
  expect_refused(replaced(kGood, "\"fx\": 800.5", "\"fx\": 0"), {"[0].fx"});
  expect_refused(replaced(kGood, "\"fy\": 801", "\"fy\": -3"), {"[0].fy"});
  expect_refused(replaced(kGood, "\"fy\": 801", "\"fy\": \"wide\""), {"[0].fy", "wide", "number"});
  expect_refused(replaced(kGood, "[1, 2, 3]", "[1, 2]"), {"[0].position"});
  expect_refused(replaced(kGood, "[1, 2, 3]", "[1, null, 3]"), {"[0].position"});
  expect_refused(replaced(kGood, "[0, 0, 1], [1, 0, 0]", "[0, 0, 1.001], [1, 0, 0]"), {"[0].rotation", "orthonormal"});
  expect_refused(replaced(kGood, "[0, 0, 1], [1, 0, 0]", "[0, 0, 1], [-1, 0, 0]"), {"[0].rotation", "determinant"});
  expect_refused(replaced(kGood, "[0, 0, 1], [1, 0, 0]", "[0, 0, 1], [1, 0]"), {"[0].rotation[1]"});
  expect_refused(replaced(kGood, "\"a.jpg\"", "17"), {"[0].img_name"});
}

TEST(Camera, RefusesWhatIsNoListOfCameras) {
  expect_refused("", {"an empty file", "expected a file of cameras"});
  expect_refused("{\"a\":", {"not JSON"});
  expect_refused("{}", {"none of the known formats"});
  expect_refused("[]", {"empty"});
  expect_refused("[3]", {"[0]", "an object"});
  expect_refused(replaced(kGood, "800.5", "1e999"), {"not JSON"});
}

TEST(Camera, NumbersAreWholeAndOfTheirRange) {
  for (const char* number :
       {"-1", "1000.5", "1e99", "4294968296", "18446744073709552616", "\"1000\"", "true", "null"}) {
    expect_refused(replaced(kGood, "\"width\": 1000", "\"width\": " + std::string(number)),
                   {"[0].width", "expected an integer from 1 to 16384"});
  }
  for (const char* number : {"0", "-0.0", "-1", "\"8\"", "[8]"})
    expect_refused(replaced(kGood, "800.5", number), {"[0].fx", "expected a number above 0"});
  for (const char* number : {"+1", "01", "1.", ".5", "0x1", "nan", "1 0", "--1"})
    expect_refused(replaced(kGood, "800.5", number), {"not JSON", "line 2"});
  for (const char* number : {"NaN", "Infinity", "-Infinity"})
    expect_refused(replaced(kGood, "800.5", number), {"[0].fx", number, "expected a number above 0"});
  const ScratchFolder scratch;
  EXPECT_EQ(read_cameras(scratch.write("c.json", replaced(kGood, "1000", "1000.0")))[0].width, 1000);
}

TEST(Camera, AFieldComesOnceAndNothingFollows) {
  expect_refused(replaced(kGood, "\"id\": 5", "\"id\": 5, \"fx\": 1"), {"[1]", "second 'fx'"});
  expect_refused(kGood + "]", {"not JSON", "line 4"});
  expect_refused(kGood + kGood, {"not JSON", "line 4"});
}

TEST(Camera, NestingIsBounded) {
  for (const char* open : {"[", "{\"a\":", "[{\"width\":"}) {
    std::string deep;
    for (int i = 0; i < 400000; ++i) deep += open;
    expect_refused(deep, {"more than 64 brackets"});
  }
  std::string deep(400000, '[');
  expect_refused(replaced(kGood, "800.5", deep + std::string(400000, ']')), {"[0].fx[0][0]", "more than 64 brackets"});
}

TEST(Camera, OnlyARegularFileOfSomeSizeIsRead) {
  const ScratchFolder scratch;
  expect_only_regular_files([](const std::filesystem::path& path) { read_cameras(path); });
  expect_one_line([&] { read_cameras(scratch / ""); }, {"found a folder without cameras.bin and cameras.txt"});
  scratch.write("large.json", "[]");
  std::filesystem::resize_file(scratch / "large.json", std::uintmax_t{1} << 40);  // sparse
  expect_one_line([&] { read_cameras(scratch / "large.json"); }, {"found 1099511627776 bytes"});
}

// Two ways to more pixels: as wide and as high as they make it, and the same rectangle. At equal sides they are one, to
// the bit.
TEST(Camera, OtherPixelsOfTheSameView) {
  Camera camera = look_at("view", 1, 123, 77, {0, 0, -2}, {0.3, 0.1, 0}, 60);
  camera.cx += 3.25, camera.cy -= 1.5;
  const Camera large = resized(camera, 246, 154), twice = scaled_camera(camera, 2);
  EXPECT_EQ(std::tie(large.width, large.height, large.fx, large.fy, large.cx, large.cy),
            std::tie(twice.width, twice.height, twice.fx, twice.fy, twice.cx, twice.cy));
  EXPECT_EQ(twice.cx, (camera.cx + 0.5) * 2 - 0.5);
  EXPECT_EQ(twice.cy, (camera.cy + 0.5) * 2 - 0.5);
  // What lies in the middle stays there when only the height changes.
  const Camera low = resized(camera, 123, 11);
  EXPECT_EQ(low.fy, camera.fy);
  EXPECT_EQ(low.cy - 5, camera.cy - 38);
  const Camera tiny = scaled_camera(camera, 0.001);
  EXPECT_EQ(tiny.width, 1);
  EXPECT_EQ(tiny.height, 1);
}

// What is no UTF-8 is refused in a file; a name that is none can still be written.
TEST(Camera, Latin1IsRefusedAndWritten) {
  expect_refused(replaced(kGood, "a.jpg", "caf\xe9.jpg"), {"not JSON", "UTF-8"});
  const ScratchFolder scratch;
  Camera camera = look_at("caf\xe9", 1, 64, 48, {0, 0, -2}, {0, 0, 0}, 60);
  write_cameras(scratch / "c.json", {camera});
  EXPECT_EQ(read_cameras(scratch / "c.json")[0].name, "caf\xef\xbf\xbd");
}

TEST(Camera, MessagesStayShort) {
  const std::string long_text(1 << 20, 'x');
  expect_refused("[{\"" + long_text, {"not JSON"});
  expect_refused("[{\"" + long_text + "\": 1, \"" + long_text + "\": 1}]", {"second 'xxx"});
  expect_refused(replaced(kGood, "[1, 2, 3]", "\"" + long_text + "\""), {"[0].position"});
}

}  // namespace
}  // namespace pipegs
