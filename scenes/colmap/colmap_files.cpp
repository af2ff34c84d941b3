// SPDX-License-Identifier: Apache-2.0
// colmap_files: the three files, each in both of its forms; see colmap.hpp.
//
// Layout  Records one behind the other, of the same fields in both forms:
//           cameras   id, model, width, height, parameters
//           images    id, quaternion (w first), translation, camera, name, the 2D points that it saw
//           points3D  id, position, colour, error, the track of images that saw it
//         Binary, little-endian, with the number of records before them: ids of 32 bits (of points 64), sizes of 64,
//         the model as an i32, reals as f64, colours as u8, a name up to a 0; 2D points and tracks are a count, then
//         24 or 8 bytes each. Text: words, a line for each record, # begins a comment; an image takes a second line of
//         its 2D points, which may be empty. What the points were seen in is skipped.
// Idea    LineFields and ByteFields give the fields of a record in their order, so each file has one parser.
#include <algorithm>
#include <cmath>
#include <concepts>
#include <set>
#include <span>

#include "scenes/colmap/colmap.hpp"
#include "scenes/input_error.hpp"
#include "scenes/packed/byte_reader.hpp"
#include "scenes/text/number.hpp"
#include "scenes/text/text_file.hpp"

namespace pipegs {
namespace {

constexpr std::string_view kBlanks = " \t";
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
                                        "RAD_TAN_THIN_PRISM_FISHEYE",
                                        "SIMPLE_DIVISION",
                                        "DIVISION",
                                        "SIMPLE_FISHEYE",
                                        "FISHEYE",
                                        "EUCM",
                                        "EQUIRECTANGULAR"};

constexpr std::size_t kParameters[std::size(kModels)] = {3, 4, 4, 5, 8, 8, 12, 5, 4, 5, 12, 16, 4, 5, 3, 4, 6, 2};

bool is_number(std::string_view word) {
  try {
    parse_real(word);
  } catch (const NumberError&) { return false; }
  return true;
}

// Whether a line of images.txt is an image: nine numbers and a name, of which words may be numbers too. 2D points are
// numbers alone, three each.
bool is_image(std::string_view line) {
  std::string_view last;
  int words = 0;
  for (std::size_t begin; (begin = line.find_first_not_of(kBlanks)) != line.npos; ++words) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
    last = line.substr(begin, end - begin);
    if (words < 9 && !is_number(last)) return false;
    if (words == 9 && !is_number(last)) return true;
    line.remove_prefix(end);
  }
  return words > 9 && (words % 3 != 0 || !is_number(last));
}

class LineFields {
 public:
  LineFields(const std::string& file, std::string_view text, const char*, std::size_t)
      : file_(file), lines_(lines_of(text)) {}

  // To the next record; false when there is none.
  bool next() {
    while (read_ < lines_.size()) {
      rest_ = lines_[read_++];
      if (const std::size_t first = rest_.find_first_not_of(kBlanks); first != rest_.npos && rest_[first] != '#')
        return true;
    }
    return false;
  }
  std::string where() const { return fmt::format("line {}", read_); }

  template <std::integral T>
  T integer(std::string_view field) {
    const std::string_view taken = word(field);
    try {
      return parse_integer<T>(taken);
    } catch (const NumberError& error) { fail(field, error.what()); }
  }
  double real(std::string_view field) {
    const std::string_view taken = word(field);
    try {
      return parse_real(taken);
    } catch (const NumberError& error) { fail(field, error.what()); }
  }
  std::string model() { return std::string(word("model")); }
  // All that is left of the line, without the blanks round it.
  std::string name() {
    const std::size_t begin = rest_.find_first_not_of(kBlanks), end = rest_.find_last_not_of(kBlanks);
    if (begin == rest_.npos) fail("name", "found the end of the line, expected a name");
    return std::string(rest_.substr(begin, end + 1 - begin));
  }
  void end_of_lens(std::size_t parameters) const {
    if (rest_.find_first_not_of(kBlanks) != rest_.npos)
      fail("parameters", fmt::format("found more than {}, expected no more", parameters));
  }
  // The line of 2D points; whether there is one and not another image in its place.
  bool skip_seen() {
    if (read_ < lines_.size() && is_image(lines_[read_])) return false;
    ++read_;
    return true;
  }
  void skip_track() {}
  void skip_lens(std::string_view) {}

