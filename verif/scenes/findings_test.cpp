// SPDX-License-Identifier: Apache-2.0
// Against scenes/check and the readers: every kind of finding is found in a file that has it, and in no plain one; what
// is refused says what the file is; docs/your_scene.md has a row for each kind and for each refusal, and no others.
//
// Idea    A case is a key and a file that a program of another writes so, made here. The values that were mended are
//         held against those of a file that has them in the right form.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <random>
#include <set>

#include "scenes/cameras/forms.hpp"
#include "scenes/check/finding.hpp"
#include "scenes/check/scene_check.hpp"
#include "scenes/check/view_check.hpp"
#include "scenes/colmap/colmap.hpp"
#include "scenes/formats/read_scene.hpp"
#include "scenes/ply/ply.hpp"
#include "verif/formats/packed_bytes.hpp"
#include "verif/scenes/ply_file.hpp"
#include "verif/scenes/refused.hpp"
#include "verif/scenes/scratch_folder.hpp"
#include "verif/support/draws.hpp"

namespace pipegs {
namespace {

constexpr std::size_t kCount = 40;

// Forty Gaussians about (0, 0, 4), as a trained scene has them.
std::vector<Column> trained(const std::string& type = "float") {
  std::mt19937_64 random(3);
  std::vector<Column> columns;
  const auto add = [&](const std::string& name, double low, double high, const std::string& of) {
    Column column{name, of, {}};
    for (std::size_t i = 0; i < kCount; ++i)
      column.values.push_back(static_cast<float>(draw_uniform(random, low, high)));
    columns.push_back(column);
  };
  add("x", -1.5, 1.5, type), add("y", -1, 1, type), add("z", 3, 5, type);
  for (const char* name : {"f_dc_0", "f_dc_1", "f_dc_2"}) add(name, -1.7, 1.7, "float");
  add("opacity", -1, 3, "float");
  for (const char* name : {"scale_0", "scale_1", "scale_2"}) add(name, -4, -2, "float");
  add("rot_0", 0.7, 1, "float");
  for (const char* name : {"rot_1", "rot_2", "rot_3"}) add(name, -0.5, 0.5, "float");
  return columns;
}

Column& column(std::vector<Column>& columns, const std::string& name) {
  for (Column& one : columns) {
    if (one.name == name) return one;
  }
  throw std::logic_error(name);
}

void change(std::vector<Column>& columns, const std::vector<std::string>& names,
            const std::function<double(double)>& to) {
  for (const std::string& name : names) {
    for (double& value : column(columns, name).values) value = to(value);
  }
}

void rename(std::vector<Column>& columns, const std::string& from, const std::string& to,
            const std::string& type = "float") {
  Column& one = column(columns, from);
  one.name = to;
  one.type = type;
}

void drop(std::vector<Column>& columns, const std::string& name) {
  std::erase_if(columns, [&](const Column& one) { return one.name == name; });
}

const std::vector<std::string> kColors = {"f_dc_0", "f_dc_1", "f_dc_2"}, kScales = {"scale_0", "scale_1", "scale_2"},
                               kMeans = {"x", "y", "z"};

struct Read {
  Scene scene;
  SceneFormat format;
  Findings findings;  // of reader and check

  bool has(std::string_view key) const {
    return std::any_of(findings.begin(), findings.end(), [&](const Finding& f) { return f.kind->key == key; });
  }
};

Read read_bytes(const std::string& bytes) {
  Read read;
  read.scene = read_scene(InputFile("a", bytes), {}, read.format);
  read.findings = read.format.findings;
  const Findings whole = check_scene(read.scene);
  read.findings.insert(read.findings.end(), whole.begin(), whole.end());
  return read;
}

Read read_ply_of(const std::vector<Column>& columns, const PlyText& text = {}) {
  return read_bytes(text.build(columns));
}

std::string splat_of(std::size_t count) {
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i) {
    for (const float v : {0.1f * static_cast<float>(i), 0.2f, 4.0f, 0.1f, 0.05f, 0.02f})
      append_value(bytes, "float", v, false);
    bytes += std::string("\x80\x40\xff\xc8", 4) + std::string("\xff\x80\x80\x80", 4);
  }
  return bytes;
}

std::string spz_of(std::uint32_t version, const std::string& tail = "") {
  std::string bytes = "NGSP";
  append_value(bytes, "uint", version, false);
  append_value(bytes, "uint", 1, false);
  bytes += std::string("\0\x0c\0\0", 4) + std::string(9, '\1') + "\x80" + "\x80\x80\x80" + "\x70\x70\x70" +
           std::string(version == 2 ? 3 : 4, '\x7f');
  return bytes + tail;
}

// The files of a SOG of one Gaussian; one of its textures may be packed with losses.
std::vector<std::pair<std::string, std::string>> sog_of(bool lossy, const std::string& folder = "") {
  const std::vector<std::uint8_t> texel = {128, 128, 128, 255};
  std::string codebook = "[-3";
  for (int i = 1; i < 256; ++i) codebook += ",-3";
  codebook += "]";
  return {{folder + "meta.json", R"({"version": 2, "count": 1, "shN": null, "means": {"mins": [-1, -1, -1], "maxs":
          [1, 1, 1], "files": ["a.webp", "a.webp"]}, "scales": {"codebook": )" +
                                     codebook +
                                     R"(, "files": ["b.webp"]}, "quats": {"files": ["a.webp"]}, "sh0": {"codebook": )" +
                                     codebook + R"(, "files": ["a.webp"]}})"},
          {folder + "a.webp", webp(1, 1, texel)},
          {folder + "b.webp", webp(1, 1, texel, !lossy)}};
}

