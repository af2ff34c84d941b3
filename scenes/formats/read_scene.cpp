// SPDX-License-Identifier: Apache-2.0
// read_scene: see read_scene.hpp.
#include "scenes/formats/read_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "scenes/formats/axes.hpp"
#include "scenes/input_error.hpp"
#include "scenes/packed/unpack.hpp"
#include "scenes/ply/ply.hpp"
#include "scenes/text/json.hpp"
#include "scenes/text/json_node.hpp"
#include "scenes/text/text_file.hpp"

namespace pipegs {
namespace {

constexpr std::string_view kPly = "ply", kGzip = "\x1f\x8b", kSpz = "NGSP", kGltf = "glTF", kZip = "PK";

Scene read_any_ply(PlySource& source, SceneFormat& format) {
  const PlyHeader header = read_ply_header(source);
  for (const PlyElement& element : header.elements) {
    const auto packed = [](const PlyProperty& property) { return property.name == "packed_position"; };
    if (element.name == "vertex" && std::any_of(element.properties.begin(), element.properties.end(), packed))
      return read_compressed_ply(source, header, format);
  }
  format.name = header.format == PlyFormat::kAscii          ? "INRIA's .ply, ASCII"
                : header.format == PlyFormat::kLittleEndian ? "INRIA's .ply"
                                                            : "INRIA's .ply, big-endian";
  format.axes = kSceneAxes;
  for (const PlyElement& element : header.elements) {
    if (element.name != "vertex") continue;
    for (const PlyProperty& property : element.properties) {
      if (property.is_list || property.name != "x") continue;
      format.fields = {{"all values", fmt::format("{} bits, as trained", 8 * size_of(property.type))}};
    }
  }
  return read_ply(source, header);
}

bool looks_like_json(const InputFile& file) {
  const std::string& text = file.text();
  const std::size_t open = text.find_first_not_of(" \t\r\n");
  if (open == std::string::npos || text[open] != '{') return false;
  const std::size_t next = text.find_first_not_of(" \t\r\n", open + 1);
  return next != std::string::npos && (text[next] == '"' || text[next] == '}');
}

Scene read_json_scene(const InputFile& file, const ReadOptions& options, SceneFormat& format) {
  const JsonNode json = JsonNode::parse(file.name(), file.text());
  if (json.has("asset") && json.has("meshes")) return read_gltf(file, format);
  if (json.has("tree")) return read_streamed_sog(file, options.lod, format);
  if (json.has("means")) return read_sog(file, format);
  throw InputError(file.name(), "",
                   "found JSON without 'means' (SOG), 'tree' (streamed SOG) or 'meshes' (glTF), expected a scene");
}

Scene read_untold(const InputFile& file, SceneFormat& format) {
  if (looks_like_ksplat(file)) return read_ksplat(file, format);
  if (looks_like_splat(file)) return read_splat(file, format);
  throw InputError(file.name(), "",
                   fmt::format("found {} bytes that begin with {}, expected a scene: .ply, .splat, "
                               ".ksplat, .spz, .sog, meta.json, lod-meta.json, .glb or .gltf",
                               file.size(), quote(file.text().substr(0, 8))));
}

Scene read_packed(const InputFile& file, const ReadOptions& options, SceneFormat& format) {
  if (file.starts_with(kGzip) || file.starts_with(kSpz)) return read_spz(file, format);
  if (file.starts_with(kGltf)) return read_gltf(file, format);
  if (file.starts_with(kZip)) return read_sog(unpack_zip(file, "meta.json"), format);
  if (looks_like_json(file)) return read_json_scene(file, options, format);
  return read_untold(file, format);
}

void finish(const std::string& file, Scene& scene, const ReadOptions& options, SceneFormat& format) {
  if (options.lod >= format.levels)
    throw InputError(file, "--lod", fmt::format("found {}, but the file has one level of detail", options.lod));
  if (!options.axes.empty()) format.axes = options.axes;
  if (format.axes.empty())
    format.notes.push_back("the file does not say its axes: read as RDF, INRIA's; if it is upside down: --axes RUB");
  else transform(scene, turn_of(format.axes));
}

// A folder stands for the file in it.
std::filesystem::path file_of(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_directory(path, error)) return path;
  for (const char* name : {"lod-meta.json", "meta.json"}) {
    if (std::filesystem::exists(path / name, error)) return path / name;
  }
  throw InputError(path.string(), "", "found a folder without lod-meta.json or meta.json, expected a scene");
}

bool begins_with_ply(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string begin(kPly.size(), '\0');
  stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return begin == kPly;
}

}  // namespace

Scene read_scene(const InputFile& file, const ReadOptions& options, SceneFormat& format) {
  Scene scene;
  if (file.starts_with(kPly)) {
    PlySource source(file.name(), file.text());
    scene = read_any_ply(source, format);
  } else {
    scene = read_packed(file, options, format);
  }
  finish(file.name(), scene, options, format);
  return scene;
}

Scene read_scene(const std::filesystem::path& path, const ReadOptions& options, SceneFormat* format) {
  const std::filesystem::path file = file_of(path);
  require_regular_file(file, "a scene");
  SceneFormat own;
  SceneFormat& found = format == nullptr ? own : *format;
  Scene scene;
  if (begins_with_ply(file)) {  // in pieces: it may be larger than the memory
    PlySource source(file);
    scene = read_any_ply(source, found);
    finish(file.string(), scene, options, found);
  } else {
    scene = read_scene(InputFile(file), options, found);
  }
  const bool whole_folder = file.filename() == "lod-meta.json" || file.filename() == "meta.json";
  const std::filesystem::path named = whole_folder ? std::filesystem::absolute(file).parent_path() : file;
  scene.name = valid_utf8(named.stem().string());  // reports and pages are UTF-8
  return scene;
}

}  // namespace pipegs
