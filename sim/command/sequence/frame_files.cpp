// SPDX-License-Identifier: Apache-2.0
// frame_files.cpp: see frame_files.hpp.
#include "sim/command/sequence/frame_files.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "scenes/atomic_file.hpp"
#include "sim/report/measurement_store.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

// Null when there is no such file.
Json hash_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return nullptr;
  return hash_of_text(std::string(std::istreambuf_iterator<char>(file), {}));
}

}  // namespace

FrameFiles::FrameFiles(const FrameFilesOptions& options) : options_(options) { make_folders(options.folder); }

std::filesystem::path FrameFiles::file(int number, const char* extension) const {
  return std::filesystem::path(options_.folder) / fmt::format("frame_{:04}.{}", number, extension);
}

Json FrameFiles::fingerprint_of(int number) const {
  Json json = Json::object();
  if (options_.png) json["png"] = hash_of(file(number, "png"));
  if (options_.exr) json["exr"] = hash_of(file(number, "exr"));
  return json;
}

void FrameFiles::add(const Image& image, const Rgb8& picture) {
  if (options_.png) write_png8(file(number_, "png"), picture);
  if (options_.exr) write_exr(file(number_, "exr"), image);
  if (options_.show) options_.show(picture);
  ++number_;
}

bool FrameFiles::take(const Json& fingerprint) {
  const Json mine = fingerprint_of(number_);
  for (const auto& [extension, hash] : mine.items()) {
    if (hash.is_null() || !fingerprint.contains(extension) || fingerprint[extension] != hash) return false;
  }
  if (options_.show) {
    if (!options_.png) return false;
    options_.show(read_png8(file(number_, "png")));
  }
  ++number_;
  return true;
}

}  // namespace pipegs
