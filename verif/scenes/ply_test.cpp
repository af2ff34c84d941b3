// SPDX-License-Identifier: Apache-2.0
// Against scenes/ply/ply: every legal shape of file gives the same scene; what is written is read back.
//
// Idea    The matrix of formats x types x degrees x property orders is compared with the values the
//         file was built from (ply_file.hpp), never with a scene that went through write_ply.
#include "scenes/ply/ply.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "scenes/input_error.hpp"
#include "verif/scenes/ply_file.hpp"
#include "verif/scenes/scratch_folder.hpp"

namespace pipegs {
namespace {

void expect_holds(const Scene& scene, const std::vector<Column>& columns, int degree) {
  ASSERT_EQ(scene.gaussians.size(), columns[0].values.size());
  ASSERT_EQ(scene.sh_degree, degree);
  const int k_count = sh_rest_count(degree);
  ASSERT_EQ(scene.sh_rest.size(), scene.gaussians.size() * 3 * static_cast<std::size_t>(k_count));
  for (std::size_t i = 0; i < scene.gaussians.size(); ++i) {
    const Gaussian& g = scene.gaussians[i];
    for (int a = 0; a < 3; ++a) {
      const std::string digit = std::to_string(a);
      EXPECT_EQ(g.mean[a], value_of(columns, std::string(1, "xyz"[a]), i));
      EXPECT_EQ(g.sh_dc[a], value_of(columns, "f_dc_" + digit, i));
      EXPECT_EQ(g.log_scale[a], value_of(columns, "scale_" + digit, i));
    }
    for (int a = 0; a < 4; ++a) EXPECT_EQ(g.rotation[a], value_of(columns, "rot_" + std::to_string(a), i));
    EXPECT_EQ(g.opacity_logit, value_of(columns, "opacity", i));
    for (int k = 0; k < k_count; ++k) {
      for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(sh_rest_of(scene, i)[k * 3 + c], value_of(columns, "f_rest_" + std::to_string(c * k_count + k), i))
            << "k " << k << " c " << c;
      }
    }
  }
}

TEST(Ply, ReadsEveryFormatTypeAndDegree) {
  const ScratchFolder scratch;
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    for (const char* type : {"float", "float32", "double", "float64", "int", "int32", "uint", "uint32", "short",
                             "int16", "ushort", "uint16", "char", "int8", "uchar", "uint8"}) {
      for (int degree = 0; degree <= 3; ++degree) {
        SCOPED_TRACE(std::string(format) + " " + type + " degree " + std::to_string(degree));
        const auto columns = plain_columns(3, 3 * sh_rest_count(degree), type);
        PlyText text;
        text.format = format;
        expect_holds(read_ply(scratch.write("a.ply", text.build(columns))), columns, degree);
      }
    }
  }
}

TEST(Ply, ReadsPropertiesInAnyOrderAndMixedTypes) {
  const ScratchFolder scratch;
  std::mt19937 random(7);
  const char* types[] = {"float", "double", "int", "uchar", "short"};
  for (int round = 0; round < 20; ++round) {
    auto columns = plain_columns(4, 45);
    for (std::size_t j = columns.size(); j > 1; --j) std::swap(columns[j - 1], columns[random() % j]);
    for (Column& column : columns) {
      column.type = types[random() % 5];
      if (column.name == "opacity" && column.type == std::string("uchar")) column.type = "int";  // uchar is a code
    }
    columns.insert(columns.begin() + 5, Column{"segmentation_id", "ushort", {1, 2, 3, 4}});
    PlyText text;
    text.format = round % 2 == 0 ? "binary_little_endian" : "binary_big_endian";
    SCOPED_TRACE(round);
    expect_holds(read_ply(scratch.write("a.ply", text.build(columns))), columns, 3);
  }
}

TEST(Ply, SkipsOtherElementsListsAndComments) {
  const ScratchFolder scratch;
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    for (const char* newline : {"\n", "\r\n"}) {
      const std::string n = newline;
      const bool ascii = std::string(format) == "ascii", big = std::string(format) == "binary_big_endian";
      PlyText text;
      text.format = format;
      text.newline = n;
      text.comments = {"made by hand", "element vertex 12", ""};
      text.elements_before = "obj_info x" + n + "element face 2" + n + "property list uchar int vertex_indices" + n +
                             "property float area" + n;
      for (int face = 0; face < 2; ++face) {
        if (ascii) {
          text.body_before += face == 0 ? "3 0 1 2 0.5" + n : "0 1.5" + n;
          continue;
        }
        append_value(text.body_before, "uchar", face == 0 ? 3 : 0, big);
        for (int i = 0; i < (face == 0 ? 3 : 0); ++i) append_value(text.body_before, "int", i, big);
        append_value(text.body_before, "float", 0.5, big);
      }
      text.elements_after = "element camera 2" + n + "property double fov" + n;
      for (int camera = 0; camera < 2; ++camera) {
        if (ascii) text.body_after += "60.5" + n;
        else append_value(text.body_after, "double", 60.5, big);
      }
      SCOPED_TRACE(std::string(format) + (n == "\n" ? " LF" : " CRLF"));
      const auto columns = plain_columns(5, 9);
      expect_holds(read_ply(scratch.write("a.ply", text.build(columns))), columns, 1);
    }
  }
}

