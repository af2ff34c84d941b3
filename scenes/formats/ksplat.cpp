// SPDX-License-Identifier: Apache-2.0
// ksplat: .ksplat of GaussianSplats3D, levels 0 (floats), 1 (16 bits) and 2 (SH in 8 bits); SH degree 0 to 3.
//
// Layout  A header of 4096 bytes, a header of 1024 bytes for each section, then the sections: how many Gaussians the
//         buckets have that are not full, the centres of the buckets, rows of Gaussians. Positions of levels 1 and 2
//         count from the centre of their bucket. SH: for each degree all of R, all of G, all of B.
// Rule    The file has no signature either: version 0.x, level, sections and counts must agree with its size. A section
//         has room for its largest count, and the next one begins behind that. A 0 in the place of a range means the
//         range of the first versions.
// Errors  InputError with the section and what does not fit in the file.
#include <fmt/format.h>

#include <glm/gtc/packing.hpp>

#include "scenes/formats/format.hpp"
#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

constexpr std::uint64_t kHeader = 4096, kSectionHeader = 1024;
constexpr std::uint32_t kMostSections = 1024;

struct Header {
  std::uint32_t most_sections, sections, most_splats, splats;
  int level;
  double sh_low, sh_high;

  explicit Header(const InputFile& file)
      : most_sections(file.at<std::uint32_t>(4, "header")),
        sections(file.at<std::uint32_t>(8, "header")),
        most_splats(file.at<std::uint32_t>(12, "header")),
        splats(file.at<std::uint32_t>(16, "header")),
        level(file.at<std::uint16_t>(20, "header")),
        sh_low(file.at<float>(36, "header")),
        sh_high(file.at<float>(40, "header")) {
    if (sh_low == 0) sh_low = -1.5;
    if (sh_high == 0) sh_high = 1.5;
  }
};

struct Section {
  std::uint32_t count, most, bucket_size, buckets, bucket_bytes, full, partial;
  double half_block, range;
  int degree;

  Section(const InputFile& file, std::uint64_t at, int level, const std::string& where)
      : count(file.at<std::uint32_t>(at, where)),
        most(file.at<std::uint32_t>(at + 4, where)),
        bucket_size(file.at<std::uint32_t>(at + 8, where)),
        buckets(file.at<std::uint32_t>(at + 12, where)),
        bucket_bytes(file.at<std::uint16_t>(at + 20, where)),
        full(file.at<std::uint32_t>(at + 32, where)),
        partial(file.at<std::uint32_t>(at + 36, where)),
        half_block(file.at<float>(at + 16, where) / 2.0),
        range(file.at<std::uint32_t>(at + 24, where)),
        degree(file.at<std::uint16_t>(at + 40, where)) {
    const auto refuse = [&](const std::string& what) { throw InputError(file.name(), where, what); };
    if (range == 0) range = level == 0 ? 1 : 32767;
    if (degree > kMaxShDegree) refuse(fmt::format("found SH degree {}, expected 0 to 3", degree));
    if (count > most)
      refuse(fmt::format("found {} Gaussians, expected at most the {} that it has room for", count, most));
    if (level == 0 || count == 0) return;
    if (bucket_bytes < 12) refuse(fmt::format("found centres of {} bytes, expected 12", bucket_bytes));
    if (std::uint64_t{full} + partial > buckets)
      refuse(fmt::format("found {} full and {} other buckets, expected {} in all", full, partial, buckets));
    if (full > 0 && bucket_size == 0) refuse("found full buckets of 0 Gaussians");
  }
};

class Reader {
 public:
  Reader(const InputFile& file, SceneFormat& format) : file_(file), header_(file), format_(format) {}

  Scene read() {
    describe();
    int degree = 0;
    std::vector<Section> sections;
    for (std::uint32_t s = 0; s < header_.most_sections; ++s) {
      sections.emplace_back(file_, kHeader + kSectionHeader * s, header_.level, fmt::format("section {}", s));
      if (s < header_.sections) degree = std::max(degree, sections.back().degree);
    }
    std::uint64_t at = kHeader + kSectionHeader * header_.most_sections, count = 0;
    for (const Section& section : sections) count += section.count;
    // Before memory is taken for them: no record is shorter than 24 bytes.
    file_.rows(at, count, 24, "Gaussians of all sections");
    scene_ = scene_of_size(static_cast<std::size_t>(count), degree);
    for (std::size_t s = 0; s < sections.size(); ++s) at = read_section(sections[s], at, fmt::format("section {}", s));
    tell_behind(file_.behind(at), format_);
    take_linear_scales(scene_, format_);
    return std::move(scene_);
  }

