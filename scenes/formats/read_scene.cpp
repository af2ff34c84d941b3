// SPDX-License-Identifier: Apache-2.0
// read_scene: see read_scene.hpp.
#include "scenes/formats/read_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "scenes/formats/axes.hpp"
#include "scenes/input_error.hpp"
#include "scenes/packed/unpack.hpp"
#include "scenes/ply/ply.hpp"
#include "scenes/text/foreign.hpp"
#include "scenes/text/json.hpp"
#include "scenes/text/json_node.hpp"
#include "scenes/text/text_file.hpp"

namespace pipegs {
namespace {

constexpr std::array kEndings = {".ply", ".splat", ".ksplat", ".spz", ".sog", ".glb", ".gltf", ".xyzs"};
constexpr std::size_t kMostLooked = 10000;  // files of a folder
constexpr std::string_view kPly = "ply", kGzip = "\x1f\x8b\x08", kSpz = "NGSP", kGltf = "glTF", kXyzs = "xyzs ";

bool begins_with_ply(std::string_view text) { return without_mark(text).starts_with(kPly); }

Scene read_any_ply(PlySource& source, SceneFormat& format) {
  const PlyHeader header = read_ply_header(source);
  for (const PlyElement& element : header.elements) {
    const auto packed = [](const PlyProperty& property) { return property.name == "packed_position"; };
    if (element.name == "vertex" && std::any_of(element.properties.begin(), element.properties.end(), packed))
      return read_compressed_ply(source, header, format);
  }
  return read_ply(source, header, format);
}

// Not by two bytes, which also begin one of 65536 files of .splat.
bool is_zip(const InputFile& file) {
  return file.starts_with("PK\x03\x04") || file.starts_with("PK\x05\x06") || file.starts_with("PK\x07\x08");
}

bool looks_like_json(const InputFile& file) {
  const std::string_view text = without_mark(file.text());
  const std::size_t open = text.find_first_not_of(" \t\r\n");
  if (open == text.npos || text[open] != '{') return false;
  const std::size_t next = text.find_first_not_of(" \t\r\n", open + 1);
  return next != text.npos && (text[next] == '"' || text[next] == '}');
}

Scene read_json_scene(const InputFile& file, const ReadOptions& options, SceneFormat& format) {
  const JsonNode json = JsonNode::parse(file.name(), file.text());
  if (json.has("asset") && json.has("meshes")) return read_gltf(file, format);
  if (json.has("tree")) return read_streamed_sog(file, options.lod, format);
  if (json.has("means")) return read_sog(file, format);
  for (const char* key : {"frames", "camera_path", "animTracks", "poseSets", "cameras"}) {
    if (json.has(key))
      throw InputError(file.name(), "",
                       fmt::format("found a file of cameras ('{}'), expected a scene: --cameras takes it", key));
  }
  if (json.has("geometricError") || json.has("root"))
    throw InputError(file.name(), "", "found a tileset of 3D Tiles, expected a scene: name a .glb of it");
  throw InputError(file.name(), "",
                   "found JSON without 'means' (SOG), 'tree' (streamed SOG) or 'meshes' (glTF), expected a scene");
}

constexpr const char* kScenes =
    "a scene: .ply, .splat, .ksplat, .spz, .sog, meta.json, lod-meta.json, .glb, .gltf or .xyzs";

Scene read_untold(const InputFile& file, SceneFormat& format) {
  if (looks_like_ksplat(file)) return read_ksplat(file, format);
  refuse_foreign(file.name(), file.text(), kScenes);
  if (looks_like_splat(file)) return read_splat(file, format);
  if (file.text().starts_with("["))
    throw InputError(file.name(), "", "found a list of JSON, expected a scene: --cameras takes cameras");
  const std::string begin = file.text().substr(0, 512);
  const bool text = std::all_of(begin.begin(), begin.end(), is_printable);
  throw InputError(
      file.name(), "",
      fmt::format("found {} that begin{} with {}, expected {}", text ? "a text" : fmt::format("{} bytes", file.size()),
                  text ? "s" : "", quote(begin.substr(0, text ? 24 : 8)), kScenes));
}

// Those that have the ending of a scene, without what macOS puts beside each file.
std::vector<std::string> scenes_among(const std::vector<std::string>& names) {
  std::vector<std::string> found;
  for (const std::string& name : names) {
    const std::filesystem::path path(name);
    const bool beside = name.starts_with("__MACOSX/") || path.filename().string().starts_with("._");
    if (!beside && std::find(kEndings.begin(), kEndings.end(), path.extension().string()) != kEndings.end())
      found.push_back(name);
  }
  return found;
}

Scene read_packed(const InputFile& file, const ReadOptions& options, SceneFormat& format);

// The scene in an archive: a SOG, streamed or not, in it or in a folder of it.
Scene read_zip(const InputFile& file, const ReadOptions& options, SceneFormat& format) {
  const std::vector<std::string> names = zip_names(file);
  for (const char* meta : {"lod-meta.json", "meta.json"}) {
    const std::string* found = nullptr;
    for (const std::string& name : names) {
      const bool is = name == meta || name.ends_with(std::string("/") + meta);
      if (is && (found == nullptr || name.size() < found->size())) found = &name;
    }
    if (found == nullptr) continue;
    const InputFile inside = unpack_zip(file, *found);
    return read_json_scene(inside, options, format);
  }
  const std::vector<std::string> scenes = scenes_among(names);
  // What is packed itself may unpack to any size.
  if (scenes.size() == 1 && !scenes[0].ends_with(".sog")) {
    const InputFile inside = unpack_zip(file, scenes[0]);
    if (!is_zip(inside)) {
      format.findings.emplace_back("zip_around",
                                   fmt::format("the file is packed by zip: {} in it is read", quote(scenes[0])));
      return read_packed(inside, options, format);
    }
  }
  const auto has = [&](std::string_view ending) {
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) { return name.ends_with(ending); });
  };
  if (has("data.pkl"))
    throw InputError(file.name(), "",
                     fmt::format("found a checkpoint of PyTorch, expected {}: export one of it", kScenes));
  if (has(".usdc") || has(".usda"))
    throw InputError(file.name(), "",
                     fmt::format("found USD in a zip archive, expected {}: export one of it", kScenes));
  throw InputError(
      file.name(), "",
      fmt::format("found no 'meta.json' and no 'lod-meta.json' in the zip archive, but {}{}; unpack it and "
                  "name the scene in it{}",
                  names.empty() ? "nothing" : quote(names.front()),
                  names.size() > 1 ? fmt::format(" and {} more", names.size() - 1) : "",
                  scenes.empty() ? "" : ", such as " + quote(scenes.front())));
}

