// SPDX-License-Identifier: Apache-2.0
// Against scenes/colmap: what COLMAP leaves in a folder is read, both kinds of files alike, or refused in one line.
//
// Idea    A model of two photographs is written here; each bad one differs from it in one place. Binary files are cut
//         at every byte; random bytes are the work of verif/fuzz.
#include "scenes/colmap/colmap.hpp"

#include <limits>

#include "verif/scenes/colmap_file.hpp"
#include "verif/scenes/refused.hpp"

namespace pipegs {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

void expect_folder_refused(const ColmapModel& model, const std::vector<std::string>& words) {
  for (const bool as_text : {false, true}) {
    SCOPED_TRACE(as_text ? "text" : "binary");
    const ScratchFolder scratch;
    model.write(scratch / "", as_text);
    expect_one_line([&] { read_colmap(scratch / ""); }, words);
  }
}

void expect_the_model(const ColmapFolder& folder) {
  ASSERT_EQ(folder.cameras.size(), 2u);
  const Camera &a = folder.cameras[0], &b = folder.cameras[1];
  EXPECT_EQ(a.name, "a.png");  // by name, not as in the file
  EXPECT_EQ(b.name, "b.png");
  EXPECT_EQ(a.width, 40);
  EXPECT_EQ(a.height, 30);
  EXPECT_EQ(a.fx, 30);
  EXPECT_EQ(a.fy, 31);
  // The middle of 40 pixels is 20 where the first one begins at 0, and 19.5 where its centre is 0.
  EXPECT_EQ(a.cx, 19.5);
  EXPECT_EQ(a.cy, 14.5);
  EXPECT_LT(glm::length(a.position - glm::dvec3(0, 0, -3)), 1e-15);
  EXPECT_LT(glm::length(b.position - glm::dvec3(-2, 0, 0)), 1e-15);
  EXPECT_LT(glm::length(b.world_to_camera * glm::dvec3(1, 0, 0) - glm::dvec3(0, 0, 1)), 1e-15);
  ASSERT_EQ(folder.points.size(), 4u);
  EXPECT_EQ(folder.points[1].position, glm::dvec3(1, 0, 0));
  EXPECT_EQ(folder.points[0].color, glm::u8vec3(255, 0, 51));
}

TEST(Colmap, BothKindsOfFilesSayTheSame) {
  for (const bool as_text : {false, true}) {
    const ScratchFolder scratch;
    ColmapModel().write(scratch / "", as_text);
    expect_the_model(read_colmap(scratch / ""));
    // As the undistorter leaves it: without the folder 0.
    std::filesystem::rename(scratch / "sparse", scratch / "was");
    std::filesystem::rename(scratch / "was/0", scratch / "sparse");
    expect_the_model(read_colmap(scratch / ""));
  }
}

TEST(Colmap, OneFocalLengthIsEnough) {
  ColmapModel model;
  model.model = 0, model.parameters = {50, 20, 15};
  const auto lenses = parse_colmap_lenses("cameras.bin", model.cameras_bin());
  EXPECT_EQ(lenses.at(0).fx, 50);
  EXPECT_EQ(lenses.at(0).fy, 50);
  EXPECT_EQ(lenses.at(0).cx, 20);
}

TEST(Colmap, ALensThatBendsRaysIsToBeTakenOut) {
  ColmapModel model;
  model.model = 4, model.parameters = {30, 31, 20, 15, 0.1, 0, 0, 0};
  expect_one_line([&] { parse_colmap_lenses("cameras.bin", model.cameras_bin()); },
                  {"cameras.bin: camera 0, model: found 'OPENCV'", "colmap image_undistorter"});
  expect_one_line([] { parse_colmap_lenses("cameras.txt", "1 SIMPLE_RADIAL 40 30 30 20 15 0.1\n"); },
                  {"line 1, model", "SIMPLE_RADIAL", "colmap image_undistorter"});
  model.model = 99;
  expect_one_line([&] { parse_colmap_lenses("cameras.bin", model.cameras_bin()); }, {"model 99", "expected PINHOLE"});
}

TEST(Colmap, EachBadFieldIsNamed) {
  ColmapModel good, bad = good;
  bad.lenses[0].width = 0, expect_folder_refused(bad, {"width", "found 0", "from 1 to 16384"});
  bad = good, bad.parameters[0] = 0, expect_folder_refused(bad, {"focal length", "above 0"});
  bad = good, bad.poses[1].lens = 8, expect_folder_refused(bad, {"image 1, camera id", "found 8"});
  bad = good, bad.poses[1].name = "b.png", expect_folder_refused(bad, {"image 1, name", "second 'b.png'"});
  bad = good, bad.poses[0].rotation = {0, 0, 0, 0}, expect_folder_refused(bad, {"image 0, rotation", "length 0"});
  bad = good, bad.poses.pop_back(), expect_folder_refused(bad, {"found 1 photographs", "at least two"});
  bad = good, bad.poses.clear(), expect_folder_refused(bad, {"found 0 photographs", "at least two"});
  bad = good, bad.points.pop_back(), expect_folder_refused(bad, {"found 3 points", "at least 4"});
  bad = good, bad.lenses.push_back(bad.lenses[0]), expect_folder_refused(bad, {"camera id 7 twice"});
  bad = good;
  for (ScenePoint& point : bad.points) point.position = {-5, 0, -9};
  expect_folder_refused(bad, {"points3D", "behind all cameras"});
}

TEST(Colmap, NoNumberIsNoNumber) {
  ColmapModel good, bad = good;
  const auto refused = [](const ColmapModel& model, const std::vector<std::string>& words) {
    const ScratchFolder scratch;
    model.write(scratch / "");
    expect_one_line([&] { read_colmap(scratch / ""); }, words);
  };
  bad.parameters[2] = kNaN, refused(bad, {"camera 0, cx"});
  bad = good, bad.poses[0].translation.y = kNaN, refused(bad, {"image 0, translation"});
  bad = good, bad.poses[0].rotation.w = kNaN, refused(bad, {"image 0, rotation"});
  bad = good, bad.points[2].position.x = kNaN, refused(bad, {"point 2, position"});
  bad = good, bad.points[2].position.x = 1e300, refused(bad, {"point 2, position", "1e+300"});
  expect_one_line([] { parse_colmap_points("points3D.txt", "1 0 0 nan 1 2 3 0\n"); }, {"line 1, position", "nan"});
  expect_one_line([] { parse_colmap_points("points3D.txt", "# c\n1 0 0 0 1 2 256 0\n"); }, {"line 2, colour", "256"});
  expect_one_line([] { parse_colmap_points("points3D.txt", "1 0 0 0 1 2"); }, {"line 1, colour", "end of the line"});
}

TEST(Colmap, WhatIsMissingIsNamed) {
  const auto refused_without = [](const std::string& name, const std::vector<std::string>& words) {
    const ScratchFolder scratch;
    ColmapModel().write(scratch / "");
    std::filesystem::remove_all(scratch / name);
    expect_one_line([&] { read_colmap(scratch / ""); }, words);
  };
  refused_without("sparse", {"sparse/0"});
  refused_without("sparse/0/cameras.bin", {"without cameras.bin and cameras.txt"});
  refused_without("sparse/0/points3D.bin", {"without points3D.bin and points3D.txt"});
  refused_without("images", {"no folder images"});
  refused_without("images/a.png", {"images.bin", "'a.png'", "no photograph of this name"});
  expect_one_line([] { read_colmap("/nowhere"); }, {"/nowhere", "sparse/0"});
}

TEST(Colmap, APhotographLiesInItsFolder) {
  for (const char* name : {"../a.png", "/etc/passwd", "", "x/../../a.png"}) {
    ColmapModel model;
    model.poses[0].name = name;
    expect_one_line([&] { colmap_cameras("images.bin", {{7, 1, 1, 1, 1, 0, 0}}, model.poses); }, {"image 0, name"});
  }
}

TEST(Colmap, ACountIsHeldAgainstTheFile) {
  const ColmapModel model;
  const std::uint64_t huge = std::numeric_limits<std::uint64_t>::max() / 8;
  const auto promising = [&](std::string bytes) { return bytes.replace(0, 8, bytes_of(huge)); };
  expect_one_line([&] { parse_colmap_lenses("cameras.bin", promising(model.cameras_bin())); }, {"a count of"});
  expect_one_line([&] { parse_colmap_poses("images.bin", promising(model.images_bin())); }, {"a count of"});
  expect_one_line([&] { parse_colmap_points("points3D.bin", promising(model.points_bin())); }, {"a count of"});
  // The length of a track, in the middle of the file.
  std::string track = model.points_bin();
  track.replace(8 + 8 + 24 + 3 + 8, 8, bytes_of(huge));
  expect_one_line([&] { parse_colmap_points("points3D.bin", track); }, {"point 0, length of track", "a count of"});
}

TEST(Colmap, AFileEndsWhereItsRecordsDo) {
  const ColmapModel model;
  const auto each = [](const std::string& bytes, const auto& parse) {
    parse(bytes);
    for (std::size_t n = 0; n < bytes.size(); ++n) EXPECT_THROW(parse(bytes.substr(0, n)), InputError) << n;
    parse(bytes + "x");  // with a note, if somebody reads it
  };
  each(model.cameras_bin(), [](const std::string& bytes) { parse_colmap_lenses("cameras.bin", bytes); });
  each(model.images_bin(), [](const std::string& bytes) { parse_colmap_poses("images.bin", bytes); });
  each(model.points_bin(), [](const std::string& bytes) { parse_colmap_points("points3D.bin", bytes); });
  const ScratchFolder scratch;
  model.write(scratch / "");
  for (const char* name : {"cameras", "images", "points3D"})
    std::ofstream(scratch / (std::string("sparse/0/") + name + ".bin"), std::ios::app) << "xy";
  Findings findings;
  expect_the_model(read_colmap(scratch / "", false, findings));
  ASSERT_EQ(findings.size(), 3u);
  for (const Finding& finding : findings) EXPECT_EQ(finding.kind->key, "behind_end");
  EXPECT_NE(findings[2].what.find("2 bytes behind the last point of points3D.bin"), std::string::npos);
}

// As old Macs end them; also the list of what is held out.
TEST(Colmap, LinesMayEndInCarriageReturns) {
  const ColmapModel model;
  const ScratchFolder scratch;
  model.write(scratch / "", true);
  for (const auto& [name, text] : {std::pair{"cameras.txt", model.cameras_txt()},
                                   {"images.txt", model.images_txt()},
                                   {"points3D.txt", model.points_txt()},
                                   {"test.txt", std::string("\xef\xbb\xbf"
                                                            "a.png\nc.png\n")}}) {
    std::string ended = text;
    std::replace(ended.begin(), ended.end(), '\n', '\r');
    scratch.write(std::string("sparse/0/") + name, ended);
  }
  const ColmapFolder folder = read_colmap(scratch / "");
  expect_the_model(folder);
  EXPECT_EQ(folder.held_out, std::vector<std::string>{"a.png"});
}

}  // namespace
}  // namespace pipegs
