// SPDX-License-Identifier: Apache-2.0
// Against scenes/formats: files of one or two Gaussians, each byte worked out by hand, for what own/ does not hold: SOG
// version 1, an .spz that says its axes, SH of degree 4, glTF with nodes, types and buffers of all kinds.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>

#include "scenes/input_error.hpp"
#include "verif/formats/compare.hpp"
#include "verif/formats/packed_bytes.hpp"
#include "verif/scenes/scratch_folder.hpp"

namespace pipegs {
namespace {

Scene read_bytes(const std::string& bytes, SceneFormat* format = nullptr, const ReadOptions& options = {}) {
  SceneFormat own;
  return read_scene(InputFile("by_hand", bytes), options, format == nullptr ? own : *format);
}

void expect_near(const glm::vec3& found, const glm::vec3& wanted, double by = 1e-6) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], wanted[k], by) << "axis " << k;
}

std::string splat_row(float x, float scale, std::uint8_t alpha) {
  std::string row;
  for (const float v : {x, 2.0f, -3.0f, scale, 1.0f, 2.0f}) put(row, v);
  for (const int v : {0, 255, 51, static_cast<int>(alpha), 255, 128, 128, 0}) put(row, static_cast<std::uint8_t>(v));
  return row;
}

TEST(FormatsByHand, Splat) {
  const Scene scene = read_bytes(splat_row(1, 0.5f, 51) + splat_row(7, 0, 255));
  ASSERT_EQ(scene.gaussians.size(), 2u);
  const Gaussian& g = scene.gaussians[0];
  EXPECT_EQ(g.mean, glm::vec3(1, 2, -3));
  expect_near(g.log_scale, {std::log(0.5f), 0, std::log(2.0f)});
  expect_near(g.sh_dc, {-0.5 / kShConstant, 0.5 / kShConstant, -0.3 / kShConstant});
  EXPECT_NEAR(alpha_of(g), 0.2, 1e-7);
  EXPECT_EQ(g.rotation[0], 1);
  EXPECT_NEAR(g.rotation[1], 1 / 255.0, 1e-7);  // 128 is half a step above the middle
  EXPECT_EQ(g.rotation[3], -1);
  // The ends: opaque to the last bit of float32, and flat, both finite.
  EXPECT_EQ(1 / (1 + std::exp(-scene.gaussians[1].opacity_logit)), 1.0f);
  EXPECT_TRUE(std::isfinite(scene.gaussians[1].log_scale.x));
  EXPECT_LT(std::exp(scene.gaussians[1].log_scale.x), 1e-37f);
}

std::string xyzs(const std::string& line) { return "xyzs 1\n1 2 -3  0.5 1 2  1 0 0 -1  0.2  0 1 0.2\r\n\n" + line; }

TEST(FormatsByHand, Xyzs) {
  SceneFormat format;
  const Scene scene = read_bytes(xyzs("\t7 0 nan 0 1 1 0 0 0 0 1 0 0 0"), &format);
  EXPECT_EQ(format.name, ".xyzs version 1");
  ASSERT_EQ(scene.gaussians.size(), 2u);
  const Gaussian& g = scene.gaussians[0];
  EXPECT_EQ(g.mean, glm::vec3(1, 2, -3));
  expect_near(g.log_scale, {std::log(0.5f), 0, std::log(2.0f)});
  EXPECT_EQ(g.rotation, glm::vec4(1, 0, 0, -1));
  EXPECT_NEAR(alpha_of(g), 0.2, 1e-7);
  expect_near(g.sh_dc, {-0.5 / kShConstant, 0.5 / kShConstant, -0.3 / kShConstant});
  ActivatedGaussian activated;
  EXPECT_EQ(activate(scene, 1, activated), Cull::kNonFinite);
  for (const char* line : {"1 2 3", "1 2 3 1 1 1 1 0 0 0 1 0 0 0 0", "a 2 3 1 1 1 1 0 0 0 1 0 0 0"}) {
    try {
      read_bytes(xyzs(line));
      ADD_FAILURE() << line;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("line 4: found "), std::string::npos);
    }
  }
  EXPECT_THROW(read_bytes("xyzs 2\n"), InputError);
}

// NaN and infinities of a body are read, and such Gaussians are left out later.
TEST(FormatsByHand, NotANumberIsCulled) {
  std::string rows;
  for (int i = 0; i < 300; ++i) rows += splat_row(1, 1, 51);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(rows.data() + 32 * 280, &nan, sizeof nan);
  const Scene scene = read_bytes(rows);
  ActivatedGaussian activated;
  EXPECT_EQ(activate(scene, 280, activated), Cull::kNonFinite);
  EXPECT_EQ(activate(scene, 281, activated), Cull::kNone);
}