// A glTF of Gaussians at (1, 2, 3), one for each opacity, in a node with this matrix.
std::string gltf_of_opacities(const std::vector<float>& opacities, std::vector<float> scale = {0.1f, 0.2f, 0.1f},
                              const std::string& node = R"({"mesh": 0})",
                              const std::string& space = "srgb_rec709_display") {
  std::string data;
  const std::size_t count = opacities.size();
  const auto put = [&](const std::vector<float>& values) {
    for (std::size_t i = 0; i < count; ++i)
      for (const float v : values) append_value(data, "float", v, false);
  };
  put({1, 2, 3}), put({0, 0, 0, 1}), put(scale);
  for (const float opacity : opacities) append_value(data, "float", opacity, false);
  put({0.5, 0.1, -0.2f});
  std::string views, accessors;
  std::size_t at = 0;
  for (const auto& [floats, type] : {std::pair{3, "VEC3"}, {4, "VEC4"}, {3, "VEC3"}, {1, "SCALAR"}, {3, "VEC3"}}) {
    const std::string comma = views.empty() ? "" : ",";
    views += comma + fmt::format(R"({{"buffer": 0, "byteOffset": {}, "byteLength": {}}})", at,
                                 4 * static_cast<std::size_t>(floats) * count);
    accessors += comma + fmt::format(R"({{"bufferView": {}, "componentType": 5126, "count": {}, "type": "{}"}})",
                                     std::count(views.begin(), views.end(), '{') - 1, count, type);
    at += 4 * static_cast<std::size_t>(floats) * count;
  }
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [)" + node +
         R"(], "meshes": [{"primitives": [{"mode": 0, "attributes": {"POSITION": 0,
         "KHR_gaussian_splatting:ROTATION": 1, "KHR_gaussian_splatting:SCALE": 2, "KHR_gaussian_splatting:OPACITY": 3,
         "KHR_gaussian_splatting:SH_DEGREE_0_COEF_0": 4}, "extensions": {"KHR_gaussian_splatting":
         {"kernel": "ellipse", "colorSpace": ")" +
         space + R"("}}}]}], "accessors": [)" + accessors + R"(], "bufferViews": [)" + views +
         fmt::format(R"(], "buffers": [{{"byteLength": {}, "uri":
         "data:application/octet-stream;base64,{}"}}]}})",
                     data.size(), base64(data));
}

std::string gltf_of(const std::vector<float>& scale, float opacity, const std::string& node = R"({"mesh": 0})",
                    const std::string& space = "srgb_rec709_display") {
  return gltf_of_opacities({opacity}, scale, node, space);
}

// A library: nodes and no scene that has them.
std::string gltf_without_scenes() {
  return replaced(gltf_of({0.1f, 0.2f, 0.1f}, 0.5, R"({"children": [1], "translation": [1, 0, 0]}, {"mesh": 0})"),
                  R"("scene": 0, "scenes": [{"nodes": [0]}], )", "");
}

Camera camera_at(const glm::dvec3& position) {
  Camera camera;
  camera.name = "a";
  camera.width = 64, camera.height = 48;
  camera.position = position;
  camera.fx = camera.fy = 60;
  camera.cx = 31.5, camera.cy = 23.5;
  return camera;
}

// A folder of photographs: ten cameras that look at a few points; the photographs are empty files.
struct Model {
  std::string lenses = "1 PINHOLE 160 120 140 140 80 60\n", points, slash = "/", ending = ".png", between = "\n";
  std::string before, inside = "sub", stem = "p_", model_ending = ".png";  // of names in images.txt
  std::string mark;                                                        // UTF-8's, before texts
  ScratchFolder folder;

  Findings read(ColmapFolder* out = nullptr) {
    for (const char* inside : {"images/sub", "sparse/0"}) std::filesystem::create_directories(folder / inside);
    std::string images;
    for (int i = 0; i < 10; ++i) {
      images += fmt::format("{} 1 0 0 0 {} 0 0 1 {}{}{}{}{}{}\n{}", i + 1, 0.1 * i, before, inside, slash, stem, i,
                            model_ending, between);
      folder.write(fmt::format("images/sub/{}{}{}", stem, i, ending), "");
    }
    folder.write("sparse/0/cameras.txt", mark + lenses);
    folder.write("sparse/0/images.txt", mark + images);
    if (points.empty()) {
      std::string text;
      for (int i = 0; i < 20; ++i) text += fmt::format("{} {} {} 4 10 20 30 0.5\n", i + 1, 0.1 * i, 0.05 * i);
      folder.write("sparse/0/points3D.txt", mark + text);
    }
    Findings findings;
    const ColmapFolder found = read_colmap(folder / "", false, findings);
    EXPECT_EQ(found.cameras.size(), 10u);
    if (out != nullptr) *out = found;
    return findings;
  }
};

constexpr const char* kFrame = R"("w": 160, "h": 120, "fl_x": 140, "fl_y": 140, "frames": [{"file_path": "images/1.png",
  "transform_matrix": [[1,0,0,2],[0,0,-1,3],[0,1,0,4],[0,0,0,1]]}])";

Findings cameras_of(const std::map<std::string, std::string>& files, std::vector<Camera>* out = nullptr) {
  const ScratchFolder scratch;
  std::filesystem::path named;
  for (const auto& [name, text] : files) {
    const std::filesystem::path path = scratch.write(name, text);
    if (named.empty()) named = path;  // the first by name
  }
  Findings findings;
  const std::vector<Camera> cameras = read_cameras(named, {}, findings);
  if (out != nullptr) *out = cameras;
  return findings;
}

