// SPDX-License-Identifier: Apache-2.0
// compressed_ply: the .compressed.ply of PlayCanvas and SuperSplat: chunks of 256 Gaussians, 16 bytes each.
//
// Layout  Element chunk: floats, the least and the largest of positions, log scales and (in newer files) colours.
//         Element vertex: packed_position, packed_rotation, packed_scale, packed_color, each a uint. Element sh, which
//         may be missing: f_rest_* as uchar, in INRIA's order.
// Rule    Positions and scales are 11 + 10 + 11 bits in the range of their chunk, high bits first. Of the byte of an
//         SH coefficient the middle is taken, as its own writer reads it back: ((v + 0.5) / 256 - 0.5) 8; but the first
//         and the last are the ends of the range.
// Errors  InputError of an element that is missing, of another type, or not as long as the Gaussians need.
#include <fmt/format.h>

#include <array>
#include <numbers>
#include <optional>

#include "scenes/formats/format.hpp"
#include "scenes/input_error.hpp"
#include "scenes/ply/ply.hpp"
#include "scenes/ply/ply_file.hpp"

namespace pipegs {
namespace {

constexpr std::uint64_t kChunk = 256;

double unorm(std::uint32_t bits, int shift, int width) {
  const std::uint32_t most = (1u << width) - 1;
  return static_cast<double>(bits >> shift & most) / most;
}

// The values of one element: where each property that is wanted lies in a row, and all rows.
class Table {
 public:
  Table(PlySource& source, const PlyElement& element) : file_(source.file()), element_(element) {
    for (const PlyProperty& property : element.properties) {
      if (property.is_list) fail(property, "found a list, expected a scalar property");
      stride_ += size_of(property.type);
    }
    if (element.count == 0) return;
    if (stride_ == 0)
      throw InputError(file_, fmt::format("line {}, element {}", element.line, element.name), "has no properties");
    check_fits(source, PlyFormat::kLittleEndian, element);
    const auto size = static_cast<std::size_t>(element.count * stride_);
    const std::uint8_t* bytes = source.take(size);
    rows_.assign(bytes, bytes + size);
  }

  std::uint64_t count() const { return element_.count; }
  bool has(std::string_view name) const { return find(name).has_value(); }
  std::size_t offset(std::string_view name, PlyType type) const {
    const auto found = find(name);
    if (!found) {
      throw InputError(file_, fmt::format("line {}, element {}", element_.line, element_.name),
                       fmt::format("property {} is missing", name));
    }
    if (found->first->type != type) fail(*found->first, "found another type than a compressed .ply has");
    return found->second;
  }
  const std::uint8_t* row(std::uint64_t i) const { return rows_.data() + i * stride_; }

 private:
  [[noreturn]] void fail(const PlyProperty& property, const char* what) const {
    throw InputError(file_, fmt::format("line {}, {}", property.line, property.name), what);
  }
  std::optional<std::pair<const PlyProperty*, std::size_t>> find(std::string_view name) const {
    std::size_t offset = 0;
    for (const PlyProperty& property : element_.properties) {
      if (property.name == name) return std::pair{&property, offset};
      offset += size_of(property.type);
    }
    return std::nullopt;
  }

  std::string file_;
  const PlyElement& element_;
  std::size_t stride_ = 0;
  std::vector<std::uint8_t> rows_;
};

// Least and largest of three values of a chunk.
struct Range {
  std::array<std::size_t, 3> low{}, high{};

  Range(const Table& chunks, const std::array<const char*, 3>& names) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = chunks.offset(fmt::format("min_{}", names[k]), PlyType::kFloat32);
      high[k] = chunks.offset(fmt::format("max_{}", names[k]), PlyType::kFloat32);
    }
  }
  double at(const std::uint8_t* chunk, std::size_t k, double t) const {
    const double from = load<float>(chunk + low[k]), to = load<float>(chunk + high[k]);
    return from + (to - from) * t;
  }
};

std::array<double, 3> three(std::uint32_t bits) {
  return {unorm(bits, 21, 11), unorm(bits, 11, 10), unorm(bits, 0, 11)};
}

// The index of the largest of w x y z in the top bits, then the others.
glm::vec4 rotation_of(std::uint32_t bits) {
  glm::vec4 q(0);
  double sum = 0;
  const int largest = static_cast<int>(bits >> 30);
  for (int k = 0, shift = 20; k < 4; ++k) {
    if (k == largest) continue;
    const double v = (unorm(bits, shift, 10) - 0.5) * std::numbers::sqrt2;
    q[k] = static_cast<float>(v);
    sum += v * v;
    shift -= 10;
  }
  q[largest] = static_cast<float>(std::sqrt(std::max(0.0, 1 - sum)));
  return q;
}