// Two Gaussians of SH degree 4, of which 3 is kept; an extension that says RUB.
std::string spz(bool axes) {
  std::string out;
  put<std::uint32_t>(out, 0x5053474e), put<std::uint32_t>(out, 3), put<std::uint32_t>(out, 2);
  for (const int v : {4, 8, axes ? 3 : 1, 0}) put(out, static_cast<std::uint8_t>(v));
  for (const int fixed : {256, -128, 1, 512, 8388607, -8388608}) {
    for (int byte = 0; byte < 3; ++byte) put(out, static_cast<std::uint8_t>(fixed >> 8 * byte));
  }
  out += std::string("\x33\xff", 2);                                      // 0.2, 1
  out += std::string("\x00\x80\xff\x00\x80\xff", 6);                      // colours
  out += std::string("\xa0\x00\xff\xa0\x00\xff", 6);                      // scales: 0, -10, 5.9375
  put<std::uint32_t>(out, 3u << 30 | 0u << 20 | 511u << 10 | 512u | 0u);  // w largest; x = 0, y = sqrt(1/2), z = -0
  put<std::uint32_t>(out, 0u << 30);                                      // x largest, the others 0
  for (int i = 0; i < 2; ++i) {
    for (int k = 0; k < 72; ++k) put(out, static_cast<std::uint8_t>(128 + 8 * (k % 3) + (k < 9 ? 0 : 16)));
  }
  if (axes) put<std::uint32_t>(out, 0xADBE0003), put<std::uint32_t>(out, 4), put<std::uint32_t>(out, 4);
  return gzip(out);
}