// Of each key a file that has it.
std::map<std::string, std::function<Findings()>> cases() {
  std::map<std::string, std::function<Findings()>> all;
  const auto of_ply = [&](const char* key, const std::function<void(std::vector<Column>&)>& damage) {
    all[key] = [damage] {
      std::vector<Column> columns = trained();
      damage(columns);
      return read_ply_of(columns).findings;
    };
  };
  const auto set = [](const char* name, double value, bool every = false) {
    return [=](std::vector<Column>& columns) {
      for (std::size_t i = 0; i < kCount; ++i)
        if (every || i == 7) column(columns, name).values[i] = value;
    };
  };
  of_ply("non_finite", set("y", std::nan("")));
  of_ply("nothing_usable", set("y", std::nan(""), true));
  of_ply("zero_rotation", [](auto& c) {
    for (const char* name : {"rot_0", "rot_1", "rot_2", "rot_3"}) column(c, name).values[3] = 0;
  });
  of_ply("rotation_length", [](auto&) {});
  of_ply("faint", set("opacity", -9));
  of_ply("all_faint", set("opacity", -9, true));
  of_ply("needle", set("scale_1", -16));
  of_ply("large", set("scale_1", 4));
  of_ply("scale_form", [](auto& c) { change(c, kScales, [](double v) { return std::exp(v); }); });
  of_ply("opacity_form", [](auto& c) { change(c, {"opacity"}, [](double v) { return 1 / (1 + std::exp(-v)); }); });
  of_ply("color_form", [](auto& c) { change(c, kColors, [](double v) { return 0.5 + v / 4; }); });
  of_ply("rotation_form", [](auto& c) { std::swap(column(c, "rot_0").values, column(c, "rot_3").values); });
  of_ply("far_away", [](auto& c) { change(c, {"x"}, [](double v) { return v + 446000; }); });
  of_ply("rgb_colors", [](auto& c) {
    for (const auto& [from, to] : {std::pair{"f_dc_0", "red"}, {"f_dc_1", "green"}, {"f_dc_2", "blue"}}) {
      change(c, {from}, [](double v) { return std::round(100 + 50 * v); });
      rename(c, from, to, "uchar");
    }
  });
  of_ply("opacity_codes", [](auto& c) {
    change(c, {"opacity"}, [](double v) { return std::round(100 + 50 * v); });
    rename(c, "opacity", "alpha", "uchar");
  });
  of_ply("one_scale", [](auto& c) { drop(c, "scale_1"), drop(c, "scale_2"); });
  of_ply("other_names", [](auto& c) {
    rename(c, "scale_0", "scaling_0"), rename(c, "scale_1", "scaling_1"), rename(c, "scale_2", "scaling_2");
  });
  of_ply("not_read", [](auto& c) { c.push_back({"beta", "float", std::vector<double>(kCount, 0.5)}); });
  of_ply("filter_3d", [](auto& c) { c.push_back({"filter_3D", "float", std::vector<double>(kCount, 0.1)}); });
  of_ply("sh_degree", [](auto& c) {
    for (int i = 0; i < 72; ++i)
      c.push_back({fmt::format("f_rest_{}", i), "float", std::vector<double>(kCount, 0.01 * i)});
  });
  all["no_gaussian"] = [] { return check_scene(Scene{}); };
  all["behind_end"] = [] { return read_bytes(PlyText{}.build(trained()) + "\n").findings; };
  all["origin"] = [] {
    std::vector<Column> columns = trained("double");
    change(columns, {"x"}, [](double v) { return v + 446000; });
    return read_ply_of(columns).findings;
  };
  all["other_elements"] = [] {
    PlyText text;
    text.elements_after = "element delta_vertex_0 1\nproperty uchar x\n";
    text.body_after = std::string(1, '\0');
    return read_ply_of(trained(), text).findings;
  };
  all["zip_around"] = [] {
    return read_bytes(zip({{"__MACOSX/._a.ply", "x"}, {"a.ply", PlyText{}.build(trained())}})).findings;
  };
  all["guessed"] = [] {
    std::mt19937_64 random(5);
    std::string floats;
    for (int i = 0; i < 800; ++i) append_value(floats, "float", draw_uniform(random, 0.01, 1), false);
    return read_bytes(floats).findings;
  };
  all["lossy_texture"] = [] { return read_bytes(zip(sog_of(true))).findings; };
  all["gzip_missing"] = [] { return read_bytes(spz_of(2)).findings; };
  all["gzip_around"] = [] { return read_bytes(gzip(PlyText{}.build(trained()))).findings; };
  all["axes_unknown"] = [] { return read_bytes(gzip(spz_of(3))).findings; };
  all["log_scales"] = [] { return read_bytes(gltf_of({-2, -3, -2}, 0.5)).findings; };
  all["logit_opacities"] = [] { return read_bytes(gltf_of({0.1f, 0.2f, 0.1f}, -2)).findings; };
  all["linear_colors"] = [] {
    return read_bytes(gltf_of({0.1f, 0.2f, 0.1f}, 0.5, R"({"mesh": 0})", "lin_rec709_display")).findings;
  };
  const auto seen = [](const glm::dvec3& position, double near) {
    const Scene scene = read_ply_of(trained()).scene;
    const Camera camera = camera_at(position);
    return check_views(scene, {&camera, 1}, near);
  };
  all["empty_view"] = [=] { return seen({0, 0, 0}, 50); };
  all["near_plane"] = [=] { return seen({0, 0, 0}, 4); };
  all["applied_scale"] = [] { return cameras_of({{"a.json", std::string("{\"applied_scale\": 2, ") + kFrame + "}"}}); };
  all["nerfstudio_export"] = [] {
    return cameras_of(
        {{"a.json", std::string("{") + kFrame + "}"},
         {"dataparser_transforms.json", R"({"transform": [[1,0,0,1],[0,1,0,0],[0,0,1,0]], "scale": 0.5})"}});
  };
  all["exported_poses"] = [] {
    return cameras_of({{"a.json", R"([{"file_path": "images/1.png", "transform": [[1,0,0,0],[0,1,0,0],[0,0,1,0]]}])"},
                       {"transforms.json", std::string("{") + kFrame + "}"}});
  };
  all["no_scene"] = [] { return read_bytes(gltf_without_scenes()).findings; };
  all["camera_folder"] = [] {
    const ScratchFolder scratch;
    scratch.write("transforms.json", std::string("{") + kFrame + "}");
    Findings findings;
    read_cameras(scratch / "", {}, findings);
    return findings;
  };
  all["unused_lens"] = [] {
    Model model;
    model.lenses += "2 OPENCV_FISHEYE 160 120 140 140 80 60 0 0 0 0\n";
    return model.read();
  };
  all["no_2d_points"] = [] {
    Model model;
    model.between = "";
    return model.read();
  };
  all["backslashes"] = [] {
    Model model;
    model.slash = "\\";
    return model.read();
  };
  all["whole_paths"] = [] {
    Model model;
    model.before = "C:\\data\\images\\";
    return model.read();
  };
  all["other_ending"] = [] {
    Model model;
    model.ending = ".jpg";
    return model.read();
  };
  all["ply_points"] = [] {
    Model model;
    model.points = "ply";
    std::filesystem::create_directories(model.folder / "sparse/0");
    std::vector<Column> columns = trained("double");
    std::erase_if(columns, [](const Column& one) { return one.name.size() > 1; });
    for (const char* name : {"red", "green", "blue"})
      columns.push_back({name, "uchar", std::vector<double>(kCount, 9)});
    model.folder.write("sparse/0/points3D.ply", PlyText{}.build(columns));
    return model.read();
  };
  all["more_photographs"] = [] {
    Model model;
    std::filesystem::create_directories(model.folder / "images");
    model.folder.write("images/other.png", "");
    return model.read();
  };
  all["test_list"] = [] {
    Model model;
    std::filesystem::create_directories(model.folder / "sparse/0");
    model.folder.write("sparse/0/test.txt", "sub/p_3.png\np_5\n");
    ColmapFolder folder;
    const Findings findings = model.read(&folder);
    EXPECT_EQ(folder.held_out, (std::vector<std::string>{"sub/p_3.png", "sub/p_5.png"}));
    return findings;
  };
  return all;
}

