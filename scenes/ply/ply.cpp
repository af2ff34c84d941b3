// SPDX-License-Identifier: Apache-2.0
// ply: rows of INRIA's properties become Gaussians, and back; see ply.hpp for what is accepted.
//
// Idea    A Gaussian is one row of kSlotRest + 3*K floats; ply_layout decides which property fills which slot, then
//         ply_body fills rows without knowing the meaning.
// Layout  f_rest is channel-major in the file, f_rest[c * K + k]; Scene::sh_rest is
//         coefficient-major. The transposition happens in the slot numbers, so it costs nothing.
#include "scenes/ply/ply.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>

#include "scenes/atomic_file.hpp"
#include "scenes/check/origin.hpp"
#include "scenes/formats/axes.hpp"
#include "scenes/free_memory.hpp"
#include "scenes/input_error.hpp"
#include "scenes/own_failure.hpp"
#include "scenes/ply/ply_file.hpp"
#include "scenes/ply/ply_layout.hpp"
#include "scenes/text/json.hpp"

namespace pipegs {
namespace {

constexpr std::string_view kOriginKey = "pipegs_origin";
constexpr std::array kNames = {"opacity", "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"};

// What create_fused_ply.py of Mip-Splatting makes of its filter: the Gaussian is widened by it, and as much fainter.
void fuse(double filter, Gaussian& g) {
  const double squared = filter * filter;
  double kept = 1;
  for (int k = 0; k < 3; ++k) {
    const double scale = std::exp(double{g.log_scale[k]}), wide = scale * scale + squared;
    kept *= scale * scale / wide;
    g.log_scale[k] = narrow(0.5 * std::log(wide));
  }
  const double opacity = 1 / (1 + std::exp(-double{g.opacity_logit}));
  if (squared > 0) g.opacity_logit = logit_of(opacity * std::sqrt(kept));
}

// Colours as they stand in the file. Their largest says whether the type's range is theirs: some write bytes as floats.
void take_colors(const PlyLayout& layout, Scene& scene, SceneFormat& format) {
  constexpr double kBrightest = 8;  // of colours that were not cut to 1
  float largest = 0;
  for (const Gaussian& g : scene.gaussians) {
    for (int k = 0; k < 3; ++k)
      if (std::isfinite(g.sh_dc[k])) largest = std::max(largest, g.sh_dc[k]);
  }
  double range = layout.color_range;
  if (range == 1 && largest > kBrightest) range = 255;
  if (range == 255 && largest > range) range = 65535;
  for (Gaussian& g : scene.gaussians) {
    for (int k = 0; k < 3; ++k) g.sh_dc[k] = dc_of(g.sh_dc[k] / range);
  }
  format.findings.emplace_back(
      "rgb_colors", fmt::format("{} up to {:g} are taken as colours of degree 0: {}", fmt::join(layout.colors, ", "),
                                range, layout.beside ? "all f_dc are 0" : "the file has no f_dc"));
}

void read_vertices(PlySource& source, const PlyHeader& header, const PlyElement& vertex, Scene& scene,
                   SceneFormat& format) {
  const PlyLayout layout = ply_layout(source.file(), header, vertex, format);
  check_fits(source, header.format, vertex);
  scene.sh_degree = layout.sh_degree;
  const auto rest = static_cast<std::size_t>(3 * sh_rest_count(scene.sh_degree));
  const auto count = static_cast<std::size_t>(vertex.count);
  check_scene_memory(count, scene.sh_degree);
  scene.gaussians.resize(count);
  scene.sh_rest.resize(count * rest);
  std::vector<float> row(kSlotRest + rest, 0.0f);
  if (layout.scales == 2) row[kSlotScale + 2] = -std::numeric_limits<float>::infinity();  // 2DGS: flat
  if (!layout.rotated) row[kSlotRotation] = 1;
  std::array<double, 3> wide{};
  std::vector<glm::dvec3> positions(layout.wide ? count : 0);
  bool zeros = layout.beside;  // in all f_dc
  std::vector<glm::vec3> beside;
  read_rows(
      source, header.format, vertex, layout.slots, row,
      [&](std::size_t i) {
        Gaussian& g = scene.gaussians[i];
        const float* v = row.data();
        if (layout.wide) positions[i] = {wide[0], wide[1], wide[2]};
        else g.mean = {v[kSlotX], v[kSlotX + 1], v[kSlotX + 2]};
        for (int k = 0; k < 3; ++k) {
          g.sh_dc[k] = v[kSlotDc + k];
          g.log_scale[k] = v[kSlotScale + (layout.scales == 1 ? 0 : k)];
        }
        zeros = zeros && g.sh_dc == glm::vec3(0);
        if (zeros) beside.emplace_back(v[kSlotColor], v[kSlotColor + 1], v[kSlotColor + 2]);
        g.opacity_logit = layout.opacity_range > 0 ? logit_of(v[kSlotOpacity] / layout.opacity_range) : v[kSlotOpacity];
        for (int k = 0; k < 4; ++k) g.rotation[k] = v[kSlotRotation + k];
        if (layout.filtered) fuse(v[kSlotFilter], g);
        if (rest > 0) std::memcpy(scene.sh_rest.data() + i * rest, v + kSlotRest, rest * sizeof(float));
      },
      wide.data());
  for (std::size_t i = 0; zeros && i < count; ++i) scene.gaussians[i].sh_dc = beside[i];
  if (layout.color_range > 0 && zeros == layout.beside) take_colors(layout, scene, format);
  if (layout.wide) set_positions(positions, scene, format);
  if (layout.filtered)
    format.findings.emplace_back("filter_3d",
                                 "filter_3D of Mip-Splatting is applied to scales and opacities, as its "
                                 "create_fused_ply.py does");
}

// The types of the values, in words.
void describe(const PlyHeader& header, const PlyElement& vertex, SceneFormat& format) {
  format.name = header.format == PlyFormat::kAscii          ? "INRIA's .ply, ASCII"
                : header.format == PlyFormat::kLittleEndian ? "INRIA's .ply"
                                                            : "INRIA's .ply, big-endian";
  format.axes = kSceneAxes;
  const auto is_float = [](const PlyProperty& property) {
    return property.is_list || property.type == PlyType::kFloat32;
  };
  if (std::all_of(vertex.properties.begin(), vertex.properties.end(), is_float)) {
    format.fields = {{"all values", "32 bits, as trained"}};
    return;
  }
  for (const auto& [field, names] : {std::pair{"position", std::array{"x", "position_0"}},
                                     {"scale", std::array{"scale_0", "scaling_0"}},
                                     {"rotation", std::array{"rot_0", "rotation_0"}},
                                     {"opacity", std::array{"opacity", "alpha"}},
                                     {"colour", std::array{"f_dc_0", "red"}},
                                     {"SH", std::array{"f_rest_0", "shN_0"}}}) {
    for (const PlyProperty& property : vertex.properties) {
      if (std::find(names.begin(), names.end(), property.name) == names.end()) continue;
      const bool exact = property.type == PlyType::kFloat32 || size_of(property.type) < 4;
      format.fields.emplace_back(field, fmt::format("{} bits{}", 8 * size_of(property.type),
                                                    exact ? ""
                                                    : field == std::string("position") && format.origin != glm::dvec3(0)
                                                        ? ", 32 about an origin"
                                                        : ", rounded to float32"));
      break;
    }
  }
}

// Of a comment that write_ply wrote.
glm::dvec3 said_origin(const PlyHeader& header) {
  for (const std::string& comment : header.comments) {
    std::istringstream words(comment);
    std::string key;
    glm::dvec3 origin(0);
    if (words >> key >> origin.x >> origin.y >> origin.z && key == kOriginKey) return origin;
  }
  return glm::dvec3(0);
}

}  // namespace

void tell_rest(PlySource& source, const PlyHeader& header, SceneFormat& format) {
  const std::uint64_t bytes = rest_of_file(source, header);
  if (bytes == 0) return;
  format.findings.emplace_back("behind_end",
                               fmt::format("found {} bytes behind the last Gaussian, which are left out", bytes));
}

bool says_antialiased(const PlyHeader& header) {
  bool antialiased = false;
  for (const std::string& comment : header.comments) {
    std::istringstream words(comment);
    std::string key, value;
    words >> key >> value;
    if (key == "antialiased") antialiased = value == "1" || value == "true";
    if (key == "SplatRenderMode:") antialiased = value == "mip";
  }
  return antialiased;
}

Scene read_ply(PlySource& source, const PlyHeader& header, SceneFormat& format) {
  Scene scene;
  scene.antialiased = says_antialiased(header);
  format.origin = said_origin(header);
  bool has_vertices = false;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      read_vertices(source, header, element, scene, format);
      describe(header, element, format);
      has_vertices = true;
      continue;
    }
    std::vector<float> nothing;
    read_rows(source, header.format, element, std::vector<int>(element.properties.size(), kSkip), nothing,
              [](std::size_t) {});
  }
  if (!has_vertices)
    throw InputError(source.file(), "header", "element 'vertex' is missing, expected a Gaussian per vertex");
  tell_rest(source, header, format);
  return scene;
}