TEST(Ply, SkipsAListBetweenTheVertexProperties) {
  const ScratchFolder scratch;
  std::string text = "ply\nformat ascii 1.0\nelement vertex 1\nproperty list uchar float extra\n";
  std::string body = "2 9 9";
  int value = 1;
  for (const Column& column : plain_columns(1, 0)) {
    text += "property float " + column.name + "\n";
    body += " " + std::to_string(value++);
  }
  expect_holds(read_ply(scratch.write("a.ply", text + "end_header\n" + body)), plain_columns(1, 0), 0);
}

TEST(Ply, ReadsFilesWithoutNormalsAndFlatOnesWithoutThirdScale) {
  const ScratchFolder scratch;
  auto columns = plain_columns(2, 0);
  std::erase_if(columns, [](const Column& c) { return c.name[0] == 'n'; });
  expect_holds(read_ply(scratch.write("a.ply", PlyText{}.build(columns))), columns, 0);
  std::erase_if(columns, [](const Column& c) { return c.name == "scale_2"; });
  const Scene flat = read_ply(scratch.write("b.ply", PlyText{}.build(columns)));
  EXPECT_EQ(flat.gaussians[1].log_scale.z, -std::numeric_limits<float>::infinity());
  ActivatedGaussian g;
  EXPECT_EQ(activate(flat, 0, g), Cull::kNone);
  EXPECT_EQ(g.scale.z, 0);
}

TEST(Ply, KnowsTheTwoWaysOfSayingAntialiased) {
  const ScratchFolder scratch;
  const auto read = [&](const std::string& comment) {
    PlyText text;
    text.comments = {comment};
    return read_ply(scratch.write("a.ply", text.build(plain_columns(1, 0)))).antialiased;
  };
  EXPECT_TRUE(read("antialiased 1"));
  EXPECT_TRUE(read("SplatRenderMode: mip"));
  EXPECT_FALSE(read("antialiased 0"));
  EXPECT_FALSE(read("SplatRenderMode: default"));
  EXPECT_FALSE(read("something antialiased 1"));
}

TEST(Ply, ReadsNoGaussiansAndPassesNonFiniteValuesOn) {
  const ScratchFolder scratch;
  EXPECT_TRUE(read_ply(scratch.write("a.ply", PlyText{}.build(plain_columns(0, 45)))).gaussians.empty());
  auto columns = plain_columns(3, 0, "double");
  columns[0].values = {std::nan(""), 1e300, -std::numeric_limits<double>::infinity()};
  for (const char* format : {"ascii", "binary_little_endian"}) {
    PlyText text;
    text.format = format;
    const Scene scene = read_ply(scratch.write("a.ply", text.build(columns)));
    EXPECT_TRUE(std::isnan(scene.gaussians[0].mean.x));
    EXPECT_EQ(scene.gaussians[1].mean.x, std::numeric_limits<float>::infinity());  // beyond float
    EXPECT_EQ(scene.gaussians[2].mean.x, -std::numeric_limits<float>::infinity());
  }
}

TEST(Ply, WriterRoundTripKeepsEveryBit) {
  const ScratchFolder scratch;
  for (int degree = 0; degree <= 3; ++degree) {
    auto columns = plain_columns(7, 3 * sh_rest_count(degree));
    columns[0].values[3] = -0.1f;
    PlyText text;
    text.comments = {"antialiased 1"};
    const Scene first = read_ply(scratch.write("a.ply", text.build(columns)));
    write_ply(scratch / "b.ply", first);
    const Scene second = read_ply(scratch / "b.ply");
    EXPECT_TRUE(second.antialiased);
    expect_holds(second, columns, degree);
    EXPECT_EQ(first.sh_rest, second.sh_rest);
  }
  EXPECT_EQ(scratch.files(), 2u) << "the temporary file is left behind";
}

TEST(Ply, WriterLeavesNothingBehindWhenItFails) {
  const ScratchFolder scratch;
  EXPECT_THROW(write_ply(scratch / "missing/folder/a.ply", Scene{}), InputError);
  std::filesystem::create_directories(scratch / "taken.ply/inside");
  EXPECT_THROW(write_ply(scratch / "taken.ply", Scene{}), InputError);  // a folder bears the name
  Scene inconsistent;
  inconsistent.sh_degree = 2;
  inconsistent.sh_rest.resize(5);
  EXPECT_THROW(write_ply(scratch / "a.ply", inconsistent), std::invalid_argument);
  EXPECT_EQ(scratch.files(), 1u);
}

}  // namespace
}  // namespace pipegs
