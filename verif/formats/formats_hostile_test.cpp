// SPDX-License-Identifier: Apache-2.0
// Against scenes/formats: what is cut, changed or made to harm is refused in one line or read, within the memory that
// such a file may take.
//
// Idea    Every file of own/ is cut at all lengths at which something else is missing; then come files that claim what
//         they do not hold. The whole test may have little more memory than the program itself. Random bytes are the
//         work of verif/fuzz.
#include <sys/resource.h>

#include <fstream>
#include <set>

#include "verif/formats/compare.hpp"
#include "verif/formats/packed_bytes.hpp"
#include "verif/scenes/refused.hpp"

namespace pipegs {
namespace {

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool kLimited = false;  // its shadow takes terabytes of addresses
#else
constexpr bool kLimited = true;
#endif
#else
constexpr bool kLimited = true;
#endif

class FormatsHostile : public testing::Test {
 protected:
  void SetUp() override {
    constexpr rlim_t kBytes = rlim_t{1} << 30;
    getrlimit(RLIMIT_AS, &before_);
    const rlimit limit{std::min(kBytes, before_.rlim_max), before_.rlim_max};
    if (kLimited) setrlimit(RLIMIT_AS, &limit);
  }
  void TearDown() override { setrlimit(RLIMIT_AS, &before_); }