TEST(FormatsByHand, Spz) {
  SceneFormat format;
  const Scene scene = read_bytes(spz(false), &format);
  ASSERT_EQ(scene.gaussians.size(), 2u);
  EXPECT_EQ(scene.sh_degree, 3);
  EXPECT_TRUE(scene.antialiased);
  expect_near(scene.gaussians[0].mean, {1, -0.5, 1 / 256.0}, 0);
  expect_near(scene.gaussians[1].mean, {2, 8388607 / 256.0, -32768}, 0);
  expect_near(scene.gaussians[0].log_scale, {0, -10, 5.9375}, 0);
  expect_near(scene.gaussians[0].sh_dc, {-0.5 / 0.15, (128 / 255.0 - 0.5) / 0.15, 0.5 / 0.15});
  EXPECT_NEAR(alpha_of(scene.gaussians[0]), 0.2, 1e-7);
  const glm::vec4 turned = scene.gaussians[0].rotation;
  EXPECT_NEAR(turned[0], std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(turned[2], std::sqrt(0.5), 1e-6);
  EXPECT_EQ(scene.gaussians[1].rotation[1], 1);
  EXPECT_EQ(sh_rest_of(scene, 1)[1], 8 / 128.0f);
  EXPECT_EQ(sh_rest_of(scene, 1)[44], 32 / 128.0f);
  EXPECT_NE(format.findings.front().what.find("degree 4"), std::string::npos);
}

TEST(FormatsByHand, SpzThatSaysItsAxes) {
  SceneFormat format;
  const Scene stored = read_bytes(spz(false)), turned = read_bytes(spz(true), &format);
  EXPECT_EQ(format.axes, "RUB");
  expect_near(turned.gaussians[0].mean, {1, 0.5, -1 / 256.0}, 0);
  EXPECT_EQ(sh_rest_of(turned, 0)[1], -sh_rest_of(stored, 0)[1]);  // -y
  EXPECT_EQ(sh_rest_of(turned, 0)[7], sh_rest_of(stored, 0)[7]);   // -x
  // An option overrules the file.
  expect_near(read_bytes(spz(true), nullptr, {.axes = "RDF"}).gaussians[0].mean, {1, -0.5, 1 / 256.0}, 0);
}

// The first version of SOG: ranges in place of codebooks, and the opacity's logit.
TEST(FormatsByHand, SogVersion1) {
  const ScratchFolder folder;
  folder.write("meta.json", R"({
    "means": {"shape": [2, 3], "dtype": "float32", "mins": [-1, 0, 0], "maxs": [1, 1, 2], "files": ["l", "u"]},
    "scales": {"shape": [2, 3], "mins": [-8, -8, -4], "maxs": [0, 0, 0], "files": ["s"]},
    "quats": {"shape": [2, 4], "encoding": "quaternion_packed", "files": ["q"]},
    "sh0": {"shape": [2, 1, 4], "mins": [-1, -1, -1, -5], "maxs": [1, 1, 1, 5], "files": ["c"]},
    "shN": {"shape": [2, 9], "mins": -1, "maxs": 1, "quantization": 8, "files": ["p", "n"]}})");
  const auto write = [&](const char* name, std::vector<std::uint8_t> texels, int width = 2) {
    folder.write(name, webp(width, static_cast<int>(texels.size()) / 4 / width, texels));
  };
  write("l", {0, 255, 0, 255, 255, 255, 255, 255});
  write("u", {0, 255, 0, 255, 255, 255, 0, 255});
  write("s", {0, 255, 51, 255, 255, 0, 255, 255});
  write("q", {255, 0, 255, 252, 0, 0, 0, 7});
  write("c", {0, 255, 51, 255, 255, 0, 255, 0});
  std::vector<std::uint8_t> palette(192 * 4, 255);
  for (std::size_t k = 0; k < 3; ++k) palette[(3 + k) * 4] = static_cast<std::uint8_t>(51 * k);  // R of entry 1
  write("p", palette, 192);
  write("n", {1, 0, 0, 255, 0, 1, 0, 255});  // entry 1; entry 256, which is not there
  SceneFormat format;
  const Scene scene = read_scene(folder / "", {}, &format);
  EXPECT_EQ(format.name, "SOG version 1");
  ASSERT_EQ(scene.gaussians.size(), 2u);
  ASSERT_EQ(scene.sh_degree, 1);
  const Gaussian &a = scene.gaussians[0], &b = scene.gaussians[1];
  expect_near(a.mean, {-std::expm1(1.0), std::expm1(1.0), 0});
  expect_near(b.mean, {std::expm1(1.0), std::expm1(1.0), std::expm1(2 * 255 / 65535.0)});
  expect_near(a.log_scale, {-8, 0, -3.2});
  expect_near(a.sh_dc, {-1, 1, -0.6});
  EXPECT_EQ(a.opacity_logit, 5);
  EXPECT_EQ(b.opacity_logit, -5);
  EXPECT_EQ(a.rotation[0], 0);  // three bytes of 1, -1, 1 leave nothing to the largest, w
  EXPECT_NEAR(a.rotation[2], -std::sqrt(0.5), 1e-6);
  EXPECT_EQ(b.rotation, glm::vec4(1, 0, 0, 0));  // its tag is none
  EXPECT_NEAR(sh_rest_of(scene, 0)[0], -1, 1e-6);
  EXPECT_NEAR(sh_rest_of(scene, 0)[3], -0.6, 1e-6);
  EXPECT_NEAR(sh_rest_of(scene, 0)[6], -0.2, 1e-6);
  EXPECT_NEAR(sh_rest_of(scene, 0)[1], 1, 1e-6);
  EXPECT_EQ(sh_rest_of(scene, 1)[0], 0);
  // The same as a bundle, deflated.
  std::vector<std::pair<std::string, std::string>> files;
  for (const char* name : {"meta.json", "l", "u", "s", "q", "c", "p", "n"}) {
    std::ifstream file(folder / name, std::ios::binary);
    files.emplace_back(name, std::string(std::istreambuf_iterator<char>(file), {}));
  }
  const Scene bundle = read_bytes(zip(files, true));
  EXPECT_EQ(bundle.gaussians[1].mean, b.mean);
  EXPECT_EQ(bundle.sh_rest, scene.sh_rest);
}

// One Gaussian: int8 rotation, uint8 opacity and scale, SH degree 0, positions a stride apart.
std::string gltf(const std::string& node, const std::string& uri, const std::string& more = "") {
  return fmt::format(
      R"({{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}],
      "nodes": [{{"children": [1], "scale": [2, 2, 2]}}, {{"mesh": 0 {}}}],
      "meshes": [{{"primitives": [{{"mode": 0}}, {{"mode": 0,
        "extensions": {{"KHR_gaussian_splatting": {{}}}},
        "attributes": {{"POSITION": 0, "KHR_gaussian_splatting:ROTATION": 1, "KHR_gaussian_splatting:SCALE": 2,
         "KHR_gaussian_splatting:OPACITY": 3, "KHR_gaussian_splatting:SH_DEGREE_0_COEF_0": 0}}}}]}}],
      "buffers": [{{"byteLength": 36 {}}}], "bufferViews": [{{"buffer": 0, "byteLength": 28, "byteStride": 16}},
        {{"buffer": 0, "byteOffset": 28, "byteLength": 8}}],
      "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 2, "type": "VEC3"}},
        {{"bufferView": 1, "byteOffset": 0, "componentType": 5120, "normalized": true, "count": 2, "type": "VEC4"}},
        {{"bufferView": 1, "byteOffset": 0, "componentType": 5121, "count": 2, "type": "VEC3"}},
        {{"bufferView": 1, "byteOffset": 1, "componentType": 5121, "normalized": true, "count": 2,
          "type": "SCALAR"}}] {}}})",
      node, uri, more);
}