 private:
  std::string_view word(std::string_view field) {
    const std::size_t begin = rest_.find_first_not_of(kBlanks);
    if (begin == rest_.npos) fail(field, "found the end of the line, expected a value");
    const std::size_t end = std::min(rest_.find_first_of(kBlanks, begin), rest_.size());
    const std::string_view taken = rest_.substr(begin, end - begin);
    rest_.remove_prefix(end);
    return taken;
  }
  [[noreturn]] void fail(std::string_view field, std::string_view what) const {
    throw InputError(file_, fmt::format("{}, {}", where(), field), what);
  }

  const std::string& file_;
  std::vector<std::string_view> lines_;
  std::size_t read_ = 0;  // lines
  std::string_view rest_;
};

class ByteFields {
 public:
  // `least` bytes are in each `record` ("camera").
  ByteFields(const std::string& file, std::string_view bytes, const char* record, std::size_t least)
      : bytes_(file, bytes), record_(record), count_(bytes_.count(least, fmt::format("number of {}s", record))) {}

  bool next() { return read_++ < count_; }
  std::size_t behind() const { return bytes_.remaining(); }
  std::string where() const { return fmt::format("{} {}", record_, read_ - 1); }

  template <std::integral T>
  T integer(std::string_view field) {
    return bytes_.take<T>(at(field));
  }
  double real(std::string_view field) { return bytes_.take<double>(at(field)); }
  std::string model() {
    const auto number = integer<std::int32_t>("model");
    const bool known = number >= 0 && static_cast<std::size_t>(number) < std::size(kModels);
    return known ? std::string(kModels[number]) : fmt::format("model {}", number);
  }
  std::string name() { return bytes_.text(at("name")); }
  void end_of_lens(std::size_t) const {}
  bool skip_seen() {
    skip_list(24, "number of points");
    return true;
  }
  void skip_track() {
    real("error");
    skip_list(8, "length of track");
  }
  // What is behind the model of a lens that is not wanted.
  void skip_lens(std::string_view model) {
    const auto known = std::find(std::begin(kModels), std::end(kModels), model);
    if (known == std::end(kModels))
      throw InputError(bytes_.file(), at("model"),
                       fmt::format("found {}, expected one of 0 to {}", quote(model), std::size(kModels) - 1));
    const std::size_t parameters = kParameters[static_cast<std::size_t>(known - std::begin(kModels))];
    bytes_.skip(16 + 8 * parameters, at("parameters"));
  }

 private:
  std::string at(std::string_view field) const { return fmt::format("{}, {}", where(), field); }
  void skip_list(std::size_t size, std::string_view field) {
    bytes_.skip(size * bytes_.count(size, at(field)), at(field));
  }

  ByteReader bytes_;
  const char* record_;
  std::uint64_t count_, read_ = 0;
};

// Calls parse(fields) with those of the file's form.
template <class Parse>
auto parsed(const std::string& file, std::string_view bytes, const char* record, std::size_t least, Findings* findings,
            Parse&& parse) {
  if (file.ends_with(".txt")) return parse(LineFields(file, bytes, record, least));
  ByteFields fields(file, bytes, record, least);
  auto records = parse(fields);
  if (fields.behind() > 0 && findings != nullptr)
    findings->emplace_back("behind_end",
                           fmt::format("found {} bytes behind the last {} of {}, which are left out", fields.behind(),
                                       record, std::filesystem::path(file).filename().string()));
  return records;
}

// How many focal lengths and how many other parameters a model has; the principal point stands between them.
struct Parameters {
  std::size_t focal, bent;
  std::size_t all() const { return focal + 2 + bent; }
};

[[noreturn]] void refuse_lens(const std::string& file, const std::string& where, std::string_view model,
                              const char* otherwise) {
  throw InputError(file, where + ", model",
                   fmt::format("found {}, expected PINHOLE or SIMPLE_PINHOLE; take the distortion out with colmap "
                               "image_undistorter{}",
                               quote(model), otherwise));
}

// InputError for a model that is no pinhole with an error.
Parameters parameters_of(const std::string& file, const std::string& where, std::string_view model) {
  if (model == kModels[0]) return {1, 0};
  if (model == kModels[1]) return {2, 0};
  const std::size_t focal = model.starts_with("SIMPLE_RADIAL") || model == "RADIAL" ? 1 : 2,
                    bent = model == "SIMPLE_RADIAL" ? 1
                           : model == "RADIAL"      ? 2
                           : model == "OPENCV"      ? 4
                           : model == "FULL_OPENCV" ? 8
                                                    : 0;
  if (bent == 0) refuse_lens(file, where, model, "");
  return {focal, bent};
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

}  // namespace