 private:
  rlimit before_{};
};

std::string content(const std::filesystem::path& name) {
  std::ifstream file(own_formats() / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// The message, one short line; "read" when the file was accepted.
std::string outcome(const std::string& bytes, const std::filesystem::path& folder = {}) {
  try {
    SceneFormat format;
    const InputFile file(
        "bad", bytes,
        folder.empty() ? InputFile::Beside{} : [&](const std::string& name) { return InputFile(folder / name); });
    const Scene scene = read_scene(file, {}, format);
    check_consistent(scene);
    ActivatedGaussian activated;
    for (std::size_t i = 0; i < scene.gaussians.size(); ++i) activate(scene, i, activated);
    return "read";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_LT(message.size(), 500u) << message;
    return message;
  }
}

void expect_refused(const std::string& bytes, const std::vector<std::string>& words,
                    const std::filesystem::path& folder = {}) {
  const std::string message = outcome(bytes, folder);
  for (const std::string& word : words) EXPECT_NE(message.find(word), std::string::npos) << word << " in: " << message;
}

template <typename T>
std::string with(std::string bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
  return bytes;
}

// A .glb with another JSON, whose lengths agree.
std::string changed_glb(const std::string& name, const std::string& from, const std::string& to) {
  const std::string glb = content(name);
  const std::size_t length = load<std::uint32_t>(reinterpret_cast<const std::uint8_t*>(&glb[12]));
  const std::string json = replaced(glb.substr(20, length), from, to), rest = glb.substr(20 + length);
  std::string out = glb.substr(0, 8);
  put(out, static_cast<std::uint32_t>(20 + json.size() + rest.size()));
  put(out, static_cast<std::uint32_t>(json.size()));
  return out + glb.substr(16, 4) + json + rest;
}

const std::vector<std::string> kFiles = {"scene.compressed.ply",
                                         "scene.splat",
                                         "ksplat/scene.level0.sh0.ksplat",
                                         "ksplat/scene.level1.sh2.ksplat",
                                         "ksplat/scene.level2.sh2.ksplat",
                                         "spz/scene.v2.rub.spz",
                                         "spz/scene.v3.rub.spz",
                                         "spz/scene.v4.st.spz",
                                         "sog/scene.sh0.sog",
                                         "sog/scene.sog",
                                         "gltf/scene.sh1.glb",
                                         "gltf/scene.spz2.glb"};

TEST_F(FormatsHostile, EveryCut) {
  for (const std::string& name : kFiles) {
    SCOPED_TRACE(name);
    const std::string good = content(name);
    ASSERT_EQ(outcome(good), "read");
    std::set<std::size_t> cuts;
    for (std::size_t n = 0; n <= 64; ++n) cuts.insert(n), cuts.insert(good.size() - 1 - n);
    for (std::size_t n = 64; n < good.size(); n += good.size() / 100 + 1) cuts.insert(n);
    for (const std::size_t n : {1024, 4095, 4096, 4097, 5119, 5120, 5121}) cuts.insert(std::min(n, good.size() - 1));
    for (const std::size_t n : cuts) {
      const std::string message = outcome(good.substr(0, n));
      // A .splat is read to its last whole row; of the end of a zip nothing is needed but its place.
      const bool whole = name.ends_with(".splat") && n >= 32;
      if (name.ends_with(".sog") && n + 4 > good.size()) continue;
      EXPECT_EQ(message == "read", whole) << n << " bytes: " << message;
    }
  }
}

TEST_F(FormatsHostile, CountsBeyondTheFile) {
  for (const char* count : {"1425", "2147483648", "9223372036854775808", "18446744073709551615"}) {
    const std::string ply = content("scene.compressed.ply");
    expect_refused(replaced(ply, "vertex 1424", std::string("vertex ") + count), {});
    EXPECT_NE(outcome(replaced(ply, "vertex 1424", std::string("vertex ") + count)), "read");
    EXPECT_NE(outcome(replaced(ply, "chunk 6", std::string("chunk ") + count)), "read");
    const std::string meta = content(own_sog() / "meta.json"), lod = content(own_streamed() / "lod-meta.json");
    const std::string sog = replaced(meta, "\"count\":1424", std::string("\"count\":") + count);
    if (std::string(count) != "1425") expect_refused(sog, {"count"}, own_sog());
    const auto rows = [&](const char* key, const char* value) {
      return replaced(lod, value, std::string("\"") + key + "\":" + count);
    };
    EXPECT_NE(outcome(rows("offset", "\"offset\":0"), own_streamed()), "read");
    EXPECT_NE(outcome(rows("count", "\"count\":1424}"), own_streamed()), "read");
    expect_refused(changed_glb("gltf/scene.sh1.glb", "\"count\":1424", std::string("\"count\":") + count),
                   {"accessors"});
  }
  for (const std::uint32_t count : {1425u, 1u << 31, 0xffffffffu}) {
    const std::string v4 = content("spz/scene.v4.st.spz");
    expect_refused(with(v4, 8, count), {"bad: "});
    for (std::size_t stream = 0; stream < 6; ++stream) {
      for (const std::uint64_t size : {std::uint64_t{count}, std::uint64_t{1} << 63, UINT64_MAX}) {
        EXPECT_NE(outcome(with(v4, 32 + 16 * stream, size)), "read");
        EXPECT_NE(outcome(with(v4, 40 + 16 * stream, size)), "read");
      }
    }
    std::string v3;
    for (const std::uint32_t word : {0x5053474eu, 3u, count, 12u << 8}) put(v3, word);
    expect_refused(gzip(v3 + std::string(1000, '\0')), {"positions", "truncated"});
    const std::string ksplat = content("ksplat/scene.level1.sh2.ksplat");
    for (const std::size_t at : {4096, 4100, 4104, 4108, 4120, 4128, 4132}) outcome(with(ksplat, at, count));
    expect_refused(with(with(ksplat, 4096, count), 4100, count), {"Gaussians"});
    EXPECT_NE(outcome(with(ksplat, 4132, count)), "read");
  }
}

// A hundred million zeros in a few bytes.
TEST_F(FormatsHostile, Bombs) {
  const std::string zeros(100'000'000, '\0');
  expect_refused(gzip(zeros), {"packed in", "at most 32 times"});
  expect_refused(zip({{"meta.json", zeros}}, true), {"meta.json", "at most 32 times"});
  std::string v4;  // 2^30 Gaussians in streams of nothing
  for (const std::uint32_t word : {0x5053474eu, 4u, 1u << 30, 0x05000c00u, 32u, 0u, 0u, 0u}) put(v4, word);
  for (const std::uint64_t stride : {9, 1, 3, 3, 4}) put<std::uint64_t>(v4, 20), put(v4, stride << 30);
  expect_refused(v4 + std::string(100, '\0'), {"at most 32 times"});
  // Textures: far larger than the Gaussians need; as large as a count that the files cannot hold.
  const ScratchFolder folder;
  std::filesystem::copy(own_sog(), folder / "", std::filesystem::copy_options::recursive);
  folder.write("quats.webp", webp(2000, 1000, std::vector<std::uint8_t>(8'000'000, 255)));
  const std::string meta = content(own_sog() / "meta.json");
  expect_refused(meta, {"quats.webp", "2000 x 1000 texels"}, folder / "");
  expect_refused(replaced(meta, "\"count\":1424", "\"count\":2000000"), {"count", "at most 32 times"}, folder / "");
}

TEST_F(FormatsHostile, WhatIsNoScene) {
  expect_refused("", {"an empty file", "expected a scene"});
  expect_refused("PNG and more", {"'PNG and more'", "expected a scene"});
  expect_refused("ply", {"header"});
  expect_refused("{}", {"means", "expected a scene"});
  expect_refused("{\"means\": {}", {"not JSON"});
  expect_refused(gzip("no"), {"'no'", "expected a scene"});
  expect_refused(gzip(std::string(100, 'x')), {"'xxxxxxxx", "expected a scene"});
  expect_refused("\x1f\x8b\x08zzzz", {"gzip", "damaged"});
  expect_refused("PK\x03\x04 no archive", {"zip archive"});
  expect_refused(zip({{"other.json", "{}"}}), {"found no 'meta.json'"});
  expect_refused("glTF", {"header"});
  expect_refused(std::string(4096, '\0'), {"expected a scene"});
  expect_refused(std::string(64, '\xff'), {"expected a scene"});
  EXPECT_EQ(outcome(content("spz/scene.v4.st.spz") + "x"), "read");  // with a note
  expect_refused(with(content("spz/scene.v4.st.spz"), 4, 5u), {"version 5"});
  expect_refused(with(content("gltf/scene.glb"), 4, 1u), {"glTF version 1"});
}

// Only files below the folder of the one that names them.
TEST_F(FormatsHostile, NamesOfOtherFiles) {
  const std::string meta = content(own_sog() / "meta.json");
  for (const char* name : {"../sog/quats.webp", "/etc/passwd", "a/../../b", "http://a/b", "", "a:b"})
    expect_refused(replaced(meta, "quats.webp", name), {"below the same folder"}, own_sog());
  expect_refused(replaced(meta, "quats.webp", "nothing.webp"), {"no file"}, own_sog());
  expect_refused(replaced(meta, "quats.webp", "."), {"a folder"}, own_sog());
  expect_refused(meta, {"does not lie beside it"});
  const std::string lod = content(own_streamed() / "lod-meta.json");
  expect_refused(replaced(lod, "1_0/meta.json", "./0_0//meta.json"), {"filenames", "each file once"}, own_streamed());
  const std::string once = R"("lods":{"0":{"file":1,"offset":0,"count":1424},"1":{"file":0,"offset":0,"count":1060}}})";
  expect_refused(replaced(lod, once, R"("children":[{"lods":{"0":{"file":1,"offset":0,"count":9}}},
                                                    {"lods":{"0":{"file":1,"offset":8,"count":9}}}]})"),
                 {"named once"}, own_streamed());
}

// Twenty accessors on the same bytes; a buffer that is named a thousand times.
TEST_F(FormatsHostile, BytesOfGltfCountOnce) {
  const int count = 60000;
  const std::string names[] = {"POSITION", "KHR_gaussian_splatting:SCALE", "KHR_gaussian_splatting:ROTATION",
                               "KHR_gaussian_splatting:OPACITY"};
  const auto gltf = [&](int buffers, int used) {
    std::string attributes, all = R"({"uri":"a.bin"})";
    for (int k = 0; k < 4; ++k) attributes += "\"" + names[k] + "\":" + (k < 2 ? "0" : k == 2 ? "1" : "2") + ",";
    for (int l = 0; l < 4; ++l) {
      for (int n = 0; n <= 2 * l; ++n)
        attributes +=
            "\"KHR_gaussian_splatting:SH_DEGREE_" + std::to_string(l) + "_COEF_" + std::to_string(n) + "\":0,";
    }
    attributes.pop_back();
    for (int i = 1; i < buffers; ++i) all += R"(,{"uri":"./a.bin"})";
    const auto accessor = [&](const char* type, int view) {
      return R"({"bufferView":)" + std::to_string(view) + R"(,"componentType":5121,"normalized":true,"count":)" +
             std::to_string(count) + R"(,"type":")" + type + "\"}";
    };
    return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"buffers":[)" + all +
           R"(],"bufferViews":[{"buffer":0,"byteLength":)" + std::to_string(4 * count) + R"(},{"buffer":)" +
           std::to_string(used) + R"(,"byteLength":)" + std::to_string(4 * count) + R"(}],"accessors":[)" +
           accessor("VEC3", 0) + "," + accessor("VEC4", 1) + "," + accessor("SCALAR", 0) +
           R"(],"meshes":[{"primitives":[{"extensions":{"KHR_gaussian_splatting":{}},"attributes":{)" + attributes +
           "}}]}]}";
  };
  const ScratchFolder folder;
  folder.write("a.bin", std::string(4 * count, '\x7f'));
  expect_refused(gltf(1, 0), {"attributes", "at most 32 times"}, folder / "");
  expect_refused(gltf(1000, 999), {"attributes", "at most 32 times"}, folder / "");
}

// Numbers of one byte in a view that holds as many of four, which nothing else uses.
TEST_F(FormatsHostile, AComponentTypeThatItsDataContradict) {
  const std::string glb = content("gltf/scene.sh1.glb");
  ASSERT_NE(glb.find("\"componentType\":5126"), std::string::npos);
  expect_refused(changed_glb("gltf/scene.sh1.glb", "\"componentType\":5126", "\"componentType\":5121"),
                 {"accessors[0].componentType", "found '5121'", "4 bytes a number"});
}

// Methods that are not understood, files that are encrypted, pictures that move.
TEST_F(FormatsHostile, WhatIsPackedInAnotherWay) {
  const std::string archive = zip({{"meta.json", "{}"}});
  const std::size_t entry = archive.find("PK\x01\x02");
  expect_refused(with<std::uint16_t>(archive, entry + 10, 9), {"'meta.json'", "compression method 9"});
  expect_refused(with<std::uint16_t>(archive, entry + 10, 99), {"compression method 99"});
  expect_refused(with<std::uint16_t>(archive, entry + 8, 1), {"'meta.json'", "encrypted"});
  const ScratchFolder folder;
  std::filesystem::copy(own_sog(), folder / "", std::filesystem::copy_options::recursive);
  std::string moving = "WEBPVP8X";
  put<std::uint32_t>(moving, 10), put<std::uint32_t>(moving, 2);
  moving += std::string("\x3f\0\0\x3f\0\0", 6) + "ANIM";
  put<std::uint32_t>(moving, 6), put<std::uint32_t>(moving, 0), put<std::uint16_t>(moving, 0);
  std::string riff = "RIFF";
  put(riff, static_cast<std::uint32_t>(moving.size()));
  folder.write("quats.webp", riff + moving);
  expect_refused(content(own_sog() / "meta.json"), {"quats.webp", "animated WebP"}, folder / "");
}

TEST_F(FormatsHostile, GltfThatGoesInCircles) {
  const auto changed = [](const std::string& from, const std::string& to) {
    return changed_glb("gltf/scene.spz2.glb", from, to);
  };
  ASSERT_EQ(outcome(changed("\"nodes\":[{", "\"nodes\":[{ ")), "read");
  expect_refused(changed("{\"mesh\":0}", "{\"mesh\":0,\"children\":[0]}"), {"nodes[0]", "one parent"});
  expect_refused(changed("{\"mesh\":0}", "{\"mesh\":7}"), {"meshes"});
  expect_refused(changed("{\"mesh\":0}", "{\"mesh\":0,\"scale\":[1,2,1]}"), {"nodes[0]", "rotation"});
  expect_refused(changed("{\"mesh\":0}", "{}"), {"without a primitive"});
  expect_refused(changed("\"extensionsRequired\":[", "\"extensionsRequired\":[\"EXT_meshopt_compression\","),
                 {"extensionsRequired[0]", "EXT_meshopt_compression"});
  expect_refused(changed("\"byteOffset\":0", "\"byteOffset\":9000000000000000000"), {"bufferViews[0]", "truncated"});
  // No rotation, one that overflows, one that is far from a length of 1.
  for (const char* rotation : {"[0,0,0,0]", "[1e300,0,0,1e300]", "[0,1e-200,0,0]", "[0,0,0,3]"})
    expect_refused(changed("{\"mesh\":0}", std::string("{\"mesh\":0,\"rotation\":") + rotation + "}"),
                   {"nodes[0].rotation", "a quaternion of length 1"});
  EXPECT_EQ(outcome(changed("{\"mesh\":0}", "{\"mesh\":0,\"rotation\":[0,0,0,1.01]}")), "read");
  // A mesh that is used a thousand times.
  std::string nodes = "\"nodes\":[{\"children\":[1";
  for (int i = 2; i < 1000; ++i) nodes += "," + std::to_string(i);
  nodes += "]}";
  for (int i = 1; i < 1000; ++i) nodes += ",{\"mesh\":0}";
  expect_refused(changed("\"nodes\":[{\"mesh\":0}", nodes), {"at most 32 times"});
}

}  // namespace
}  // namespace pipegs