float rest_of(std::uint8_t v) {
  const double t = v == 0 ? 0 : v == 255 ? 1 : (v + 0.5) / 256;
  return static_cast<float>((t - 0.5) * 8);
}

void decode(const Table& chunks, const Table& vertices, Scene& scene) {
  const Range position(chunks, {"x", "y", "z"}), scale(chunks, {"scale_x", "scale_y", "scale_z"});
  std::optional<Range> color;
  if (chunks.has("min_r")) color.emplace(chunks, std::array{"r", "g", "b"});
  std::array<std::size_t, 4> packed{};
  static constexpr std::array kPacked = {"packed_position", "packed_rotation", "packed_scale", "packed_color"};
  for (std::size_t k = 0; k < packed.size(); ++k) packed[k] = vertices.offset(kPacked[k], PlyType::kUint32);
  for (std::size_t i = 0; i < scene.gaussians.size(); ++i) {
    const std::uint8_t *row = vertices.row(i), *chunk = chunks.row(i / kChunk);
    const auto bits = [&](std::size_t k) { return load<std::uint32_t>(row + packed[k]); };
    const auto at = three(bits(0)), size = three(bits(2));
    Gaussian& g = scene.gaussians[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<int>(k);
      g.mean[axis] = narrow(position.at(chunk, k, at[k]));
      g.log_scale[axis] = narrow(scale.at(chunk, k, size[k]));
      const double t = unorm(bits(3), 24 - 8 * axis, 8);
      g.sh_dc[axis] = narrow(((color ? color->at(chunk, k, t) : t) - 0.5) / kShConstant);
    }
    g.rotation = rotation_of(bits(1));
    g.opacity_logit = logit_of(unorm(bits(3), 0, 8));
  }
}

void decode_rest(const Table& sh, Scene& scene) {
  const int count = sh_rest_count(scene.sh_degree);
  for (int c = 0; c < 3; ++c) {
    for (int k = 0; k < count; ++k) {
      const std::size_t offset = sh.offset(fmt::format("f_rest_{}", c * count + k), PlyType::kUint8);
      for (std::size_t i = 0; i < scene.gaussians.size(); ++i)
        scene.sh_rest[(i * static_cast<std::size_t>(count) + static_cast<std::size_t>(k)) * 3 +
                      static_cast<std::size_t>(c)] = rest_of(sh.row(i)[offset]);
    }
  }
}

int degree_of(const std::string& file, const PlyElement& sh) {
  for (int degree = 1; degree <= kMaxShDegree; ++degree) {
    if (sh.properties.size() == static_cast<std::size_t>(3 * sh_rest_count(degree))) return degree;
  }
  throw InputError(file, fmt::format("line {}, element sh", sh.line),
                   fmt::format("found {} properties, expected 9, 24 or 45", sh.properties.size()));
}

}  // namespace

Scene read_compressed_ply(PlySource& source, const PlyHeader& header, SceneFormat& format) {
  if (header.format != PlyFormat::kLittleEndian)
    throw InputError(source.file(), "format", "found a compressed .ply that is not binary_little_endian");
  std::optional<Table> chunks, vertices, sh;
  int degree = 0;
  for (const PlyElement& element : header.elements) {
    Table table(source, element);
    if (element.name == "chunk") chunks.emplace(std::move(table));
    if (element.name == "vertex") vertices.emplace(std::move(table));
    if (element.name != "sh" || element.properties.empty()) continue;
    degree = degree_of(source.file(), element);
    sh.emplace(std::move(table));
  }
  if (!chunks || !vertices) throw InputError(source.file(), "header", "element 'chunk' or 'vertex' is missing");
  if (vertices->count() > chunks->count() * kChunk || (sh && sh->count() < vertices->count())) {
    throw InputError(source.file(), "header",
                     fmt::format("found {} Gaussians, expected {} or fewer of {} chunks, and SH for each",
                                 vertices->count(), chunks->count() * kChunk, chunks->count()));
  }
  Scene scene = scene_of_size(static_cast<std::size_t>(vertices->count()), degree);
  scene.antialiased = says_antialiased(header);
  decode(*chunks, *vertices, scene);
  if (sh) decode_rest(*sh, scene);
  tell_rest(source, header, format);
  const char* colors = chunks->has("min_r") ? "3 x 8 bits in the range of 256 Gaussians" : "3 x 8 bits, cut to 0 .. 1";
  format.name = "compressed .ply";
  format.axes = "RDF";
  format.fields = {{"position", "11 + 10 + 11 bits in the box of 256 Gaussians"},
                   {"scale", "11 + 10 + 11 bits of its logarithm, in the range of 256 Gaussians"},
                   {"rotation", "smallest three of 10 bits"},
                   {"opacity", "8 bits"},
                   {"colour", colors},
                   {"SH", sh ? "8 bits from -4 to 4" : "none"}};
  return scene;
}

}  // namespace pipegs
