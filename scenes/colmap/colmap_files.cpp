// SPDX-License-Identifier: Apache-2.0
// colmap_files: the three files, each in both of its forms; see colmap.hpp.
//
// Layout  Binary, little-endian, each file a count and then its records:
//           cameras   id u32, model i32, width u64, height u64, parameters f64
//           images    id u32, q f64 x 4 (w first), t f64 x 3, camera u32, name to a 0, count, points of 24 bytes
//           points3D  id u64, position f64 x 3, colour u8 x 3, error f64, count, a track of 8 bytes for each
//         Text: the same by words, # begins a comment; an image takes two lines, the second of its 2D points, which may
//         be empty. What the points were seen in is skipped.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "scenes/packed/byte_reader.hpp"
#include "scenes/colmap/colmap.hpp"
#include "scenes/colmap/colmap_words.hpp"
#include "scenes/text/text_file.hpp"

namespace pipegs {
namespace {

constexpr std::string_view kModels[] = {"SIMPLE_PINHOLE",
                                        "PINHOLE",
                                        "SIMPLE_RADIAL",
                                        "RADIAL",
                                        "OPENCV",
                                        "OPENCV_FISHEYE",
                                        "FULL_OPENCV",
                                        "FOV",
                                        "SIMPLE_RADIAL_FISHEYE",
                                        "RADIAL_FISHEYE",
                                        "THIN_PRISM_FISHEYE",
                                        "RAD_TAN_THIN_PRISM_FISHEYE"};

bool is_text(const std::string& file) { return file.ends_with(".txt"); }

// How many focal lengths and how many other parameters a model has; the principal point stands between them.
struct Parameters {
  std::size_t focal, bent;
  std::size_t all() const { return focal + 2 + bent; }
};

// InputError for a model that bends rays, unless that can be ignored.
Parameters parameters_of(const std::string& file, const std::string& where, std::string_view model, bool ignore) {
  if (model == kModels[0]) return {1, 0};
  if (model == kModels[1]) return {2, 0};
  const bool known = std::find(std::begin(kModels), std::end(kModels), model) != std::end(kModels);
  const std::size_t focal = model.starts_with("SIMPLE_RADIAL") || model == "RADIAL" ? 1 : 2,
                    bent = model == "SIMPLE_RADIAL" ? 1
                           : model == "RADIAL"      ? 2
                           : model == "OPENCV"      ? 4
                           : model == "FULL_OPENCV" ? 8
                                                    : 0;
  if (ignore && bent > 0) return {focal, bent};
  throw InputError(file, where + ", model",
                   fmt::format("found {}, expected PINHOLE or SIMPLE_PINHOLE{}{}", quote(model),
                               known ? "; take the distortion out with colmap image_undistorter" : "",
                               bent > 0 ? ", or --ignore-distortion" : ""));
}

ColmapLens lens_of(const std::string& file, const std::string& where, std::uint32_t id, std::uint64_t width,
                   std::uint64_t height, std::span<const double> p, std::size_t axes) {
  const auto side = [&](const char* field, std::uint64_t pixels) {
    if (pixels >= 1 && pixels <= kMaxImageSide) return static_cast<int>(pixels);
    throw InputError(file, fmt::format("{}, {}", where, field),
                     fmt::format("found {}, expected an integer from 1 to {}", pixels, kMaxImageSide));
  };
  const auto real = [&](const char* field, double value, const RealRange& range) {
    if (range.holds(value)) return value;
    throw InputError(file, fmt::format("{}, {}", where, field),
                     fmt::format("found {}, expected {}", value, range.text()));
  };
  return {id,
          side("width", width),
          side("height", height),
          real("focal length", p[0], kPositive),
          real("focal length", p[axes - 1], kPositive),
          real("cx", p[axes], kFinite),
          real("cy", p[axes + 1], kFinite)};
}

// The lines that hold something, but comments; visit(number, line) gets the number for errors, from 1.
template <class Visit>
void for_each_line(std::string_view text, Visit&& visit) {
  int number = 0;
  for (const std::string_view line : lines_of(text)) {
    ++number;
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos || line[first] == '#') continue;
    visit(number, line);
  }
}

void check_end(const ByteReader& bytes) {
  if (bytes.remaining() > 0)
    throw InputError(bytes.file(), "end",
                     fmt::format("found {} bytes behind the last record, expected none", bytes.remaining()));
}

std::vector<ColmapLens> lenses_of_text(const std::string& file, std::string_view text, bool ignore_distortion) {
  std::vector<ColmapLens> lenses;
  for_each_line(text, [&](int number, std::string_view line) {
    const std::string where = fmt::format("line {}", number);
    ColmapWords words(file, where, line);
    const auto id = words.integer<std::uint32_t>("camera id");
    const Parameters kind = parameters_of(file, where, words.word("model"), ignore_distortion);
    std::vector<double> parameters(kind.all());
    const auto width = words.integer<std::uint64_t>("width"), height = words.integer<std::uint64_t>("height");
    for (double& parameter : parameters) parameter = words.real("parameters");
    if (!words.empty())
      words.fail("parameters", fmt::format("found more than {}, expected no more", parameters.size()));
    lenses.push_back(lens_of(file, where, id, width, height, parameters, kind.focal));
  });
  return lenses;
}

std::vector<ColmapPose> poses_of_text(const std::string& file, std::string_view text) {
  std::vector<ColmapPose> poses;
  int number = 0;
  bool points_follow = false;
  for (const std::string_view line : lines_of(text)) {
    ++number;
    // An empty line is an image without points when it follows one, and no line anywhere else.
    if (points_follow) {
      points_follow = false;
      continue;
    }
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos || line[first] == '#') continue;
    ColmapWords words(file, fmt::format("line {}", number), line);
    ColmapPose& pose = poses.emplace_back();
    pose.id = words.integer<std::uint32_t>("image id");
    for (int i = 0; i < 4; ++i) pose.rotation[i] = words.real("rotation");
    for (int i = 0; i < 3; ++i) pose.translation[i] = words.real("translation");
    pose.lens = words.integer<std::uint32_t>("camera id");
    pose.name = words.tail("name");
    points_follow = true;
  }
  return poses;
}