// Those of a frame and of photographs, and of what is written: tests frame_check, photographs and field.
const std::set<std::string_view> kElsewhere = {
    "empty_frame",           "left_out",         "turned_photographs",  "resized_photographs",
    "converted_photographs", "deep_photographs", "gamma_photographs",   "profiled_photographs",
    "near_chosen",           "not_written",      "unturned_photographs"};

TEST(Findings, EachIsFoundAndAPlainFileHasNone) {
  const Read plain = read_ply_of(trained());
  for (const Finding& finding : plain.findings) EXPECT_FALSE(finding.kind->told) << finding_line(finding);
  Model model;
  EXPECT_TRUE(model.read().empty());
  const auto all = cases();
  for (const auto& [name, find] : all) {
    const std::string& key = name;
    SCOPED_TRACE(key);
    const Findings findings = find();
    EXPECT_TRUE(std::any_of(findings.begin(), findings.end(), [&](const Finding& f) { return f.kind->key == key; }));
    for (const Finding& finding : findings) {
      EXPECT_EQ(finding_line(finding).find('\n'), std::string::npos);
      EXPECT_LE(finding_line(finding).size(), 300u);
    }
  }
  for (const FindingKind& kind : finding_kinds())
    EXPECT_NE(all.contains(std::string(kind.key)), kElsewhere.contains(kind.key)) << kind.key;
}

// What was mended is what is meant.
TEST(Findings, MendedValuesAreThoseMeant) {
  const Scene meant = read_ply_of(trained()).scene;
  const auto near = [](double a, double b, double by) { EXPECT_NEAR(a, b, by); };
  {  // 64 bits far away, and a comment that keeps what was subtracted
    std::vector<Column> columns = trained("double");
    change(columns, {"x"}, [](double v) { return v + 446000; });
    change(columns, {"y"}, [](double v) { return v - 5410000; });
    const Read read = read_ply_of(columns);
    EXPECT_EQ(read.format.origin.y, -5410000);
    std::ostringstream written;
    EXPECT_EQ(write_ply(written, read.scene, read.format.origin), 0u);
    const Read again = read_bytes(written.str());
    EXPECT_EQ(again.format.origin, read.format.origin);
    for (std::size_t i = 0; i < kCount; ++i) {
      for (int k = 0; k < 2; ++k)
        near(read.scene.gaussians[i].mean[k] + read.format.origin[k],
             value_of(columns, kMeans[static_cast<std::size_t>(k)], i), 1e-6);
      EXPECT_EQ(again.scene.gaussians[i].mean, read.scene.gaussians[i].mean);
    }
    EXPECT_TRUE(read.format.fields[0].second.find("64 bits") != std::string::npos);
  }
  {  // near the origin doubles are as before
    const Read read = read_ply_of(trained("double"));
    EXPECT_EQ(read.format.origin, glm::dvec3(0));
    for (std::size_t i = 0; i < kCount; ++i) EXPECT_EQ(read.scene.gaussians[i].mean, meant.gaussians[i].mean);
  }
  {  // ECEF in a node's matrix
    const Read read = read_bytes(
        gltf_of({0.1f, 0.2f, 0.1f}, 0.5, R"({"mesh": 0, "translation": [4027893.25, 307045.5, 4919474.75]})"));
    const glm::dvec3 at = glm::dvec3(read.scene.gaussians[0].mean) + read.format.origin;  // LUF to RDF: x and y turn
    near(at.x, -4027894.25, 1e-6), near(at.y, -307047.5, 1e-6), near(at.z, 4919477.75, 1e-6);
  }
  {
    const Read logs = read_bytes(gltf_of({-2, -3, -2}, -2));
    near(logs.scene.gaussians[0].log_scale.y, -3, 1e-6);
    near(logs.scene.gaussians[0].opacity_logit, -2, 1e-6);
  }
  {  // SH of degree 4: the first 15 of each channel
    std::vector<Column> columns = trained();
    for (int i = 0; i < 72; ++i)
      columns.push_back({fmt::format("f_rest_{}", i), "float", std::vector<double>(kCount, i)});
    const Scene scene = read_ply_of(columns).scene;
    ASSERT_EQ(scene.sh_degree, 3);
    EXPECT_EQ(sh_rest_of(scene, 5)[0], 0);
    EXPECT_EQ(sh_rest_of(scene, 5)[1], 24);
    EXPECT_EQ(sh_rest_of(scene, 5)[3 * 14 + 2], 48 + 14);
  }
  {  // colours of 8 bits, 16 bits and floats are one
    std::vector<Scene> scenes;
    for (const auto& [type, range] : {std::pair{"uchar", 255.0}, {"ushort", 65535.0}, {"float", 1.0}}) {
      std::vector<Column> columns = trained();
      for (const auto& [from, to] : {std::pair{"f_dc_0", "red"}, {"f_dc_1", "green"}, {"f_dc_2", "blue"}}) {
        const double part = range / 255;
        change(columns, {from}, [&](double v) { return part * std::round(100 + 50 * v); });
        rename(columns, from, to, type);
      }
      scenes.push_back(read_ply_of(columns).scene);
    }
    for (std::size_t i = 0; i < kCount; ++i) {
      for (int k = 0; k < 3; ++k) {
        const double wanted = (std::round(100 + 50 * meant.gaussians[i].sh_dc[k]) / 255 - 0.5) / kShConstant;
        for (const Scene& scene : scenes) near(scene.gaussians[i].sh_dc[k], wanted, 1e-5);
      }
    }
  }
  for (const double value : {0.0, 0.3}) {  // f_dc of nothing but zeros beside colours, and others
    std::vector<Column> columns = trained();
    for (const char* name : {"red", "green", "blue"})
      columns.push_back({name, "uchar", std::vector<double>(kCount, 200)});
    change(columns, kColors, [&](double) { return value; });
    const Read read = read_ply_of(columns);
    EXPECT_EQ(read.has("rgb_colors"), value == 0);
    near(read.scene.gaussians[3].sh_dc.y, value == 0 ? (200 / 255.0 - 0.5) / kShConstant : value, 1e-6);
  }
  {  // Mip-Splatting
    std::vector<Column> columns = trained();
    columns.push_back({"filter_3D", "float", std::vector<double>(kCount, 0.1)});
    const Scene scene = read_ply_of(columns).scene;
    const Gaussian &g = scene.gaussians[4], &before = meant.gaussians[4];
    double kept = 1;
    for (int k = 0; k < 3; ++k) {
      const double squared = std::exp(2.0 * before.log_scale[k]);
      near(g.log_scale[k], 0.5 * std::log(squared + 0.01), 1e-5);
      kept *= squared / (squared + 0.01);
    }
    const auto alpha = [](double logit) { return 1 / (1 + std::exp(-logit)); };
    near(alpha(g.opacity_logit), alpha(before.opacity_logit) * std::sqrt(kept), 1e-6);
  }
  {  // other names for everything
    std::vector<Column> columns = trained();
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{{"f_dc_0", "sh0_0"},
                                                                                   {"f_dc_1", "sh0_1"},
                                                                                   {"f_dc_2", "sh0_2"},
                                                                                   {"scale_0", "scale_x"},
                                                                                   {"scale_1", "scale_y"},
                                                                                   {"scale_2", "scale_z"},
                                                                                   {"rot_0", "quat_w"},
                                                                                   {"rot_1", "quat_x"},
                                                                                   {"rot_2", "quat_y"},
                                                                                   {"rot_3", "quat_z"}})
      rename(columns, from, to);
    const Scene scene = read_ply_of(columns).scene;
    for (std::size_t i = 0; i < kCount; ++i) {
      EXPECT_EQ(scene.gaussians[i].rotation, meant.gaussians[i].rotation);
      EXPECT_EQ(scene.gaussians[i].log_scale, meant.gaussians[i].log_scale);
      EXPECT_EQ(scene.gaussians[i].sh_dc, meant.gaussians[i].sh_dc);
    }
  }
}

