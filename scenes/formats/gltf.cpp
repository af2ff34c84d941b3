// SPDX-License-Identifier: Apache-2.0
// gltf: .gltf and .glb with KHR_gaussian_splatting, also with .spz inside; every node of the default scene.
//
// Idea    The nodes are walked from the roots, each with its matrix; a primitive becomes a Scene in its own axes, is
//         moved by the matrix, and joins the others. What is in the bytes is found by gltf_data.hpp.
// Rule    glTF has y up: LUF, as splat-transform turns a .ply by 180 degrees about z, and back. An .spz inside is RUB
//         as its specification says, unless it names its own. A matrix is a rotation, a shift and one scale: others
//         make other ellipsoids, and are refused.
//         A node is met once (so a circle ends), a mesh is read once, and what all nodes make of the meshes takes at
//         most kMostUnpacked times the bytes of the file in memory.
// Errors  InputError with the place in the JSON, such as meshes[0].primitives[0].
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <optional>
#include <set>

#include "scenes/check/origin.hpp"
#include "scenes/formats/axes.hpp"
#include "scenes/formats/format.hpp"
#include "scenes/formats/gltf_data.hpp"
#include "scenes/input_error.hpp"
#include "scenes/packed/unpack.hpp"

namespace pipegs {
namespace {

constexpr const char* kSplats = "KHR_gaussian_splatting";
constexpr const char* kSpzNames[] = {"KHR_gaussian_splatting_compression_spz_2",
                                     "KHR_gaussian_splatting_compression_spz", "KHR_spz_gaussian_splats_compression"};
constexpr double kSquare = 1e-4;  // how far a matrix of a file may be from a rotation

glm::dmat4 matrix_of(const JsonNode& node) {
  glm::dmat4 matrix(1.0);
  if (node.has("matrix")) {
    const std::vector<double> v = node["matrix"].reals(16);
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = v[static_cast<std::size_t>(i)];
    if (glm::dvec4(v[3], v[7], v[11], v[15]) != glm::dvec4(0, 0, 0, 1))
      node["matrix"].refuse("0, 0, 0, 1 as its last row");
    return matrix;
  }
  if (node.has("rotation")) {
    const std::vector<double> v = node["rotation"].reals(4);
    const glm::dquat q(v[3], v[0], v[1], v[2]);
    const double length = glm::length(q);
    if (!(length > 0.5 && length < 2)) node["rotation"].refuse("a quaternion of length 1");
    matrix = glm::dmat4(glm::mat3_cast(q / length));
  }
  if (node.has("scale")) {
    const std::vector<double> s = node["scale"].reals(3);
    for (int i = 0; i < 3; ++i) matrix[i] *= s[static_cast<std::size_t>(i)];
  }
  if (node.has("translation")) {
    const std::vector<double> t = node["translation"].reals(3);
    matrix[3] = {t[0], t[1], t[2], 1};
  }
  return matrix;
}

class Reader {
 public:
  Reader(const InputFile& file, SceneFormat& format) : data_(file), file_(file), format_(format) {}

  Scene read() {
    data_.check_required({kSplats, kSpzNames[0], kSpzNames[1], kSpzNames[2], "KHR_mesh_quantization"});
    const JsonNode nodes = data_.json()["nodes"];
    std::vector<std::pair<std::uint64_t, glm::dmat4>> open;
    for (const std::uint64_t root : roots(nodes)) open.emplace_back(root, glm::dmat4(1.0));
    std::reverse(open.begin(), open.end());
    std::set<std::uint64_t> met;
    while (!open.empty()) {
      const auto [index, above] = open.back();
      open.pop_back();
      const JsonNode node = nodes[static_cast<std::size_t>(index)];
      if (!met.insert(index).second) node.refuse("a node with one parent");
      const glm::dmat4 matrix = above * matrix_of(node);
      if (node.has("extensions")) note_extensions(node["extensions"].keys());
      if (node.has("mesh")) place(node, matrix);
      if (!node.has("children")) continue;
      const JsonNode children = node["children"];
      for (std::size_t i = children.size(); i-- > 0;) open.emplace_back(children[i].integer(0, UINT32_MAX), matrix);
    }
    if (!found_) throw InputError(file_.name(), "", fmt::format("found glTF without a primitive of {}", kSplats));
    format_.name = fmt::format("glTF with {}{}", kSplats, spz_ ? ", " + format_.name + " inside" : "");
    if (format_.axes.empty()) format_.axes = spz_ ? "RUB" : "LUF";
    tell_behind(data_.behind(), format_);
    tell_unread();
    if (!draft_.empty())
      format_.findings.emplace_back("other_names",
                                    "attributes under names of the extension's drafts are read: " + draft_);
    if (linear_)
      format_.findings.emplace_back("linear_colors", "its colours are linear, and are blended here as they are");
    Scene scene = joined();
    set_positions(positions_, scene, format_);
    return scene;
  }