std::vector<ScenePoint> points_of_text(const std::string& file, std::string_view text) {
  std::vector<ScenePoint> points;
  for_each_line(text, [&](int number, std::string_view line) {
    ColmapWords words(file, fmt::format("line {}", number), line);
    words.word("point id");
    ScenePoint& point = points.emplace_back();
    for (int i = 0; i < 3; ++i) point.position[i] = words.real("position");
    for (int i = 0; i < 3; ++i) point.color[i] = static_cast<std::uint8_t>(words.integer<int>("colour", 0, 255));
  });
  return points;
}

std::vector<ColmapLens> lenses_of_bytes(const std::string& file, std::string_view data, bool ignore_distortion) {
  ByteReader bytes(file, data);
  std::vector<ColmapLens> lenses;
  const std::uint64_t count = bytes.count(24 + 3 * 8, "number of cameras");
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::string where = fmt::format("camera {}", i);
    const auto id = bytes.take<std::uint32_t>(where);
    const auto model = bytes.take<std::int32_t>(where);
    const auto width = bytes.take<std::uint64_t>(where), height = bytes.take<std::uint64_t>(where);
    const bool known = model >= 0 && static_cast<std::size_t>(model) < std::size(kModels);
    const Parameters kind = parameters_of(
        file, where, known ? std::string(kModels[model]) : fmt::format("model {}", model), ignore_distortion);
    std::vector<double> parameters(kind.all());
    for (double& parameter : parameters) parameter = bytes.take<double>(where);
    lenses.push_back(lens_of(file, where, id, width, height, parameters, kind.focal));
  }
  check_end(bytes);
  return lenses;
}

std::vector<ColmapPose> poses_of_bytes(const std::string& file, std::string_view data) {
  ByteReader bytes(file, data);
  std::vector<ColmapPose> poses;
  const std::uint64_t count = bytes.count(4 + 7 * 8 + 4 + 1 + 8, "number of images");
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::string where = fmt::format("image {}", i);
    ColmapPose& pose = poses.emplace_back();
    pose.id = bytes.take<std::uint32_t>(where);
    for (int k = 0; k < 4; ++k) pose.rotation[k] = bytes.take<double>(where);
    for (int k = 0; k < 3; ++k) pose.translation[k] = bytes.take<double>(where);
    pose.lens = bytes.take<std::uint32_t>(where);
    pose.name = bytes.text(where + ", name");
    bytes.skip(24 * bytes.count(24, where + ", number of points"), where);
  }
  check_end(bytes);
  return poses;
}

std::vector<ScenePoint> points_of_bytes(const std::string& file, std::string_view data) {
  ByteReader bytes(file, data);
  std::vector<ScenePoint> points;
  const std::uint64_t count = bytes.count(8 + 3 * 8 + 3 + 8 + 8, "number of points");
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::string where = fmt::format("point {}", i);
    ScenePoint& point = points.emplace_back();
    bytes.skip(8, where);
    for (int k = 0; k < 3; ++k) point.position[k] = bytes.take<double>(where);
    for (int k = 0; k < 3; ++k) point.color[k] = bytes.take<std::uint8_t>(where);
    bytes.skip(8, where);
    bytes.skip(8 * bytes.count(8, where + ", length of track"), where);
  }
  check_end(bytes);
  return points;
}

}  // namespace

std::vector<ColmapLens> parse_colmap_lenses(const std::string& file, std::string_view bytes, bool ignore_distortion) {
  return is_text(file) ? lenses_of_text(file, bytes, ignore_distortion)
                       : lenses_of_bytes(file, bytes, ignore_distortion);
}

std::vector<ColmapPose> parse_colmap_poses(const std::string& file, std::string_view bytes) {
  return is_text(file) ? poses_of_text(file, bytes) : poses_of_bytes(file, bytes);
}

std::vector<ScenePoint> parse_colmap_points(const std::string& file, std::string_view bytes) {
  std::vector<ScenePoint> points = is_text(file) ? points_of_text(file, bytes) : points_of_bytes(file, bytes);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const double value = points[i].position[axis];
      if (std::abs(value) <= kFarthestPoint) continue;  // NaN fails
      throw InputError(file, fmt::format("point {}, position", i),
                       fmt::format("found {}, expected a number of at most {:g}", value, kFarthestPoint));
    }
  }
  return points;
}

}  // namespace pipegs