TEST(Findings, SplatsWithRowsThatAreNoNumbersAreRead) {
  std::string bytes = splat_of(20);
  const float none = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(bytes.data() + 32 * 3, &none, 4);
  std::memcpy(bytes.data() + 32 * 9 + 16, &none, 4);
  const Read read = read_bytes(bytes);
  EXPECT_EQ(read.scene.gaussians.size(), 20u);
  EXPECT_TRUE(read.has("non_finite"));
  EXPECT_TRUE(read_bytes(splat_of(20) + "cut").has("behind_end"));
  expect_one_line([] { read_bytes(std::string(640, '\xff')); }, {"expected a scene"});
}

// One of many that is out of its form is an error; all are another form.
TEST(Findings, FewOddValuesAreNoOtherForm) {
  std::string bytes = splat_of(60);
  const float odd = -1e-6f;
  std::memcpy(bytes.data() + 32 * 3 + 16, &odd, 4);
  const Read one = read_bytes(bytes);
  EXPECT_FALSE(one.has("log_scales"));
  EXPECT_TRUE(one.has("non_finite"));
  EXPECT_NEAR(one.scene.gaussians[0].log_scale.x, std::log(0.1), 1e-6);
  for (std::size_t i = 0; i < 6; ++i) std::memcpy(bytes.data() + 32 * i + 12, &odd, 4);
  EXPECT_TRUE(read_bytes(bytes).has("log_scales"));
  // Opacities of glTF, of which one is rounded up and one is no opacity.
  std::vector<float> opacities(60, 0.25f);
  opacities[3] = 1.0000001f;
  const Read rounded = read_bytes(gltf_of_opacities(opacities));
  EXPECT_FALSE(rounded.has("logit_opacities"));
  EXPECT_NEAR(rounded.scene.gaussians[0].opacity_logit, std::log(1.0 / 3), 1e-6);
  EXPECT_EQ(rounded.scene.gaussians[3].opacity_logit, 20);
  opacities[5] = 37;
  EXPECT_TRUE(read_bytes(gltf_of_opacities(opacities)).has("non_finite"));
}

// Forms that nearly all values show, whatever a few hold.
TEST(Findings, FormsAreSeenThroughOutliers) {
  const auto linear = [](double v) { return std::exp(v); };
  const auto share = [](double v) { return 1 / (1 + std::exp(-v)); };
  const auto has = [](const char* key, const std::function<void(std::vector<Column>&)>& damage) {
    std::vector<Column> columns;
    for (int i = 0; i < 3; ++i) {  // 120 Gaussians
      const std::vector<Column> more = trained();
      for (std::size_t c = 0; c < more.size(); ++c) {
        if (i == 0) columns.push_back(more[c]);
        else columns[c].values.insert(columns[c].values.end(), more[c].values.begin(), more[c].values.end());
      }
    }
    damage(columns);
    return read_ply_of(columns).has(key);
  };
  EXPECT_TRUE(has("scale_form", [&](auto& c) {  // flat ones
    change(c, kScales, linear);
    change(c, {"scale_2"}, [](double) { return 0; });
  }));
  EXPECT_TRUE(has("scale_form", [&](auto& c) {
    change(c, kScales, linear);
    column(c, "scale_1").values[7] = -1e-3;
  }));
  EXPECT_TRUE(has("opacity_form", [&](auto& c) {
    change(c, {"opacity"}, share);
    column(c, "opacity").values[7] = 1.0001;
  }));
  EXPECT_TRUE(has("opacity_form", [&](auto& c) { change(c, {"opacity"}, [](double) { return 1; }); }));
  EXPECT_TRUE(has("color_form", [&](auto& c) {
    change(c, kColors, [](double v) { return 0.5 + v / 4; });
    column(c, "f_dc_1").values[7] = 1.01;
  }));
  // z w x y
  EXPECT_TRUE(has("rotation_form", [&](auto& c) { std::swap(column(c, "rot_0").values, column(c, "rot_1").values); }));
}

