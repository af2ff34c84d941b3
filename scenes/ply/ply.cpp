// SPDX-License-Identifier: Apache-2.0
// ply: the meaning of INRIA's properties; see ply.hpp for what is accepted.
//
// Idea    A Gaussian is one row of kRest + 3*K floats in the order of kRequired; the header decides
//         which property fills which slot, then ply_body fills rows without knowing the meaning.
// Layout  f_rest is channel-major in the file, f_rest[c * K + k]; Scene::sh_rest is
//         coefficient-major. The transposition happens in the slot numbers, so it costs nothing.
#include "scenes/ply/ply.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>

#include "scenes/atomic_file.hpp"
#include "scenes/input_error.hpp"
#include "scenes/own_failure.hpp"
#include "scenes/ply/ply_file.hpp"
#include "scenes/text/json.hpp"
#include "scenes/text/number.hpp"

namespace pipegs {
namespace {

constexpr std::array kNames = {"x",       "y",       "z",       "f_dc_0", "f_dc_1", "f_dc_2", "opacity",
                               "scale_0", "scale_1", "scale_2", "rot_0",  "rot_1",  "rot_2",  "rot_3"};
enum Slot { kX = 0, kDc = 3, kOpacity = 6, kScale = 7, kRotation = 10, kRest = 14 };
constexpr int kThirdScale = kScale + 2;
constexpr std::string_view kRestPrefix = "f_rest_";
constexpr int kMostRest = 9999;  // to be counted and refused, far above the 44 that degree 3 has

// The number behind "f_rest_", or -1 if this is another property: f_rest_07 is one, so that none has two names.
int rest_number(const std::string& name) {
  if (!name.starts_with(kRestPrefix)) return -1;
  try {
    const int number = parse_integer(name.substr(kRestPrefix.size()), 0, kMostRest);
    return name == fmt::format("{}{}", kRestPrefix, number) ? number : -1;
  } catch (const NumberError&) { return -1; }
}

int degree_of(const std::string& file, const PlyElement& vertex) {
  int count = 0, highest = -1;
  for (const PlyProperty& property : vertex.properties) {
    const int number = rest_number(property.name);
    if (number < 0) continue;
    ++count;
    highest = std::max(highest, number);
  }
  for (int degree = 0; degree <= kMaxShDegree; ++degree) {
    if (count == 3 * sh_rest_count(degree) && highest == count - 1) return degree;
  }
  throw InputError(
      file, fmt::format("line {}, f_rest", vertex.line),
      fmt::format("found {} properties numbered up to {}, expected 0, 9, 24 or 45 numbered from 0", count, highest));
}

// For each property of the vertex element its place in the row.
std::vector<int> slots_of(const std::string& file, const PlyElement& vertex, int degree) {
  const int k_count = sh_rest_count(degree);
  std::array<bool, kNames.size()> present{};
  std::vector<int> slots;
  for (const PlyProperty& property : vertex.properties) {
    int slot = kSkip;
    const auto known = std::find(kNames.begin(), kNames.end(), property.name);
    if (known != kNames.end()) {
      slot = static_cast<int>(known - kNames.begin());
      present[static_cast<std::size_t>(slot)] = true;
    } else if (const int number = rest_number(property.name); number >= 0) {
      slot = kRest + (number % k_count) * 3 + number / k_count;
    }
    if (slot != kSkip && property.is_list) {
      throw InputError(file, fmt::format("line {}, {}", property.line, property.name),
                       "found a list, expected a scalar property");
    }
    slots.push_back(slot);
  }
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (present[i] || i == kThirdScale) continue;
    throw InputError(
        file, fmt::format("line {}, element vertex", vertex.line),
        fmt::format("property {} is missing, expected the properties of INRIA's point_cloud.ply", kNames[i]));
  }
  return slots;
}

void read_vertices(PlySource& source, PlyFormat format, const PlyElement& vertex, Scene& scene) {
  scene.sh_degree = degree_of(source.file(), vertex);
  const std::vector<int> slots = slots_of(source.file(), vertex, scene.sh_degree);
  check_fits(source, format, vertex);
  const auto rest = static_cast<std::size_t>(3 * sh_rest_count(scene.sh_degree));
  const auto count = static_cast<std::size_t>(vertex.count);
  scene.gaussians.resize(count);
  scene.sh_rest.resize(count * rest);
  std::vector<float> row(kRest + rest, 0.0f);
  row[kThirdScale] = -std::numeric_limits<float>::infinity();  // stays so for a 2DGS file: flat
  read_rows(source, format, vertex, slots, row, [&](std::size_t i) {
    Gaussian& g = scene.gaussians[i];
    const float* v = row.data();
    g.mean = {v[kX], v[kX + 1], v[kX + 2]};
    g.sh_dc = {v[kDc], v[kDc + 1], v[kDc + 2]};
    g.opacity_logit = v[kOpacity];
    g.log_scale = {v[kScale], v[kScale + 1], v[kScale + 2]};
    for (int k = 0; k < 4; ++k) g.rotation[k] = v[kRotation + k];
    if (rest > 0) std::memcpy(scene.sh_rest.data() + i * rest, v + kRest, rest * sizeof(float));
  });
}

}  // namespace

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

