// SPDX-License-Identifier: Apache-2.0
// sog: PlayCanvas's SOG: textures of WebP that hold a Gaussian in each texel, and a meta.json that says how.
//
// Layout  means (low and high bytes), quaternions, scales, colour with opacity, and SH as a palette with a label for
//         each Gaussian. Version 2 has codebooks of 256 values, version 1 (without "version") ranges; version 1 stores
//         the logit of the opacity. A bundle is a zip of the same files (read_scene unpacks it).
// Rule    The textures hold at least `count` texels, and not many more. What `count` makes of them is held against the
//         bytes of their files (unpack.hpp) before the first is decoded. A quaternion without a valid tag is 1.
// Errors  InputError with the key of meta.json, or the file of a texture.
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <numbers>

#include "scenes/formats/format.hpp"
#include "scenes/input_error.hpp"
#include "scenes/packed/unpack.hpp"
#include "scenes/text/json_node.hpp"

namespace pipegs {
namespace {

constexpr std::uint64_t kMostGaussians = std::uint64_t{1} << 28;  // texels of the largest WebP picture: 16383 squared
constexpr std::uint64_t kPalette = 65536;
constexpr int kPaletteRow = 64;
constexpr std::size_t kCodebook = 256;

using Codebook = std::vector<double>;

// What a byte means in each of the channels: an entry of a codebook, or a place in a range.
struct Channels {
  std::vector<Codebook> values;

  static Channels of_codebook(const JsonNode& node) { return {{node["codebook"].reals(kCodebook)}}; }
  static Channels of_ranges(const std::vector<double>& lows, const std::vector<double>& highs) {
    Channels channels;
    for (std::size_t c = 0; c < lows.size(); ++c) {
      Codebook& values = channels.values.emplace_back();
      for (std::size_t v = 0; v < kCodebook; ++v)
        values.push_back(lows[c] + (highs[c] - lows[c]) * (static_cast<double>(v) / 255));
    }
    return channels;
  }
  double operator()(std::size_t channel, std::uint8_t v) const { return values[values.size() == 1 ? 0 : channel][v]; }
};

class Reader {
 public:
  Reader(const InputFile& file, SceneFormat& format, SogBytes& bytes)
      : file_(file), meta_(JsonNode::parse(file.name(), file.text())), format_(format), bytes_(bytes) {}

  Scene read() {
    second_ = meta_.has("version");
    if (second_) meta_["version"].integer(2, 2);
    count_ = (second_ ? meta_["count"] : meta_["means"]["shape"][std::size_t{0}]).integer(0, kMostGaussians);
    open_files();
    Scene scene = scene_of_size(static_cast<std::size_t>(count_), degree_);
    if (meta_.has("antialias")) scene.antialiased = meta_["antialias"].boolean();
    if (meta_.has("model")) scene.antialiased |= meta_["model"].text() == "antialiased";
    read_means(scene);
    read_scales_and_colors(scene);
    read_rotations(scene);
    if (degree_ > 0) read_rest(scene);
    describe();
    return scene;
  }

 private:
  enum File { kLow, kHigh, kScales, kQuats, kColors, kCentroids, kLabels };

  // All files, still packed: what they take tells how much may come out of them.
  void open_files() {
    for (const auto& [key, count] : {std::pair{"means", 2}, {"scales", 1}, {"quats", 1}, {"sh0", 1}, {"shN", 2}}) {
      if (std::string_view(key) == "shN" && (!meta_.has(key) || meta_[key].is_null())) continue;
      const JsonNode names = meta_[key]["files"];
      if (names.size() != static_cast<std::size_t>(count)) names.refuse(fmt::format("{} files", count));
      for (std::size_t i = 0; i < names.size(); ++i)
        bytes_.packed.add(files_.emplace_back(file_.beside(names[i].text())));
    }
    bytes_.unpacked += count_ * 4 * kLabels;
    check_unpacked(file_.name(), "count", bytes_.packed.sum(), bytes_.unpacked);
    // Half of it again, and a row, for what lies behind the last Gaussian.
    most_texels_ = count_ + count_ / 2 + (std::uint64_t{1} << 16);
    if (files_.size() <= kCentroids) return;
    palette_ = unpack_webp(files_[kCentroids], kPalette * static_cast<std::uint64_t>(sh_rest_count(kMaxShDegree)));
    for (int degree = 1; degree <= kMaxShDegree; ++degree) {
      if (palette_.width == kPaletteRow * sh_rest_count(degree)) degree_ = degree;
    }
    if (degree_ == 0) {
      throw InputError(files_[kCentroids].name(), "",
                       fmt::format("found a palette {} texels wide, expected 192, 512 or 960", palette_.width));
    }
    if (meta_["shN"].has("bands"))
      meta_["shN"]["bands"].integer(static_cast<std::uint64_t>(degree_), static_cast<std::uint64_t>(degree_));
  }

  Texture texture(File file) {
    const InputFile& packed = files_[file];
    Texture texture = unpack_webp(packed, most_texels_);
    if (texture.lossy && !bytes_.lossy) {
      bytes_.lossy = true;
      format_.findings.emplace_back(
          "lossy_texture", fmt::format("texture {} was packed with losses, which change its numbers: a server or a "
                                       "program has written it anew",
                                       quote(std::filesystem::path(packed.name()).filename().string())));
    }
    if (texture.rgba.size() / 4 >= count_) return texture;
    throw InputError(packed.name(), "",
                     fmt::format("found {} x {} texels, expected one for each of {} Gaussians", texture.width,
                                 texture.height, count_));
  }