// What is no .splat: text, whole numbers, files of other programs; what is one: with rows of zeros, any first bytes.
TEST(Findings, ASplatIsNoOtherFile) {
  std::string numbers, table, utf16 = "\xff\xfe";
  for (int i = 0; i < 400; ++i) append_value(numbers, "int", i, false);
  for (int i = 0; i < 40; ++i) table += "1.0 2.0 3.0\n";
  for (const char c : std::string("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n")) utf16 += {c, '\0'};
  for (const auto& [bytes, words] : std::vector<std::pair<std::string, std::string>>{
           {numbers, "1600 bytes that begin with"},
           {table, "a text that begins with '1.0 2.0 3.0?"},
           {"x,y,z\n" + table, "a text that begins with 'x,y,z?"},
           {"404: Not Found", "a text that begins with '404: Not Found'"},
           {utf16, "a text in UTF-16"},
           {"\n<!DOCTYPE HTML PUBLIC \"-//W3C\">", "a web page (HTML)"},
           {"<head><title>Sign in</title>", "a web page (HTML)"},
           {"<Error><Code>NoSuchKey</Code></Error>", "XML"},
           {std::string("BM\x36\x10\0\0\0\0\0\0\x36\0\0\0", 14), "a picture (BMP)"},
           {R"({"asset": {"version": "1.1"}, "geometricError": 1, "root": {}})", "a tileset of 3D Tiles"}})
    expect_one_line([&bytes = bytes] { read_bytes(bytes); }, {words}, words);
  EXPECT_EQ(read_bytes(splat_of(20) + std::string(320, '\0')).scene.gaussians.size(), 30u);
  for (const char* begin : {"PK\x01\x3f", "\x1f\x8b\x01\x3f"})
    EXPECT_EQ(read_bytes(begin + splat_of(20).substr(4)).scene.gaussians.size(), 20u) << begin;
}

TEST(Findings, MarksAndSecondPackings) {
  const std::string plain = PlyText{}.build(trained()), mark = "\xef\xbb\xbf";
  const Scene meant = read_bytes(plain).scene;
  for (const std::string& bytes : {mark + plain, "ply \n" + plain.substr(4), gzip(gzip(plain)),
                                   zip({{"folder/a.ply", plain}, {"folder/readme.txt", "x"}})})
    EXPECT_EQ(read_bytes(bytes).scene.gaussians[7].mean, meant.gaussians[7].mean);
  EXPECT_EQ(read_bytes(gzip(gzip(spz_of(3)))).scene.gaussians.size(), 1u);
  EXPECT_TRUE(read_bytes(mark + gltf_of({-2, -3, -2}, 0.5)).has("log_scales"));
  Model model;
  model.mark = mark;
  EXPECT_TRUE(model.read().empty());
  // An archive of Windows.
  const Read sog = read_bytes(zip(sog_of(false, "folder\\")));
  EXPECT_EQ(sog.scene.gaussians.size(), 1u);
  EXPECT_FALSE(sog.has("lossy_texture"));
  for (const auto& [texture, words] : {std::pair{"\x89PNG\r\n\x1a\n", "a picture (PNG)"},
                                       {"version https://git-lfs.github.com/spec/v1", "a Git LFS pointer"}}) {
    auto files = sog_of(false);
    files[1].second = texture;
    expect_one_line([&] { read_bytes(zip(files)); }, {words}, words);
  }
  expect_one_line([&] { cameras_of({{"a.json", std::string("\xff\xfe{\0\"\0w\0", 8)}}); }, {"UTF-16"});
  expect_one_line(
      [&] {
        cameras_of({{"a.json", std::string("{") + kFrame + "}"},
                    {"dataparser_transforms.json", "version https://git-lfs.github.com/spec/v1\n"}});
      },
      {"a Git LFS pointer"});
  EXPECT_NO_THROW(cameras_of({{"a.json", std::string("{\"k1\": null, \"camera_model\": null, ") + kFrame + "}"}}));
}

// Names of photographs that look like numbers are no 2D points, and a lens that bends nothing is a pinhole.
TEST(Findings, NoCameraIsLost) {
  for (const auto& [stem, ending] : {std::pair{"00", ""}, {"12 frame", ".png"}, {"3 4 ", ".png"}}) {
    Model model;
    model.between = "";
    model.inside = model.slash = "";
    model.stem = stem;
    model.model_ending = model.ending = ending;
    ColmapFolder folder;
    const Findings findings = model.read(&folder);
    EXPECT_EQ(folder.cameras.size(), 10u) << stem;
  }
  for (const char* lens : {"OPENCV 160 120 140 140 80 60 0 0 0 0", "SIMPLE_RADIAL 160 120 140 80 60 0"}) {
    Model model;
    model.lenses = std::string("1 ") + lens + "\n";
    EXPECT_TRUE(model.read().empty()) << lens;
  }
  expect_one_line([] { parse_colmap_lenses("cameras.txt", "1 OPENCV 160 120 140 140 80 60 0 0 0 1e-9\n"); },
                  {"image_undistorter, or --ignore-distortion"});
  // A photograph is no one's second.
  Model model;
  model.slash = "/other/";
  EXPECT_EQ(model.read().at(0).kind->key, "other_ending");
}

TEST(Findings, GltfSaysWhatIsNotRead) {
  const std::string plain = gltf_of({0.1f, 0.2f, 0.1f}, 0.5);
  EXPECT_FALSE(read_bytes(plain).has("not_read"));
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"\"ellipse\"", "\"box\""},
           {"srgb_rec709_display", "srgb_displayp3_display"},
           {R"({"mesh": 0})", R"({"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {}}})"},
           {R"("asset": )", R"("extensionsUsed": ["CESIUM_RTC"], "asset": )"},
           {R"("primitives": [)", R"("primitives": [{"mode": 4, "attributes": {}}, )"}})
    EXPECT_TRUE(read_bytes(replaced(plain, from, to)).has("not_read")) << to;
  for (const char* matrix : {"[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,2]", "[1,0,0,0.5, 0,1,0,0, 0,0,1,0, 0,0,0,1]"})
    expect_one_line(
        [&] {
          read_bytes(gltf_of({0.1f, 0.2f, 0.1f}, 0.5, std::string(R"({"mesh": 0, "matrix": )") + matrix + "}"));
        },
        {"0, 0, 0, 1 as its last row"});
  std::string flags = spz_of(2);
  flags[14] = '\x80';
  EXPECT_TRUE(read_bytes(flags).has("not_read"));
}

