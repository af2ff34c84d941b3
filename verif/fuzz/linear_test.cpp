// SPDX-License-Identifier: Apache-2.0
// linear_test: readers of large shallow documents take operations in proportion to their length, not to its square.
//
// Idea    No clock: readers are compiled with the fuzzer's coverage, which calls a function at each comparison, in the
//         library's templates too. A document twice as long may take a little more than twice as many. Most of the time
//         goes into small pieces of memory, so these are counted where a document of the largest size must be quick.
#include <gtest/gtest.h>
#include <sanitizer/allocator_interface.h>

#include <cstdint>

#include "scenes/camera.hpp"
#include "scenes/formats/read_scene.hpp"
#include "scenes/input_error.hpp"
#include "scenes/text/json.hpp"
#include "scenes/text/json_node.hpp"
#include "verif/formats/packed_bytes.hpp"

static std::uint64_t g_comparisons = 0, g_allocations = 0;

#define PIPEGS_COUNTED(name, type) \
  extern "C" __attribute__((no_sanitize("coverage"))) void __sanitizer_cov_trace_##name(type, type) { ++g_comparisons; }
PIPEGS_COUNTED(cmp1, std::uint8_t)
PIPEGS_COUNTED(cmp2, std::uint16_t)
PIPEGS_COUNTED(cmp4, std::uint32_t)
PIPEGS_COUNTED(cmp8, std::uint64_t)
PIPEGS_COUNTED(const_cmp1, std::uint8_t)
PIPEGS_COUNTED(const_cmp2, std::uint16_t)
PIPEGS_COUNTED(const_cmp4, std::uint32_t)
PIPEGS_COUNTED(const_cmp8, std::uint64_t)

namespace pipegs {
namespace {

template <typename Read>
std::uint64_t comparisons(const Read& read, const std::string& text) {
  const std::uint64_t before = g_comparisons;
  try {
    read(text);
  } catch (const InputError&) {}  // as much work
  return g_comparisons - before;
}

std::string repeated(const std::string& head, const std::string& item, int count, const std::string& tail) {
  std::string text = head + item;
  for (int i = 1; i < count; ++i) text += "," + item;
  return text + tail;
}

// `make` gives a document of so many items.
template <typename Make, typename Read>
void expect_linear(const Make& make, const Read& read) {
  constexpr int kItems = 500;
  const std::uint64_t once = comparisons(read, make(kItems)), twice = comparisons(read, make(2 * kItems));
  EXPECT_GT(once, std::uint64_t{kItems}) << "nothing was counted";
  EXPECT_LT(static_cast<double>(twice), 2.3 * static_cast<double>(once)) << once << " and " << twice;
}

void cameras(const std::string& text) { parse_cameras("c.json", text, {.width = 4, .height = 3}); }
void scene(const std::string& text) {
  const InputFile::Beside beside = [](const std::string& name) { return InputFile(name, "no picture"); };
  SceneFormat format;
  read_scene(InputFile("s", text, beside), {}, format);
}

TEST(Linear, AnyListOfObjects) {
  for (const char* item : {"{}", "[]", "{\"a\":{}}", "{\"a\":1,\"b\":[2,{}]}", "\"a\"", "1"}) {
    SCOPED_TRACE(item);
    const auto list = [&](int n) { return repeated("[", item, n, "]"); };
    expect_linear(list, [](const std::string& text) { parse_json<nlohmann::json>("a", text); });
    expect_linear(list, [](const std::string& text) { parse_json<nlohmann::ordered_json>("a", text); });
    expect_linear(list, cameras);
    expect_linear([&](int n) { return repeated("{\"means\":[", item, n, "]}"); }, scene);
  }
}

TEST(Linear, AnObjectOfManyKeys) {
  const auto keys = [](int n) {
    std::string text = "{\"version\":2";
    for (int i = 0; i < n; ++i) text += ",\"" + std::to_string(1000000 + i) + "\":{}";
    return text + "}";
  };
  expect_linear(keys, [](const std::string& text) { parse_json<nlohmann::json>("a", text); });
  expect_linear(keys, [](const std::string& text) { parse_json<nlohmann::ordered_json>("a", text); });
  expect_linear(keys, [](const std::string& text) { JsonNode::parse("a", text).keys(); });
}

TEST(Linear, CamerasOfEveryFormat) {
  const std::string place = R"("position":[0,0,0],)", rows = "[[1,0,0,0],[0,-1,0,0],[0,0,-1,0]]";
  const std::string inria =
      R"({"width":4,"height":3,"fx":2,"fy":2,)" + place + R"("rotation":[[1,0,0],[0,1,0],[0,0,1]]})";
  expect_linear([&](int n) { return repeated("[", inria, n, "]"); }, cameras);
  expect_linear(
      [&](int n) { return repeated(R"({"fl_x":2,"frames":[)", "{\"transform_matrix\":" + rows + "}", n, "]}"); },
      cameras);
  const std::string pose = "{" + place + R"("target":[0,0,1],"fov":60})";
  expect_linear([&](int n) { return repeated("{\"frames\":[", pose, n, "]}"); }, cameras);
  expect_linear([&](int n) { return repeated("{\"cameras\":[", "{\"initial\":" + pose + "}", n, "]}"); }, cameras);
  expect_linear([&](int n) { return repeated("{\"poseSets\":[{\"poses\":[", pose, n, "]}]}"); }, cameras);
  const auto track = [](int n) {
    return R"({"animTracks":[{"keyframes":{"times":)" + repeated("[", "0", n, "]") + R"(,"values":{"position":)" +
           repeated("[", "0,0,0", n, "]") + R"(,"target":)" + repeated("[", "0,0,1", n, "]") + R"(,"fov":)" +
           repeated("[", "60", n, "]") + "}}}]}";
  };
  expect_linear(track, cameras);
}

// Nodes without a mesh; and one mesh, of a Gaussian, under all of them.
TEST(Linear, NodesOfGltf) {
  const auto gltf = [](int n, const std::string& node) {
    std::string roots = "0";
    for (int i = 1; i < n; ++i) roots += "," + std::to_string(i);
    return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[)" + roots + "]}]," +
           repeated("\"nodes\":[", node, n, "]") +
           R"(,"buffers":[{"uri":"data:;base64,AAAAAAAAAAAAAAAAAAAAAAAAAAA="}],
              "bufferViews":[{"buffer":0,"byteLength":16}],
              "accessors":[{"bufferView":0,"componentType":5126,"count":1,"type":"VEC3"},
                           {"bufferView":0,"componentType":5126,"count":1,"type":"VEC4"},
                           {"bufferView":0,"componentType":5126,"count":1,"type":"SCALAR"}],
              "meshes":[{"primitives":[{"extensions":{"KHR_gaussian_splatting":{}},"attributes":{"POSITION":0,
                "KHR_gaussian_splatting:SCALE":0,"KHR_gaussian_splatting:ROTATION":1,
                "KHR_gaussian_splatting:OPACITY":2,"KHR_gaussian_splatting:SH_DEGREE_0_COEF_0":0}}]}]})";
  };
  expect_linear([&](int n) { return gltf(n, "{}"); }, scene);
  expect_linear([&](int n) { return gltf(n, "{\"mesh\":0}"); }, scene);
  expect_linear([&](int n) { return gltf(n, R"({"mesh":0,"rotation":[0,0,0,1],"scale":[2,2,2]})"); }, scene);
  SceneFormat format;
  EXPECT_EQ(read_scene(InputFile("s", gltf(7, "{\"mesh\":0}")), {}, format).gaussians.size(), 7u);
}