Scene read_unpacked(const InputFile& file, const ReadOptions& options, SceneFormat& format) {
  if (begins_with_ply(file.text())) {
    PlySource source(file.name(), file.text());
    return read_any_ply(source, format);
  }
  if (file.starts_with(kSpz)) return read_spz(file, format);
  if (file.starts_with(kGltf)) return read_gltf(file, format);
  if (is_zip(file)) return read_zip(file, options, format);
  if (file.starts_with(kXyzs)) return read_xyzs(file, format);
  if (looks_like_json(file)) return read_json_scene(file, options, format);
  return read_untold(file, format);
}

Scene read_packed(const InputFile& file, const ReadOptions& options, SceneFormat& format) {
  if (!file.starts_with(kGzip)) {
    // Before version 4 the gzip is part of the format.
    const bool bare = file.starts_with(kSpz) && file.size() >= 8 && file.at<std::uint32_t>(4, "header") < 4;
    Scene scene = read_unpacked(file, options, format);
    if (bare)
      format.findings.emplace_back("gzip_missing",
                                   "the gzip around the .spz is missing, as servers take it off: it is read without");
    return scene;
  }
  std::uint64_t behind = 0;
  InputFile inside = unpack_gzip(file, &behind);
  if (inside.starts_with(kGzip)) inside = unpack_gzip(inside);  // a server packs what is packed
  Scene scene = read_unpacked(inside, options, format);
  if (!inside.starts_with(kSpz))
    format.findings.emplace_back("gzip_around", "the file is packed by gzip: what is in it is read");
  if (behind > 0)
    format.findings.emplace_back("behind_end",
                                 fmt::format("found {} bytes behind the gzip, which are left out", behind));
  return scene;
}