// Names of the extension's drafts, which may have colour and opacity in COLOR_0; nodes without a scene.
TEST(Findings, GltfOfDraftsAndLibraries) {
  std::string draft = gltf_of({0.1f, 0.2f, 0.1f}, 0.5);
  for (const auto& [from, to] : {std::pair{"KHR_gaussian_splatting:ROTATION", "_ROTATION"},
                                 {"KHR_gaussian_splatting:SCALE", "_SCALE"},
                                 {"KHR_gaussian_splatting:OPACITY\": 3", "COLOR_0\": 1"},
                                 {"KHR_gaussian_splatting:SH_DEGREE_0_COEF_0", "_SH_DEGREE_1_COEF_0"}})
    draft = replaced(draft, from, to);
  expect_one_line([&] { read_bytes(draft); }, {"_SH_DEGREE_1_COEF_1"});
  draft = replaced(draft, "_SH_DEGREE_1_COEF_0", "_UNKNOWN");
  const Read read = read_bytes(draft);
  EXPECT_TRUE(read.has("other_names"));
  EXPECT_FALSE(read.has("not_read"));
  const Gaussian& g = read.scene.gaussians.at(0);  // its COLOR_0 is 0, 0, 0, 1
  EXPECT_NEAR(g.log_scale.y, std::log(0.2), 1e-6);
  EXPECT_NEAR(g.sh_dc.x, -0.5 / kShConstant, 1e-6);
  EXPECT_EQ(g.opacity_logit, 20);
  EXPECT_TRUE(read_bytes(replaced(draft, R"("kernel")", R"("quantizedPositionScale": 2, "kernel")")).has("not_read"));
  std::string names = gltf_of({0.1f, 0.2f, 0.1f}, 0.5);
  for (const char* name : {"ROTATION", "SCALE", "OPACITY", "SH_DEGREE_0_COEF_0"})
    names = replaced(names, std::string("splatting:") + name, std::string("splatting:_") + name);
  const Read named = read_bytes(names);
  EXPECT_TRUE(named.has("other_names"));
  EXPECT_EQ(named.scene.gaussians.at(0).opacity_logit, 0);
  const Scene library = read_bytes(gltf_without_scenes()).scene;
  ASSERT_EQ(library.gaussians.size(), 1u);
  EXPECT_EQ(library.gaussians[0].mean, glm::vec3(-2, -2, 3));  // LUF to RDF
}

// Colours by their values where their type does not say the range, more names, whole numbers far away.
TEST(Findings, PropertiesOfMorePrograms) {
  const Scene meant = read_ply_of(trained()).scene;
  for (const auto& [type, range, names] : std::vector<std::tuple<const char*, double, std::array<const char*, 3>>>{
           {"float", 255, {"red", "green", "blue"}},
           {"int", 255, {"r", "g", "b"}},
           {"uchar", 255, {"color_r", "color_g", "color_b"}}}) {
    std::vector<Column> columns = trained();
    for (std::size_t k = 0; k < 3; ++k) {
      change(columns, {kColors[k]}, [&](double v) { return std::round(100 + 50 * v); });
      rename(columns, kColors[k], names[k], type);
    }
    const Scene scene = read_ply_of(columns).scene;
    for (std::size_t i = 0; i < kCount; ++i)
      EXPECT_NEAR(scene.gaussians[i].sh_dc[1],
                  (std::round(100 + 50 * meant.gaussians[i].sh_dc[1]) / range - 0.5) / kShConstant, 1e-5)
          << type;
  }
  std::vector<Column> columns = trained();
  for (const auto& [from, to] : {std::pair{"f_dc_0", "f_dc_r"},
                                 {"f_dc_1", "f_dc_g"},
                                 {"f_dc_2", "f_dc_b"},
                                 {"rot_0", "rot0"},
                                 {"rot_1", "rot1"},
                                 {"rot_2", "rot2"},
                                 {"rot_3", "rot3"}})
    rename(columns, from, to);
  EXPECT_EQ(read_ply_of(columns).scene.gaussians[9].rotation, meant.gaussians[9].rotation);
  columns = trained();
  rename(columns, "opacity", "density");
  expect_one_line([&] { read_ply_of(columns); }, {"opacity is missing", "found density"});
  columns = trained();
  change(columns, {"x"}, [](double v) { return std::round(1000 * v) + 446000000; });
  rename(columns, "x", "x", "int");
  const Read read = read_ply_of(columns);
  EXPECT_NEAR(read.scene.gaussians[4].mean.x + read.format.origin.x, value_of(columns, "x", 4), 1e-3);
}

TEST(Findings, WhatIsWrittenHoldsNumbersAlone) {
  Scene scene = read_ply_of(trained()).scene;
  const float infinite = std::numeric_limits<float>::infinity();
  scene.gaussians[1].mean.x = std::nanf("");
  scene.gaussians[2].log_scale.z = -infinite;
  scene.gaussians[3].opacity_logit = infinite;
  std::ostringstream written;
  EXPECT_EQ(write_ply(written, scene), 1u);
  const Scene again = read_bytes(written.str()).scene;
  ASSERT_EQ(again.gaussians.size(), kCount - 1);
  for (const Gaussian& g : again.gaussians) {
    for (int k = 0; k < 3; ++k) EXPECT_TRUE(std::isfinite(g.mean[k]) && std::isfinite(g.log_scale[k]));
    EXPECT_TRUE(std::isfinite(g.opacity_logit));
  }
  EXPECT_EQ(again.gaussians[2].opacity_logit, 20);
}