TEST(Linear, BoxesOfAStreamedSog) {
  const std::string head = R"({"lodLevels":1,"filenames":["a/meta.json"],"tree":{"children":[)";
  expect_linear([&](int n) { return repeated(head, "{}", n, "]}}"); }, scene);
  expect_linear([&](int n) { return repeated(head, R"({"lods":{"0":{"file":0,"offset":0,"count":0}}})", n, "]}}"); },
                scene);
}

// A streamed SOG in an archive names each of its members.
TEST(Linear, MembersOfAZipArchive) {
  const std::string texture = webp(1, 1, {128, 128, 128, 255}), codebook = repeated("[", "0", 256, "]");
  const std::string meta = R"({"version":2,"count":1,"means":{"mins":[0,0,0],"maxs":[1,1,1],"files":["t","t"]},)"
                           R"("quats":{"files":["t"]},"scales":{"files":["t"],"codebook":)" +
                           codebook + R"(},"sh0":{"files":["t"],"codebook":)" + codebook + "}}";
  const auto archive = [&](int n) {
    std::vector<std::pair<std::string, std::string>> files;
    std::string names, boxes;
    for (int i = 0; i < n; ++i) {
      const std::string folder = std::to_string(1000 + i), comma = i == 0 ? "" : ",";
      files.emplace_back(folder + "/meta.json", meta);
      files.emplace_back(folder + "/t", texture);
      names += comma + "\"" + folder + "/meta.json\"";
      boxes += comma + R"({"lods":{"0":{"file":)" + std::to_string(i) + R"(,"offset":0,"count":1}}})";
    }
    files.emplace_back("lod-meta.json",
                       R"({"lodLevels":1,"filenames":[)" + names + R"(],"tree":{"children":[)" + boxes + "]}}");
    return zip(files);
  };
  expect_linear([&](int n) { return archive(n / 5); }, scene);
  SceneFormat format;
  EXPECT_EQ(read_scene(InputFile("s", archive(7)), {}, format).gaussians.size(), 7u);
}

// Half a million of them take less than two seconds: two pieces of memory for each value that is kept, one for each
// step of the way to one that is read, and a share of the lists.
TEST(Linear, ABoxOfAStreamedSogTakesFewPiecesOfMemory) {
  constexpr std::uint64_t kBoxes = 1000, kEach = 25;
  const std::string text = repeated(R"({"lodLevels":1,"filenames":["a/meta.json"],"tree":{"children":[)",
                                    R"({"lods":{"0":{"file":0,"offset":0,"count":0}}})", kBoxes, "]}}");
  __sanitizer_install_malloc_and_free_hooks([](const volatile void*, std::size_t) { ++g_allocations; },
                                            [](const volatile void*) {});
  const std::uint64_t before = g_allocations;
  EXPECT_THROW(scene(text), InputError);
  EXPECT_GT(g_allocations - before, kBoxes) << "nothing was counted";
  EXPECT_LT(g_allocations - before, kEach * kBoxes);
}

}  // namespace
}  // namespace pipegs