std::string gltf_buffer() {
  std::string bytes;
  for (const float v : {1.0f, 2.0f, 3.0f, -1.0f, 4.0f, 5.0f, 6.0f}) put(bytes, v);
  for (const int v : {127, 0, 51, 1, 0, 127, -128, 0}) put(bytes, static_cast<std::int8_t>(v));
  return bytes;
}

TEST(FormatsByHand, Gltf) {
  const std::string uri = R"(, "uri": "data:application/octet-stream;base64,)" + base64(gltf_buffer()) + "\"";
  SceneFormat format;
  const Scene scene = read_bytes(gltf(R"(, "translation": [10, 0, 0])", uri), &format);
  EXPECT_EQ(format.axes, "LUF");
  ASSERT_EQ(scene.gaussians.size(), 2u);
  const Gaussian &a = scene.gaussians[0], &b = scene.gaussians[1];
  expect_near(a.mean, {-22, -4, 6});  // (1 + 10, 2, 3) twice as large, half a turn about z
  expect_near(b.mean, {-28, -10, 12});
  expect_near(a.log_scale, {std::log(254.0f), std::log(2 * std::numeric_limits<float>::min()), std::log(102.0f)}, 1e-4);
  EXPECT_EQ(alpha_of(a), 1 / (1 + std::exp(20.0)));
  EXPECT_NEAR(alpha_of(b), 51 / 255.0, 1e-7);
  expect_near(a.sh_dc, {1, 2, 3});
  // x = 1, z = 51/127, w = 1/127 of the file, turned.
  const glm::vec4 q(1 / 127.0f, 1, 0, 51 / 127.0f), half_turn(-q[3], -q[2], q[1], q[0]);
  EXPECT_NEAR(angle_between(a.rotation, half_turn), 0, 1e-4);
  EXPECT_NEAR(angle_between(b.rotation, glm::vec4(1, -1, 0, 0)), 0, 1e-4);  // -128 is -1 as -127 is

  // The same buffer as a file beside it, and as the second chunk of a .glb.
  const ScratchFolder folder;
  folder.write("the buffer.bin", gltf_buffer());
  folder.write("a.gltf", gltf("", R"(, "uri": "the%20buffer.bin")"));
  expect_near(read_scene(folder / "a.gltf").gaussians[0].mean, {-2, -4, 6});
  std::string json = gltf("", ""), glb = "glTF", chunks;
  json.append((4 - json.size() % 4) % 4, ' ');
  put(chunks, static_cast<std::uint32_t>(json.size())), put<std::uint32_t>(chunks, 0x4E4F534A), chunks += json;
  put<std::uint32_t>(chunks, 36), put<std::uint32_t>(chunks, 0x004E4942), chunks += gltf_buffer();
  put<std::uint32_t>(glb, 2), put(glb, static_cast<std::uint32_t>(12 + chunks.size()));
  expect_near(read_bytes(glb + chunks).gaussians[0].mean, {-2, -4, 6});
  EXPECT_EQ(read_bytes(glb + chunks, nullptr, {.axes = "RDF"}).gaussians[0].mean, glm::vec3(2, 4, 6));
}

TEST(FormatsByHand, TheSkyOfAStreamedScene) {
  const ScratchFolder folder;
  std::filesystem::copy(own_streamed() / "0_0", folder / "0_0");
  std::filesystem::copy(own_streamed() / "1_0", folder / "sky");
  folder.write("lod-meta.json", R"({"lodLevels": 1, "filenames": ["0_0/meta.json"], "environment": "sky/meta.json",
    "tree": {"children": [{"lods": {"0": {"file": 0, "offset": 10, "count": 5}}},
                          {"lods": {"0": {"file": 0, "offset": 3, "count": 2}, "1": {}}}]}})");
  const Scene scene = read_scene(folder / ""), whole = read_scene(folder / "0_0");
  ASSERT_EQ(scene.gaussians.size(), 7u + 1060u);
  EXPECT_EQ(scene.gaussians[0].mean, whole.gaussians[3].mean);
  EXPECT_EQ(scene.gaussians[6].mean, whole.gaussians[14].mean);
  EXPECT_EQ(sh_rest_of(scene, 6)[44], sh_rest_of(whole, 14)[44]);
}

}  // namespace
}  // namespace pipegs