TEST(Findings, NerfstudiosFilesLeadToItsExport) {
  const std::string frame = std::string("{") + kFrame + "}";
  std::vector<Camera> plain, moved, path;
  cameras_of({{"a.json", frame}}, &plain);
  cameras_of({{"a.json", frame},
              {"dataparser_transforms.json", R"({"transform": [[0,-1,0,1],[1,0,0,0],[0,0,1,-2]], "scale": 0.5})"}},
             &moved);
  // 0.5 (T (2, 3, 4) + t), and the axes turn with it.
  EXPECT_EQ(moved[0].position, glm::dvec3(-1, 1, 1));
  EXPECT_NEAR(
      glm::length(moved[0].world_to_camera * glm::dvec3(0, 1, 0) - plain[0].world_to_camera * glm::dvec3(1, 0, 0)), 0,
      1e-12);
  cameras_of({{"c.json", R"({"render_width": 160, "render_height": 120, "camera_type": "perspective", "camera_path":
    [{"camera_to_world": [1,0,0,2, 0,0,-1,3, 0,1,0,4, 0,0,0,1], "fov": 50, "aspect": 1.3}]})"}},
             &path);
  EXPECT_EQ(path[0].position, plain[0].position);
  EXPECT_EQ(path[0].world_to_camera, plain[0].world_to_camera);
  EXPECT_NEAR(path[0].fy, 60 / std::tan(glm::radians(25.0)), 1e-9);
}

// Python's json.dump writes NaN: where nobody needs it it is nothing, elsewhere the line names it.
TEST(Findings, NumbersOfPython) {
  const std::string frame = std::string(kFrame), name = "images/NaN \\\" Infinity.png";
  std::vector<Camera> cameras;
  cameras_of(
      {{"a.json", R"({"aabb": [NaN, -Infinity, {"a": Infinity}], )" + replaced(frame, "images/1.png", name) + "}"}},
      &cameras);
  EXPECT_EQ(cameras.at(0).name, "images/NaN \" Infinity.png");
  expect_one_line(
      [&] {
        cameras_of({{"a.json", "{" + replaced(frame, "[1,0,0,2]", "[1,0,0,NaN]") + "}"}});
      },
      {"frames[0].transform_matrix[0][3]"});
}

struct Refusal {
  const char* words;  // of the line, as in the page
  std::function<void()> read;
};

std::vector<Refusal> refusals() {
  const auto scene = [](const std::string& bytes) { return [bytes] { read_bytes(bytes); }; };
  const auto camera = [](const std::string& text) { return [text] { cameras_of({{"c.json", text}}); }; };
  std::vector<Column> cloud = trained("double"), mesh;
  std::erase_if(cloud, [](const Column& one) { return one.name.size() > 1; });
  for (const char* name : {"red", "green", "blue"}) cloud.push_back({name, "uchar", std::vector<double>(kCount, 9)});
  mesh = cloud;
  PlyText faces;
  faces.elements_after = "element face 1\nproperty list uchar int vertex_indices\n";
  faces.body_after = std::string("\0", 1);
  std::vector<Column> anchors = trained();
  for (const char* name : {"f_offset_0", "f_anchor_feat_0"})
    anchors.push_back({name, "float", std::vector<double>(kCount, 0)});
  return {{"a Git LFS pointer", scene("version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 9\n")},
          {"a Git LFS pointer", camera("version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 9\n")},
          {"a web page (HTML)", scene("<!DOCTYPE html><html></html>")},
          {"an empty file", scene("")},
          {"an archive (7z)", scene("7z\xbc\xaf\x27\x1c and more")},
          {"a picture (PNG)", scene("\x89PNG\r\n\x1a\n and more")},
          {"a point cloud, not Gaussian splats", scene(PlyText{}.build(cloud))},
          {"a mesh, not Gaussian splats", scene(faces.build(mesh))},
          {"anchors of Scaffold-GS", scene(PlyText{}.build(anchors))},
          {"a file of cameras", scene(R"({"frames": []})")},
          {"take the distortion out with colmap image_undistorter",
           [] { parse_colmap_lenses("cameras.txt", "1 EUCM 160 120 140 140 80 60 0.5 1\n"); }},
          {"put the transforms.json of the photographs beside it",
           camera(R"([{"file_path": "1.png", "transform": [[1,0,0,0],[0,1,0,0],[0,0,1,0]]}])")},
          {"a camera of Polycam", camera(R"({"t_00": 1, "t_01": 0, "fx": 140, "fy": 140, "cx": 80, "cy": 60})")},
          {"a camera of Polycam",
           [] {
             const ScratchFolder scratch;
             std::filesystem::create_directories(scratch / "keyframes/corrected_cameras");
             read_cameras(scratch / "", {});
           }},
          {"the metadata of Record3D", camera(R"({"w": 160, "h": 120, "K": [140, 0, 0], "poses": [[0, 0, 0, 1]]})")},
          {"name transforms.json", camera(R"({"transform": [[1,0,0,0],[0,1,0,0],[0,0,1,0]], "scale": 1})")},
          {"a folder without lod-meta.json or meta.json", [] {
             const ScratchFolder scratch;
             std::filesystem::create_directories(scratch / "point_cloud/iteration_30000");
             scratch.write("point_cloud/iteration_30000/point_cloud.ply", "ply");
             read_scene(scratch / "");
           }}};
}

TEST(Findings, RefusalsSayWhatTheFileIs) {
  for (const Refusal& refused : refusals()) expect_one_line(refused.read, {refused.words}, refused.words);
  expect_one_line(refusals().back().read, {"iteration_30000/point_cloud.ply"});
}

TEST(Findings, ThePageHasARowForEach) {
  std::ifstream file(std::filesystem::path(PIPEGS_SOURCE_DIR) / "docs/your_scene.md");
  std::set<std::string> rows;
  std::string text;
  for (std::string line; std::getline(file, line);) {
    text += line + "\n";
    for (const char* severity : {"note", "warning", "error"}) {
      const std::string mark = fmt::format("` | {} | ", severity);
      if (line.starts_with("| `") && line.find(mark) != std::string::npos)
        rows.insert(line.substr(3, line.find('`', 3) - 3) + " " + severity);
    }
  }
  std::set<std::string> kinds;
  for (const FindingKind& kind : finding_kinds()) kinds.insert(fmt::format("{} {}", kind.key, name_of(kind.severity)));
  EXPECT_EQ(rows, kinds);
  for (const Refusal& refused : refusals()) EXPECT_NE(text.find(refused.words), std::string::npos) << refused.words;
}

}  // namespace
}  // namespace pipegs