  // What the bytes of the channels of `key` mean.
  Channels channels(const char* key, std::size_t count) const {
    const JsonNode node = meta_[key];
    if (second_) return Channels::of_codebook(node);
    if (count == 1) return Channels::of_ranges({node["mins"].real()}, {node["maxs"].real()});
    return Channels::of_ranges(node["mins"].reals(count), node["maxs"].reals(count));
  }

  void read_means(Scene& scene) {
    const std::vector<double> low = meta_["means"]["mins"].reals(3), high = meta_["means"]["maxs"].reals(3);
    const Texture fine = texture(kLow), coarse = texture(kHigh);
    for (std::size_t i = 0; i < scene.gaussians.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double t = (fine.texel(i)[k] | coarse.texel(i)[k] << 8) / 65535.0;
        const double folded = low[k] + (high[k] - low[k]) * t;
        scene.gaussians[i].mean[static_cast<int>(k)] = narrow(std::copysign(std::expm1(std::abs(folded)), folded));
      }
    }
  }

  void read_scales_and_colors(Scene& scene) {
    const Channels scale = channels("scales", 3), color = channels("sh0", 4);
    const Texture scales = texture(kScales), colors = texture(kColors);
    for (std::size_t i = 0; i < scene.gaussians.size(); ++i) {
      Gaussian& g = scene.gaussians[i];
      for (std::size_t k = 0; k < 3; ++k) {
        g.log_scale[static_cast<int>(k)] = narrow(scale(k, scales.texel(i)[k]));
        g.sh_dc[static_cast<int>(k)] = narrow(color(k, colors.texel(i)[k]));
      }
      const std::uint8_t opacity = colors.texel(i)[3];
      g.opacity_logit = second_ ? logit_of(opacity / 255.0) : narrow(color(3, opacity));
    }
  }

  // Three of w x y z without the largest, whose index stands above kTag in the fourth channel.
  void read_rotations(Scene& scene) {
    constexpr int kTag = 252;
    const Texture quats = texture(kQuats);
    for (std::size_t i = 0; i < scene.gaussians.size(); ++i) {
      const std::uint8_t* texel = quats.texel(i);
      glm::vec4& rotation = scene.gaussians[i].rotation;
      rotation = {1, 0, 0, 0};
      if (texel[3] < kTag) continue;
      const int largest = texel[3] - kTag;
      double sum = 0;
      for (int k = 0, from = 0; k < 4; ++k) {
        if (k == largest) continue;
        const double v = (texel[from++] / 255.0 * 2 - 1) / std::numbers::sqrt2;
        rotation[k] = static_cast<float>(v);
        sum += v * v;
      }
      rotation[largest] = static_cast<float>(std::sqrt(std::max(0.0, 1 - sum)));
    }
  }

  // A label is the place of a Gaussian's coefficients in the palette, 64 to a row; one behind it means none.
  void read_rest(Scene& scene) {
    const Channels value = channels("shN", 1);
    const Texture labels = texture(kLabels);
    const auto coefficients = static_cast<std::size_t>(sh_rest_count(degree_));
    entries_ = static_cast<std::uint64_t>(palette_.height) * kPaletteRow;
    if (meta_["shN"].has("count")) entries_ = meta_["shN"]["count"].integer(0, entries_);
    for (std::size_t i = 0; i < scene.gaussians.size(); ++i) {
      const auto label = static_cast<std::size_t>(labels.texel(i)[0] | labels.texel(i)[1] << 8);
      if (label >= entries_) continue;
      const std::size_t first = label * coefficients;  // rows follow each other without a gap
      for (std::size_t k = 0; k < 3 * coefficients; ++k)
        scene.sh_rest[3 * coefficients * i + k] = narrow(value(0, palette_.texel(first + k / 3)[k % 3]));
    }
  }

  void describe() {
    const char* values = second_ ? "8 bits of a codebook" : "8 bits in a range";
    format_.name = fmt::format("SOG version {}", second_ ? 2 : 1);
    format_.axes = "RDF";
    format_.fields = {
        {"position", "16 bits of its logarithm, in the range of the scene"},
        {"scale", fmt::format("{}, of its logarithm", values)},
        {"rotation", "smallest three of 8 bits"},
        {"opacity", second_ ? "8 bits" : "8 bits of its logit, in a range"},
        {"colour", fmt::format("3 x {}", values)},
        {"SH", degree_ == 0 ? "none" : fmt::format("a palette of {} for all Gaussians, {} each", entries_, values)}};
  }

  const InputFile& file_;
  const JsonNode meta_;
  SceneFormat& format_;
  SogBytes& bytes_;
  bool second_ = false;
  std::uint64_t count_ = 0, most_texels_ = 0, entries_ = 0;
  int degree_ = 0;
  std::vector<InputFile> files_;  // by File
  Texture palette_;
};

}  // namespace

Scene read_sog(const InputFile& meta, SceneFormat& format) {
  SogBytes bytes;
  return read_sog(meta, format, bytes);
}

Scene read_sog(const InputFile& meta, SceneFormat& format, SogBytes& bytes) {
  return Reader(meta, format, bytes).read();
}

}  // namespace pipegs