void finish(const std::string& file, Scene& scene, const ReadOptions& options, SceneFormat& format) {
  if (options.lod >= format.levels)
    throw InputError(file, "--lod", fmt::format("found {}, but the file has one level of detail", options.lod));
  if (!options.axes.empty()) format.axes = options.axes;
  if (format.axes.empty())
    format.findings.emplace_back(
        "axes_unknown", "the file does not say its axes: read as RDF, INRIA's; if it is upside down: --axes RUB");
  else {
    transform(scene, turn_of(format.axes));
    format.origin = turn_of(format.axes) * format.origin;
  }
}

// A folder stands for the file in it.
std::filesystem::path file_of(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_directory(path, error)) return path;
  for (const char* name : {"lod-meta.json", "meta.json"}) {
    if (std::filesystem::exists(path / name, error)) return path / name;
  }
  std::string what = "found a folder without lod-meta.json or meta.json, expected a scene";
  // INRIA's training leaves point_cloud/iteration_30000/point_cloud.ply.
  const std::filesystem::path clouds =
      std::filesystem::exists(path / "point_cloud", error) ? path / "point_cloud" : path;
  std::string latest;
  std::size_t looked = 0;
  using Iterator = std::filesystem::recursive_directory_iterator;
  for (Iterator at(clouds, std::filesystem::directory_options::skip_permission_denied, error);
       !error && at != Iterator() && looked < kMostLooked; at.increment(error), ++looked) {
    const std::string ending = at->path().extension().string();
    if (std::find(kEndings.begin(), kEndings.end(), ending) == kEndings.end()) continue;
    const std::string name = at->path().lexically_relative(path).string();
    if (name.size() > latest.size() || (name.size() == latest.size() && name > latest)) latest = name;
  }
  if (!latest.empty()) what += fmt::format(": name the file, such as {}", quote(latest));
  else if (std::filesystem::exists(path / "sparse", error))
    what += ": it holds a model of COLMAP, which pipegs train makes a scene of";
  throw InputError(path.string(), "", what);
}

bool is_ply(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string begin(kUtf8Mark.size() + kPly.size(), '\0');
  stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return begins_with_ply(begin);
}

}  // namespace

Scene read_scene(const InputFile& file, const ReadOptions& options, SceneFormat& format) {
  Scene scene = read_packed(file, options, format);
  finish(file.name(), scene, options, format);
  return scene;
}

Scene read_scene(const std::filesystem::path& path, const ReadOptions& options, SceneFormat* format) {
  const std::filesystem::path file = file_of(path);
  require_regular_file(file, "a scene");
  SceneFormat own;
  SceneFormat& found = format == nullptr ? own : *format;
  Scene scene;
  if (is_ply(file)) {  // in pieces: it may be larger than the memory
    PlySource source(file);
    scene = read_any_ply(source, found);
    finish(file.string(), scene, options, found);
  } else {
    scene = read_scene(InputFile(file), options, found);
  }
  const bool whole_folder = file.filename() == "lod-meta.json" || file.filename() == "meta.json";
  const std::filesystem::path named = whole_folder ? std::filesystem::absolute(file).parent_path() : file;
  scene.name = one_line(valid_utf8(named.stem().string()));  // reports and pages are UTF-8
  return scene;
}

}  // namespace pipegs