 private:
  void describe() {
    const int level = header_.level;
    format_.name = fmt::format(".ksplat level {}", level);
    format_.axes = "RDF";
    format_.fields = {{"position", level == 0 ? "float32" : "16 bits in a bucket"},
                      {"scale", level == 0 ? "float32, linear" : "float16, linear"},
                      {"rotation", level == 0 ? "float32" : "4 x float16"},
                      {"opacity", "8 bits"},
                      {"colour", "3 x 8 bits, cut to 0 .. 1"},
                      {"SH", level == 0   ? "float32"
                             : level == 1 ? "float16"
                                          : fmt::format("8 bits from {:g} to {:g}", header_.sh_low, header_.sh_high)}};
  }

  std::uint64_t read_section(const Section& section, std::uint64_t at, const std::string& where) {
    const int level = header_.level;
    const std::uint64_t coefficients = 3 * static_cast<std::uint64_t>(sh_rest_count(section.degree));
    const std::uint64_t stride = level == 0 ? 44 + 4 * coefficients : 24 + coefficients * (level == 1 ? 2 : 1);
    const std::uint8_t* sizes = file_.rows(at, section.partial, 4, where + ", sizes of buckets");
    at += 4 * std::uint64_t{section.partial};
    const std::uint64_t bucket_bytes = std::max<std::uint32_t>(section.bucket_bytes, 1);
    const std::uint8_t* centres = file_.rows(at, section.buckets, bucket_bytes, where + ", buckets");
    at += section.bucket_bytes * std::uint64_t{section.buckets};
    const std::uint8_t* row = file_.rows(at, section.count, stride, where + ", Gaussians");
    std::uint64_t bucket = 0, left = 0, partial = 0;  // left: of the bucket that is read
    for (std::uint32_t i = 0; i < section.count; ++i, row += stride) {
      Gaussian& g = scene_.gaussians[done_];
      if (level == 0) {
        for (int k = 0; k < 3; ++k) g.mean[k] = load<float>(row + 4 * k);
      } else {
        for (; left == 0; ++bucket) {
          if (bucket < section.full) {
            left = section.bucket_size;
          } else if (partial < section.partial) {
            left = load<std::uint32_t>(sizes + 4 * partial++);
          } else {
            throw InputError(file_.name(), where,
                             fmt::format("found buckets of {} Gaussians, expected {}", i, section.count));
          }
        }
        --left;
        const std::uint8_t* centre = centres + (bucket - 1) * bucket_bytes;
        for (int k = 0; k < 3; ++k) {
          g.mean[k] = narrow((load<std::uint16_t>(row + 2 * k) - section.range) * (section.half_block / section.range) +
                             load<float>(centre + 4 * k));
        }
      }
      const std::uint8_t* value = row + (level == 0 ? 12 : 6);
      const auto next = [&] {
        const float v = level == 0 ? load<float>(value) : glm::unpackHalf1x16(load<std::uint16_t>(value));
        value += level == 0 ? 4 : 2;
        return v;
      };
      for (int k = 0; k < 3; ++k) g.log_scale[k] = next();
      for (int k = 0; k < 4; ++k) g.rotation[k] = next();
      for (int k = 0; k < 3; ++k) g.sh_dc[k] = dc_of(*value++ / 255.0);
      g.opacity_logit = logit_of(*value++ / 255.0);
      float* rest = scene_.sh_rest.data() + done_ * 3 * static_cast<std::size_t>(sh_rest_count(scene_.sh_degree));
      for (int band = 1; band <= section.degree; ++band) {
        for (int channel = 0; channel < 3; ++channel) {
          for (int k = sh_rest_count(band - 1); k < sh_rest_count(band); ++k) {
            rest[3 * k + channel] =
                level == 2 ? narrow(header_.sh_low + *value++ / 255.0 * (header_.sh_high - header_.sh_low)) : next();
          }
        }
      }
      ++done_;
    }
    return at + stride * section.most;
  }

  const InputFile& file_;
  const Header header_;
  SceneFormat& format_;
  Scene scene_;
  std::size_t done_ = 0;
};

}  // namespace

bool looks_like_ksplat(const InputFile& file) {
  if (file.size() < kHeader || file.text()[0] != 0 || file.text()[1] < 1) return false;
  const Header header(file);
  return header.level <= 2 && header.sections >= 1 && header.sections <= header.most_sections &&
         header.most_sections <= kMostSections && header.splats <= header.most_splats &&
         header.most_sections <= (file.size() - kHeader) / kSectionHeader;
}

Scene read_ksplat(const InputFile& file, SceneFormat& format) { return Reader(file, format).read(); }

}  // namespace pipegs