std::vector<ColmapLens> parse_colmap_lenses(const std::string& file, std::string_view bytes, bool ignore_distortion,
                                            const std::vector<ColmapPose>* poses, Findings* findings) {
  std::set<std::uint32_t> wanted;
  if (poses != nullptr) {
    for (const ColmapPose& pose : *poses) wanted.insert(pose.lens);
  }
  std::size_t unused = 0;
  return parsed(file, bytes, "camera", 24 + 3 * 8, findings, [&](auto&& fields) {
    std::vector<ColmapLens> lenses;
    std::set<std::uint32_t> ids;
    while (fields.next()) {
      const std::string where = fields.where();
      const auto id = fields.template integer<std::uint32_t>("camera id");
      const std::string model = fields.model();
      if (poses != nullptr && !wanted.contains(id)) {
        ++unused;
        fields.skip_lens(model);
        continue;
      }
      const Parameters kind = parameters_of(file, where, model);
      const auto width = fields.template integer<std::uint64_t>("width"),
                 height = fields.template integer<std::uint64_t>("height");
      std::vector<double> parameters(kind.all());
      for (double& parameter : parameters) parameter = fields.real("parameters");
      fields.end_of_lens(parameters.size());
      const auto bends = [](double parameter) { return parameter != 0; };
      if (!ignore_distortion &&
          std::any_of(parameters.end() - static_cast<std::ptrdiff_t>(kind.bent), parameters.end(), bends))
        refuse_lens(file, where, model, ", or --ignore-distortion");
      lenses.push_back(lens_of(file, where, id, width, height, parameters, kind.focal));
      if (!ids.insert(id).second)
        throw InputError(file, where, fmt::format("found camera id {} twice, expected it once", id));
    }
    if (unused > 0 && findings != nullptr)
      findings->emplace_back("unused_lens", fmt::format("{} of {} lenses belong to no photograph and are left out",
                                                        unused, unused + lenses.size()));
    return lenses;
  });
}

std::vector<ColmapPose> parse_colmap_poses(const std::string& file, std::string_view bytes, Findings* findings) {
  return parsed(file, bytes, "image", 4 + 7 * 8 + 4 + 1 + 8, findings, [&](auto&& fields) {
    std::size_t without = 0;
    std::string first;
    std::vector<ColmapPose> poses;
    while (fields.next()) {
      ColmapPose& pose = poses.emplace_back();
      pose.id = fields.template integer<std::uint32_t>("image id");
      for (int i = 0; i < 4; ++i) pose.rotation[i] = fields.real("rotation");
      for (int i = 0; i < 3; ++i) pose.translation[i] = fields.real("translation");
      pose.lens = fields.template integer<std::uint32_t>("camera id");
      pose.name = fields.name();
      const std::string where = fields.where();
      if (fields.skip_seen()) continue;
      if (without++ == 0) first = where;
    }
    if (without > 0 && findings != nullptr)
      findings->emplace_back("no_2d_points",
                             fmt::format("no line of 2D points stands behind {} of {} images, the first "
                                         "in {}: the next line is an image",
                                         without, poses.size(), first));
    return poses;
  });
}

std::vector<ScenePoint> parse_colmap_points(const std::string& file, std::string_view bytes, Findings* findings) {
  return parsed(file, bytes, "point", 8 + 3 * 8 + 3 + 8 + 8, findings, [&](auto&& fields) {
    std::vector<ScenePoint> points;
    while (fields.next()) {
      fields.template integer<std::uint64_t>("point id");
      ScenePoint& point = points.emplace_back();
      for (int i = 0; i < 3; ++i) {
        point.position[i] = fields.real("position");
        if (std::abs(point.position[i]) <= kFarthestPoint) continue;  // NaN fails
        throw InputError(file, fields.where() + ", position",
                         fmt::format("found {}, expected a number of at most {:g}", point.position[i], kFarthestPoint));
      }
      for (int i = 0; i < 3; ++i) point.color[i] = fields.template integer<std::uint8_t>("colour");
      fields.skip_track();
    }
    return points;
  });
}

}  // namespace pipegs
