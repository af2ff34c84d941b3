// SPDX-License-Identifier: Apache-2.0
// Against scenes/formats: one scene of ours, written by other people's programs in every format (own/), is read as
// another decoder reads it, and as it was within what the bits of the format can hold.
//
// Idea    own/expected holds what splat-transform reads from a file, row by row: the same decoding, so the tolerances
//         are those of float32. own/source.ply is what was written: there each tolerance is half a step of the format,
//         worked out beside it. Formats that change the order are held against the source by sorted values, which lie
//         no further apart than the rows do.
#include <gtest/gtest.h>

#include <functional>

#include "verif/formats/compare.hpp"

namespace pipegs {
namespace {

Scene own(const std::filesystem::path& file, SceneFormat* format = nullptr, const ReadOptions& options = {}) {
  return read_scene(own_formats() / file, options, format);
}

void expect_within(const Difference& found, const Difference& most) {
  EXPECT_LE(found.position, most.position);
  EXPECT_LE(found.scale, most.scale);
  EXPECT_LE(found.alpha, most.alpha);
  EXPECT_LE(found.color, most.color);
  EXPECT_LE(found.rotation, most.rotation);
  EXPECT_LE(found.rest, most.rest);
}

// Two decoders: the roundings of float32, and their clamp of the opacity at 1e-6 where ours is exact.
constexpr Difference kDecoder{1e-6, 1e-6, 2e-6, 1e-5, 0.01, 1e-6};

TEST(Formats, AnotherDecoderReadsTheSame) {
  struct Case {
    std::filesystem::path file;
    const char* expected;
    std::size_t count;
    int degree;
  };
  for (const Case& c : {Case{"scene.compressed.ply", "scene.compressed.ply", 1424, 3},
                        {"scene.sh0.compressed.ply", "scene.compressed.ply", 1424, 0},
                        {"scene.splat", "scene.splat", 1424, 0},
                        {"ksplat/scene.level0.sh0.ksplat", "scene.level0.sh2.ksplat", 1423, 0},
                        {"ksplat/scene.level0.sh2.ksplat", "scene.level0.sh2.ksplat", 1423, 2},
                        {"ksplat/scene.level1.sh2.ksplat", "scene.level1.sh2.ksplat", 1423, 2},
                        {"ksplat/scene.level2.sh2.ksplat", "scene.level2.sh2.ksplat", 1423, 2},
                        {"sog/scene.sog", "scene.sog", 1424, 3},
                        {"sog/scene.sh0.sog", "scene.sog", 1424, 0},
                        {own_streamed(), "streamed_lod-meta.json", 1424, 3},
                        {"spz/scene.v2.rub.spz", "scene.v2.rub.spz", 1424, 3},
                        {"spz/scene.v3.rub.spz", "scene.v3.rub.spz", 1424, 3},
                        {"spz/scene.v4.rub.spz", "scene.v3.rub.spz", 1424, 3},
                        {"spz/scene.v4.rub.antialiased.spz", "scene.v3.rub.spz", 1424, 3},
                        {"spz/scene.v4.rub.sh8.spz", "scene.v4.rub.sh8.spz", 1424, 3}}) {
    SCOPED_TRACE(c.file);
    const Scene found = own(c.file);
    const Scene expected = read_ply(own_formats() / "expected" / (std::string(c.expected) + ".ply"));
    EXPECT_EQ(found.gaussians.size(), c.count);
    ASSERT_EQ(found.gaussians.size(), expected.gaussians.size());
    EXPECT_EQ(found.sh_degree, c.degree);
    expect_within(difference(found, expected), kDecoder);
  }
}

TEST(Formats, AFolderIsABundle) {
  expect_within(difference(own(own_sog()), own("sog/scene.sog")), Difference{});
  expect_within(difference(own(own_sog() / "meta.json"), own(own_sog())), Difference{});
  expect_within(difference(own(own_streamed() / "lod-meta.json"), own(own_streamed())), Difference{});
  EXPECT_EQ(own(own_streamed() / "lod-meta.json").name, own(own_streamed()).name);
  EXPECT_EQ(own(own_sog()).name, own_sog().parent_path().filename());
}

TEST(Formats, LevelsOfDetail) {
  SceneFormat format;
  const Scene coarse = own(own_streamed(), &format, {.lod = 1});
  EXPECT_EQ(coarse.gaussians.size(), 1060u);
  EXPECT_EQ(format.levels, 2);
}

// The source with its values cut where the format ends.
Scene clipped(double color, double scale_low, double scale_high, double rest_low, double rest_high) {
  Scene source = own("source.ply");
  for (Gaussian& g : source.gaussians) {
    for (int k = 0; k < 3; ++k) {
      g.sh_dc[k] = static_cast<float>(std::clamp<double>(g.sh_dc[k], -color, color));
      g.log_scale[k] = static_cast<float>(std::clamp<double>(g.log_scale[k], scale_low, scale_high));
    }
  }
  for (float& v : source.sh_rest) v = static_cast<float>(std::clamp<double>(v, rest_low, rest_high));
  return source;
}

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

constexpr double kLog = 1e-6;  // a logarithm and its exponential in float32

// Bytes hold a colour from 0 to 1; writers cut them off, so a whole step may be lost. Four components of a quaternion
// are off by half a step each, and an angle is twice the distance of quaternions.
TEST(Formats, SplatKeepsItsBits) {
  const Scene source = clipped(0.5 / kShConstant, -100, 100, -9, 9);
  const Difference steps{0, kLog, 1 / 255.0, 1 / 255.0 / kShConstant, degrees(2 * std::sqrt(4.0) * 0.5 / 127.5), 0};
  expect_within(difference(own("scene.splat"), source), steps);
}

TEST(Formats, SpzKeepsItsBits) {
  const Scene source = clipped(0.5 / 0.15, -10, 255 / 16.0 - 10, -1, 127 / 128.0);
  const double byte = 0.5 / 127.5, ninth = std::sqrt(0.5) / 511 / 2;
  // Version 2: w is the root of what three bytes leave of 1: largest near w = 0, where their errors meet |xyz| = 1.
  const double three = degrees(2 * std::sqrt(3 * byte * byte + 2 * std::sqrt(3.0) * byte));
  // Later: the largest component is at least 1/2, the others' errors at most sqrt(3) steps long, 3 in it.
  const double smallest = degrees(2 * std::sqrt(3 + 9) * ninth);
  const double coarse = (16 / 2 + 0.5) / 128, fine = 1 / 128.0;  // 4 bits above degree 1; 8 bits
  const auto most = [&](double rotation, double rest) {
    return Difference{0.5 / 4096, 0.5 / 16 + kLog, 0.5 / 255 + 1e-6, 0.5 / 255 / 0.15 + 1e-6, rotation, rest};
  };
  for (const auto& [file, axes, rotation, rest] : {std::tuple{"spz/scene.v2.rub.spz", "RUB", three, coarse},
                                                   {"spz/scene.spzjs.spz", "", three, coarse},
                                                   {"spz/scene.v3.rub.spz", "RUB", smallest, coarse},
                                                   {"spz/scene.v4.rub.spz", "RUB", smallest, coarse},
                                                   {"spz/scene.v4.st.spz", "", smallest, coarse},
                                                   {"spz/scene.v4.rub.sh8.spz", "RUB", smallest, fine},
                                                   {"gltf/scene.spz2.glb", "", three, coarse}}) {
    SCOPED_TRACE(file);
    const Scene found = own(file, nullptr, {.axes = axes});
    ASSERT_EQ(found.gaussians.size(), source.gaussians.size());
    expect_within(difference(found, source), most(rotation, rest));
    for (Gaussian g : source.gaussians) ASSERT_LT(std::abs(g.mean.x), 2048);
  }
}

TEST(Formats, GltfKeepsAll) {
  const Scene source = own("source.ply");
  for (const char* file : {"gltf/scene.glb", "gltf/scene.sh1.glb"})
    expect_within(difference(own(file), source), {0, kLog, 1e-6, 0, 1e-4, 0});
  EXPECT_EQ(own("gltf/scene.sh1.glb").sh_degree, 1);
}

std::vector<double> sorted(const Scene& scene, const std::function<double(const Gaussian&)>& value) {
  std::vector<double> values;
  for (const Gaussian& g : scene.gaussians) values.push_back(value(g));
  std::sort(values.begin(), values.end());
  return values;
}

// Rows in another order.
TEST(Formats, ReorderedFilesKeepTheirBits) {
  const Scene source = own("source.ply");
  const auto apart = [&](const Scene& found, const std::function<double(const Gaussian&)>& value) {
    const std::vector<double> a = sorted(found, value), b = sorted(source, value);
    double most = 0;
    for (std::size_t i = 0; i < b.size(); ++i) most = std::max(most, std::abs(a.at(i) - b[i]));
    return most;
  };
  for (const std::filesystem::path& file : {std::filesystem::path("scene.compressed.ply"), own_sog(), own_streamed()})
    EXPECT_LE(apart(own(file), alpha_of), 1 / 255.0) << file;
  for (int axis = 0; axis < 3; ++axis) {
    const auto scale = [&](const Gaussian& g) { return static_cast<double>(g.log_scale[axis]); };
    const auto position = [&](const Gaussian& g) { return static_cast<double>(g.mean[axis]); };
    const std::vector<double> scales = sorted(source, scale), positions = sorted(source, position);
    const Scene compressed = own("scene.compressed.ply");  // a chunk is no wider than all: 10 bits or 11
    EXPECT_LE(apart(compressed, scale), (scales.back() - scales.front()) / 1023 / 2);
    EXPECT_LE(apart(compressed, position), (positions.back() - positions.front()) / 1023 / 2);
    // SOG: 16 bits of sign(x) log(1 + |x|), a step of which is a share of 1 + |x|.
    const double low = std::log1p(std::abs(positions.front())), high = std::log1p(std::abs(positions.back()));
    const double step = (low + high) / 65535, farthest = std::max(-positions.front(), positions.back());
    EXPECT_LE(apart(own("sog/scene.sog"), position), step * (1 + farthest));
  }
}

TEST(Formats, TheFileSaysWhatItHasLost) {
  SceneFormat format;
  EXPECT_TRUE(own("spz/scene.v4.rub.antialiased.spz", &format).antialiased);
  EXPECT_EQ(format.name, ".spz version 4 (zstd)");
  EXPECT_EQ(format.fields.back().second, "5 bits of 8 for degree 1, 4 above");
  EXPECT_EQ(format.axes, "");
  ASSERT_EQ(format.findings.size(), 1u);
  EXPECT_EQ(format.findings[0].kind->key, "axes_unknown");
  EXPECT_FALSE(own("spz/scene.v4.rub.sh8.spz", &(format = {})).antialiased);
  EXPECT_EQ(format.fields.back().second, "8 bits of 8 for degree 1, 8 above");
  own("ksplat/scene.level2.sh2.ksplat", &(format = {}));
  EXPECT_EQ(format.name, ".ksplat level 2");
  own("source.ply", &(format = {}));
  EXPECT_EQ(format.name, "INRIA's .ply");
  EXPECT_EQ(format.fields.front().second, "32 bits, as trained");
  own("gltf/scene.spz2.glb", &(format = {}));
  EXPECT_EQ(format.name, "glTF with KHR_gaussian_splatting, .spz version 2 (gzip) inside");
  EXPECT_EQ(format.axes, "RUB");
}

}  // namespace
}  // namespace pipegs