Scene read_ply(PlySource& source, const PlyHeader& header) {
  Scene scene;
  scene.antialiased = says_antialiased(header);
  bool has_vertices = false;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      read_vertices(source, header.format, element, scene);
      has_vertices = true;
      continue;
    }
    std::vector<float> nothing;
    read_rows(source, header.format, element, std::vector<int>(element.properties.size(), kSkip), nothing,
              [](std::size_t) {});
  }
  if (!has_vertices)
    throw InputError(source.file(), "header", "element 'vertex' is missing, expected a Gaussian per vertex");
  check_end(source, header);
  return scene;
}

Scene read_ply(PlySource& source) { return read_ply(source, read_ply_header(source)); }

Scene read_ply(const std::filesystem::path& path) {
  PlySource source(path);
  Scene scene = read_ply(source);
  scene.name = valid_utf8(path.stem().string());  // reports and pages are UTF-8
  return scene;
}

void write_ply(std::ostream& stream, const Scene& scene) {
  check_consistent(scene);
  const int k_count = sh_rest_count(scene.sh_degree);
  stream << "ply\nformat binary_little_endian 1.0\n";
  if (scene.antialiased) stream << "comment antialiased 1\n";
  stream << "element vertex " << scene.gaussians.size() << "\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "f_dc_0", "f_dc_1", "f_dc_2"}) {
    stream << "property float " << name << "\n";
  }
  for (int i = 0; i < 3 * k_count; ++i) stream << "property float " << kRestPrefix << i << "\n";
  for (std::size_t i = kOpacity; i < kNames.size(); ++i) stream << "property float " << kNames[i] << "\n";
  stream << "end_header\n";
  std::vector<float> row;
  for (std::size_t i = 0; i < scene.gaussians.size(); ++i) {
    const Gaussian& g = scene.gaussians[i];
    row.assign({g.mean.x, g.mean.y, g.mean.z, 0, 0, 0, g.sh_dc.x, g.sh_dc.y, g.sh_dc.z});
    const float* sh = sh_rest_of(scene, i);
    for (int c = 0; c < 3; ++c) {
      for (int k = 0; k < k_count; ++k) row.push_back(sh[k * 3 + c]);
    }
    row.push_back(g.opacity_logit);
    for (int k = 0; k < 3; ++k) row.push_back(g.log_scale[k]);
    for (int k = 0; k < 4; ++k) row.push_back(g.rotation[k]);
    stream.write(reinterpret_cast<const char*>(row.data()), static_cast<std::streamsize>(row.size() * sizeof(float)));
  }
}

void write_ply(const std::filesystem::path& path, const Scene& scene) {
  AtomicFile out(path);
  std::ofstream stream(out.temporary(), std::ios::binary);
  write_ply(stream, scene);
  stream.close();
  if (!stream) throw OwnFailure(path.string() + ": cannot write");
  out.commit();
}

}  // namespace pipegs