 private:
  struct Mesh {
    std::vector<Scene> parts;
    std::uint64_t uses = 0;
  };
  struct Placed {
    Mesh* mesh;
    glm::dmat4 matrix;
  };

  // The nodes of the scene that is shown; of a file without scenes those that are no child.
  std::vector<std::uint64_t> roots(const JsonNode& nodes) {
    const auto all = [](const JsonNode& list) {
      std::vector<std::uint64_t> numbers;
      for (std::size_t i = 0; i < list.size(); ++i) numbers.push_back(list[i].integer(0, UINT32_MAX));
      return numbers;
    };
    const JsonNode& json = data_.json();
    if (json.has("scenes")) {
      const JsonNode scenes = json["scenes"];
      return all(scenes[json.has("scene") ? json["scene"].integer(0, scenes.size() - 1) : 0]["nodes"]);
    }
    format_.findings.emplace_back("no_scene", "the glTF has no scene, only nodes: all that are no child are read");
    std::set<std::uint64_t> children;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].has("children"))
        for (const std::uint64_t child : all(nodes[i]["children"])) children.insert(child);
    }
    std::vector<std::uint64_t> found;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (!children.contains(i)) found.push_back(i);
    return found;
  }

  void place(const JsonNode& node, const glm::dmat4& matrix) {
    const std::uint64_t index = node["mesh"].integer(0, UINT32_MAX);
    const auto [found, fresh] = meshes_.try_emplace(index);
    Mesh& mesh = found->second;
    if (fresh) read_mesh(data_.json()["meshes"][static_cast<std::size_t>(index)], mesh);
    else
      for (const Scene& part : mesh.parts) charge(node, part.gaussians.size(), part.sh_degree);
    if (mesh.parts.empty()) return;
    check_matrix(node, matrix);
    ++mesh.uses;
    placed_.push_back({&mesh, matrix});
  }

  // Of a scene that is about to be.
  void charge(const JsonNode& where, std::uint64_t gaussians, int sh_degree) {
    memory_ += scene_bytes(gaussians, sh_degree);
    check_unpacked(file_.name(), where.where(), data_.bytes(), memory_);
  }

  void read_mesh(const JsonNode& mesh, Mesh& read) {
    const JsonNode primitives = mesh["primitives"];
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const JsonNode primitive = primitives[i];
      const bool extended = primitive.has("extensions");
      const JsonNode extensions = extended ? primitive["extensions"] : primitive;
      const bool splats = extended && extensions.has(kSplats);
      const std::optional<JsonNode> spz = extended ? spz_of(extensions) : std::nullopt;
      if (!splats && !spz) {
        unread_.insert("primitives that are no Gaussian splats");
        continue;
      }
      found_ = true;
      Scene part = spz ? read_spz(data_.view((*spz)["bufferView"]), format_) : read_attributes(primitive["attributes"]);
      spz_ = spz_ || spz.has_value();
      if (spz) charge(primitive, part.gaussians.size(), part.sh_degree);
      if (splats) read_meaning(extensions[kSplats]);
      if (!part.gaussians.empty()) read.parts.push_back(std::move(part));
    }
  }

  // What the extension says of its Gaussians.
  void read_meaning(const JsonNode& extension) {
    const auto is = [&](const char* key, std::initializer_list<std::string_view> known) {
      if (!extension.has(key)) return;
      const std::string value = extension[key].text();
      if (std::find(known.begin(), known.end(), value) == known.end())
        unread_.insert(fmt::format("{} {}", key, quote(value)));
    };
    is("kernel", {"ellipse"});
    is("projection", {"perspective"});
    constexpr const char* kDraftScale = "quantizedPositionScale";
    if (extension.has(kDraftScale) && extension[kDraftScale].real() != 1) unread_.insert(kDraftScale);
    is("sortingMethod", {"cameraDistance"});
    is("colorSpace", {"srgb_rec709_display", "lin_rec709_display", "BT.709-sRGB", "BT.709-LINEAR"});
    if (!extension.has("colorSpace")) return;
    const std::string space = extension["colorSpace"].text();
    linear_ = linear_ || space.starts_with("lin") || space.ends_with("LINEAR");
  }

  void note_extensions(const std::vector<std::string>& names) {
    constexpr std::string_view kKnown[] = {kSplats, kSpzNames[0], kSpzNames[1], kSpzNames[2], "KHR_mesh_quantization"};
    for (const std::string& name : names) {
      const bool harmless = name.find("_materials_") != name.npos || name.find("_texture_") != name.npos ||
                            name.find("metadata") != name.npos || name == "KHR_xmp_json_ld";
      if (!harmless && std::find(std::begin(kKnown), std::end(kKnown), name) == std::end(kKnown))
        unread_.insert("extension " + quote(name));
    }
  }

  // What may change the picture and is in none.
  void tell_unread() {
    const JsonNode& json = data_.json();
    if (json.has("extensionsUsed")) {
      const JsonNode used = json["extensionsUsed"];
      std::vector<std::string> names;
      for (std::size_t i = 0; i < used.size(); ++i) names.push_back(used[i].text());
      note_extensions(names);
    }
    if (json.has("extensions")) note_extensions(json["extensions"].keys());
    if (unread_.empty()) return;
    constexpr std::size_t kShown = 4;
    std::string text;
    std::size_t shown = 0;
    for (const std::string& one : unread_) {
      if (shown++ < kShown) text += (text.empty() ? "" : ", ") + one;
    }
    if (unread_.size() > kShown) text += fmt::format(" and {} more", unread_.size() - kShown);
    format_.findings.emplace_back("not_read", fmt::format("parts of the glTF that are not read: {}", text));
  }

  static std::optional<JsonNode> spz_of(const JsonNode& extensions) {
    for (const char* name : kSpzNames) {
      if (extensions.has(name)) return extensions[name];
      if (!extensions.has(kSplats) || !extensions[kSplats].has("extensions")) continue;
      if (extensions[kSplats]["extensions"].has(name)) return extensions[kSplats]["extensions"][name];
    }
    return std::nullopt;
  }

  static double scale_of(const glm::dmat4& matrix) { return std::cbrt(std::abs(glm::determinant(glm::dmat3(matrix)))); }

  void check_matrix(const JsonNode& node, const glm::dmat4& matrix) const {
    const double scale = scale_of(matrix);
    const glm::dmat3 turn = glm::dmat3(matrix) / scale;
    const glm::dmat3 rest = glm::transpose(turn) * turn - glm::dmat3(1.0);
    for (int i = 0; i < 9; ++i) {
      if (!(std::abs(rest[i / 3][i % 3]) < kSquare) || !(scale > 0))
        throw InputError(file_.name(), node.where(), "its matrix is no rotation with one scale, which is what is read");
    }
  }

  Scene read_attributes(const JsonNode& attributes) {
    const auto accessor = [&](const std::string& name, std::uint64_t width) {
      return data_.accessor(attributes[name.c_str()], width);
    };
    std::string prefix = std::string(kSplats) + ":";
    const auto has = [&](const std::string& name) { return attributes.has(name.c_str()); };
    for (const std::string other : {"_", "KHR_gaussian_splatting:_"}) {
      if (!has(prefix + "SCALE") && has(other + "SCALE")) prefix = other;
    }
    // In drafts COLOR_0 is a colour from 0 to 1 and the opacity.
    const bool joined = prefix.ends_with('_') && has("COLOR_0") && !has(prefix + "OPACITY");
    if (prefix.ends_with('_')) draft_ = fmt::format("{0}ROTATION, {0}SCALE{1}", prefix, joined ? ", COLOR_0" : "");
    const GltfAccessor position = accessor("POSITION", 3), rotation = accessor(prefix + "ROTATION", 4);
    const GltfAccessor scale = accessor(prefix + "SCALE", 3),
                       opacity = joined ? accessor("COLOR_0", 4) : accessor(prefix + "OPACITY", 1);
    std::vector<GltfAccessor> sh(joined ? 1 : 0, opacity);
    int degree = joined ? 0 : -1;
    for (int l = degree + 1; l <= kMaxShDegree; ++l) {
      if (!has(fmt::format("{}SH_DEGREE_{}_COEF_0", prefix, l)) && l > 0) break;
      for (int n = 0; n <= 2 * l; ++n) sh.push_back(accessor(fmt::format("{}SH_DEGREE_{}_COEF_{}", prefix, l, n), 3));
      degree = l;
    }
    for (const GltfAccessor* other : {&rotation, &scale, &opacity}) check_count(attributes, *other, position.count);
    for (const GltfAccessor& other : sh) check_count(attributes, other, position.count);
    charge(attributes, position.count, degree);
    Scene scene = scene_of_size(static_cast<std::size_t>(position.count), degree);
    const std::size_t rest = sh.size() - 1;
    for (std::size_t i = 0; i < scene.gaussians.size(); ++i) {
      Gaussian& g = scene.gaussians[i];
      for (int k = 0; k < 3; ++k) {
        g.mean[k] = narrow(position.value(i, k));
        g.log_scale[k] = narrow(scale.value(i, k));
        g.sh_dc[k] = joined ? dc_of(sh[0].value(i, k)) : narrow(sh[0].value(i, k));
        for (std::size_t n = 0; n < rest; ++n)
          scene.sh_rest[3 * (rest * i + n) + static_cast<std::size_t>(k)] = narrow(sh[n + 1].value(i, k));
      }
      g.opacity_logit = narrow(opacity.value(i, joined ? 3 : 0));
      for (int k = 0; k < 4; ++k) g.rotation[k] = narrow(rotation.value(i, (k + 3) % 4));  // x y z w
    }
    take_linear_scales(scene, format_);
    take_opacities(scene);
    format_.fields = {{"position", position.type()}, {"scale", scale.type() + ", linear"},
                      {"rotation", rotation.type()}, {"opacity", opacity.type()},
                      {"colour", sh[0].type()},      {"SH", rest > 0 ? sh[1].type() : "none"}};
    return scene;
  }

  // Opacities from 0 to 1; where many are others they are logits, as those of drafts; single ones are rounded, or
  // culled.
  void take_opacities(Scene& scene) {
    constexpr float kRounded = 1e-3f;
    const auto outside = [](const Gaussian& g) { return g.opacity_logit < 0 || g.opacity_logit > 1; };
    if (are_many(scene, outside)) {
      format_.findings.emplace_back("logit_opacities",
                                    "opacities lie outside 0 to 1, which the format means: they are taken as logits");
      return;
    }
    for (Gaussian& g : scene.gaussians) {
      const float alpha = std::clamp(g.opacity_logit, 0.0f, 1.0f);
      const bool rounded = std::abs(g.opacity_logit - alpha) <= kRounded;
      g.opacity_logit = rounded ? logit_of(alpha) : std::numeric_limits<float>::quiet_NaN();
    }
  }

  void check_count(const JsonNode& attributes, const GltfAccessor& accessor, std::uint64_t count) const {
    if (accessor.count == count) return;
    throw InputError(file_.name(), attributes.where(),
                     fmt::format("found accessors of {} and of {} elements, expected as many", count, accessor.count));
  }

  // Each mesh as often as nodes show it; a mesh is no longer kept than it is needed.
  Scene joined() {
    Scene scene;
    std::uint64_t count = 0;
    for (const Placed& one : placed_) {
      for (const Scene& part : one.mesh->parts) {
        scene.sh_degree = std::max(scene.sh_degree, part.sh_degree);
        scene.antialiased |= part.antialiased;
        count += part.gaussians.size();
      }
    }
    check_scene_memory(count, scene.sh_degree);
    const bool alone = placed_.size() == 1 && placed_[0].mesh->parts.size() == 1;
    if (!alone) scene.gaussians.reserve(count);
    for (const Placed& one : placed_) {
      const bool last = --one.mesh->uses == 0;
      for (Scene& kept : one.mesh->parts) {
        Scene part = last ? std::move(kept) : kept;
        const double scale = scale_of(one.matrix);
        const glm::dmat3 turn = glm::dmat3(one.matrix) / scale;
        for (const Gaussian& g : part.gaussians)
          positions_.push_back(scale * (turn * glm::dvec3(g.mean)) + glm::dvec3(one.matrix[3]));
        transform(part, turn, scale);
        if (alone) return part;
        append(scene, part, 0, part.gaussians.size());
      }
      if (last) one.mesh->parts.clear();
    }
    return scene;
  }

  GltfData data_;
  const InputFile& file_;
  SceneFormat& format_;
  bool spz_ = false, linear_ = false, found_ = false;
  std::string draft_;             // names of attributes
  std::set<std::string> unread_;  // in words
  std::uint64_t memory_ = 0;
  std::map<std::uint64_t, Mesh> meshes_;  // by index
  std::vector<Placed> placed_;            // in the order of the walk
  std::vector<glm::dvec3> positions_;     // of all parts, in double
};

}  // namespace

Scene read_gltf(const InputFile& file, SceneFormat& format) { return Reader(file, format).read(); }

}  // namespace pipegs