Scene read_ply(PlySource& source) {
  SceneFormat format;
  return read_ply(source, read_ply_header(source), format);
}

Scene read_ply(const std::filesystem::path& path) {
  PlySource source(path);
  Scene scene = read_ply(source);
  scene.name = valid_utf8(path.stem().string());  // reports and pages are UTF-8
  return scene;
}

std::size_t write_ply(std::ostream& stream, const Scene& scene, const glm::dvec3& origin) {
  check_consistent(scene);
  const int k_count = sh_rest_count(scene.sh_degree);
  std::vector<std::size_t> usable;
  for (std::size_t i = 0; i < scene.gaussians.size(); ++i) {
    ActivatedGaussian ignored;
    if (activate(scene, i, ignored) != Cull::kNonFinite) usable.push_back(i);
  }
  stream << "ply\nformat binary_little_endian 1.0\n";
  if (scene.antialiased) stream << "comment antialiased 1\n";
  if (origin != glm::dvec3(0)) stream << fmt::format("comment {} {} {} {}\n", kOriginKey, origin.x, origin.y, origin.z);
  stream << "element vertex " << usable.size() << "\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "f_dc_0", "f_dc_1", "f_dc_2"}) {
    stream << "property float " << name << "\n";
  }
  for (int i = 0; i < 3 * k_count; ++i) stream << "property float f_rest_" << i << "\n";
  for (const char* name : kNames) stream << "property float " << name << "\n";
  stream << "end_header\n";
  std::vector<float> row;
  for (const std::size_t i : usable) {
    const Gaussian& g = scene.gaussians[i];
    row.assign({g.mean.x, g.mean.y, g.mean.z, 0, 0, 0, g.sh_dc.x, g.sh_dc.y, g.sh_dc.z});
    const float* sh = sh_rest_of(scene, i);
    for (int c = 0; c < 3; ++c) {
      for (int k = 0; k < k_count; ++k) row.push_back(sh[k * 3 + c]);
    }
    const auto largest = static_cast<float>(kLargestLogit);
    row.push_back(std::isinf(g.opacity_logit) ? std::copysign(largest, g.opacity_logit) : g.opacity_logit);
    for (int k = 0; k < 3; ++k) row.push_back(std::isinf(g.log_scale[k]) ? log_of(0) : g.log_scale[k]);
    for (int k = 0; k < 4; ++k) row.push_back(g.rotation[k]);
    stream.write(reinterpret_cast<const char*>(row.data()), static_cast<std::streamsize>(row.size() * sizeof(float)));
  }
  return scene.gaussians.size() - usable.size();
}

std::size_t write_ply(const std::filesystem::path& path, const Scene& scene, const glm::dvec3& origin) {
  AtomicFile out(path);
  std::ofstream stream(out.temporary(), std::ios::binary);
  const std::size_t left_out = write_ply(stream, scene, origin);
  stream.close();
  if (!stream) throw OwnFailure(path.string() + ": cannot write");
  out.commit();
  return left_out;
}

}  // namespace pipegs
