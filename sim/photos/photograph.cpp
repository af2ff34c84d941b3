// SPDX-License-Identifier: Apache-2.0
// photograph: see photograph.hpp.
//
// Idea    libjpeg and libpng report an error by a call that must not return. It jumps back into decode_jpeg() or
//         decode_png(), which hold nothing that would have to be destroyed; what they write to lies with their caller.
//         To fewer pixels by rows first, then columns: a new pixel is a sum of old ones, each with the length of its
//         overlap.
#include "sim/photos/photograph.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

// These need <cstdio>.
#include <jerror.h>
#include <jpeglib.h>

#include "scenes/input_error.hpp"
#include "scenes/text/foreign.hpp"
#include "scenes/text/text_file.hpp"
#include "sim/photos/color_profile.hpp"

namespace pipegs {
namespace {

constexpr int kExif = JPEG_APP0 + 1, kIcc = JPEG_APP0 + 2;
constexpr double kMostScale = 64;                                      // of a picture's sides over its camera's
constexpr std::int64_t kMostPixels = std::int64_t{1} << 28;            // of a picture that is larger than its camera
constexpr double kGamma = 1 / 2.2, kGammaTolerance = 0.05;             // sRGB's as gAMA says it; libpng's own threshold
constexpr std::array kPrimaries = {0.64, 0.33, 0.3, 0.6, 0.15, 0.06};  // its red, green and blue
constexpr double kPrimaryTolerance = 0.01;

struct Stored {
  Rgb8 picture;
  int orientation = 1;  // of EXIF
  bool inks = false, deep = false, gamma = false;
  std::string profile;  // bytes
  std::string colors;   // without a profile the name of colours that are not sRGB's
};

struct Decoding {
  jpeg_error_mgr errors;  // the first, so that libjpeg's pointer to it is one to all of this
  std::jmp_buf back;
  char message[JMSG_LENGTH_MAX];
  const std::function<bool(const Stored&)>* wanted;  // of its size, before pixels are decoded
};

// The same view with other pixels, which cover the same rectangle.
Camera stretched(Camera camera, int width, int height) {
  const double x = static_cast<double>(width) / camera.width, y = static_cast<double>(height) / camera.height;
  camera.cx = (camera.cx + 0.5) * x - 0.5;
  camera.cy = (camera.cy + 0.5) * y - 0.5;
  camera.fx *= x;
  camera.fy *= y;
  camera.width = width;
  camera.height = height;
  return camera;
}

void leave(j_common_ptr shared) {
  auto* decoding = reinterpret_cast<Decoding*>(shared->err);
  shared->err->format_message(shared, decoding->message);
  std::longjmp(decoding->back, 1);
}

// Warnings: those that leave pixels undecoded are errors.
void judge(j_common_ptr shared, int level) {
  const int code = shared->err->msg_code;
  if (level < 0 && (code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER || code == JWRN_HUFF_BAD_CODE)) leave(shared);
}

// A tag of EXIF, of its first directory or the one below it; 0 where there is none.
std::uint32_t exif_tag(std::string_view tiff, std::uint32_t tag) {
  const bool big = tiff.starts_with("MM");
  const auto number = [&](std::size_t at, std::size_t bytes) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < bytes && at + bytes <= tiff.size(); ++k)
      value |= static_cast<std::uint32_t>(static_cast<unsigned char>(tiff[at + k])) << 8 * (big ? bytes - 1 - k : k);
    return value;
  };
  constexpr std::uint32_t kBelow = 0x8769, kLong = 4;
  std::size_t directory = number(4, 4), below = 0;
  for (int level = 0; level < 2; ++level, directory = below) {
    for (std::size_t i = 0; i < number(directory, 2); ++i) {
      const std::size_t entry = directory + 2 + 12 * i;
      if (entry + 12 > tiff.size()) break;
      const std::uint32_t value = number(entry + 8, number(entry + 2, 2) == kLong ? 4 : 2);
      if (number(entry, 2) == tag) return value;
      if (number(entry, 2) == kBelow) below = value;
    }
    if (below == 0) break;
  }
  return 0;
}

void take_exif(std::string_view tiff, Stored& out) {
  const std::uint32_t turn = exif_tag(tiff, 0x0112), space = exif_tag(tiff, 0xa001);
  if (turn >= 1 && turn <= 8) out.orientation = static_cast<int>(turn);
  if (space > 1) out.colors = space == 2 ? "Adobe RGB, as EXIF says" : "not sRGB, as EXIF says";
}

// What the markers say. A profile may lie in several of them, in their order.
void take_markers(const jpeg_decompress_struct& jpeg, Stored& out) {
  constexpr std::string_view kExifBegins("Exif\0\0", 6), kIccBegins("ICC_PROFILE\0", 12);
  for (jpeg_saved_marker_ptr marker = jpeg.marker_list; marker != nullptr; marker = marker->next) {
    const std::string_view bytes(reinterpret_cast<const char*>(marker->data), marker->data_length);
    if (marker->marker == kExif && bytes.starts_with(kExifBegins) && out.orientation == 1)
      take_exif(bytes.substr(kExifBegins.size()), out);
    const std::size_t numbers = kIccBegins.size() + 2;  // which of how many
    if (marker->marker == kIcc && bytes.starts_with(kIccBegins) && bytes.size() > numbers)
      out.profile += bytes.substr(numbers);
  }
}

// A line of CMYK as RGB. Adobe stores its inks inverted.
void to_rgb(const std::vector<JSAMPLE>& inks, bool inverted, std::uint8_t* out) {
  for (std::size_t i = 0; i < inks.size(); i += 4) {
    const auto light = [&](std::size_t k) {
      return int{inverted ? inks[i + k] : static_cast<JSAMPLE>(255 - inks[i + k])};
    };
    for (std::size_t k = 0; k < 3; ++k) *out++ = static_cast<std::uint8_t>((light(k) * light(3) + 127) / 255);
  }
}

// Whether the picture was decoded into `out`; if not, the message says why. The buffer for a line is the caller's: what
// jumps back destroys nothing.
bool decode_jpeg(std::FILE* file, std::vector<JSAMPLE>& inks, Stored& out, Decoding& decoding) {
  jpeg_decompress_struct jpeg;
  jpeg.err = jpeg_std_error(&decoding.errors);
  decoding.errors.error_exit = leave;
  decoding.errors.emit_message = judge;
  if (setjmp(decoding.back) != 0) {
    jpeg_destroy_decompress(&jpeg);
    return false;
  }
  jpeg_create_decompress(&jpeg);
  jpeg_stdio_src(&jpeg, file);
  for (const int marker : {kExif, kIcc}) jpeg_save_markers(&jpeg, marker, 0xffff);
  jpeg_read_header(&jpeg, TRUE);
  take_markers(jpeg, out);
  out.picture.width = static_cast<int>(jpeg.image_width);
  out.picture.height = static_cast<int>(jpeg.image_height);
  if (!(*decoding.wanted)(out)) {
    decoding.message[0] = '\0';
    jpeg_destroy_decompress(&jpeg);
    return false;
  }
  const std::size_t width = jpeg.image_width;
  out.picture.data.resize(3 * width * jpeg.image_height);
  out.inks = jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK;
  inks.resize(out.inks ? 4 * width : 0);
  jpeg.out_color_space = out.inks ? JCS_CMYK : JCS_RGB;
  jpeg_start_decompress(&jpeg);
  while (jpeg.output_scanline < jpeg.output_height) {
    std::uint8_t* line = out.picture.data.data() + std::size_t{jpeg.output_scanline} * width * 3;
    JSAMPROW row = out.inks ? inks.data() : line;
    jpeg_read_scanlines(&jpeg, &row, 1);
    if (out.inks) to_rgb(inks, jpeg.saw_Adobe_marker != 0, line);
  }
  jpeg_finish_decompress(&jpeg);
  jpeg_destroy_decompress(&jpeg);
  return true;
}

[[noreturn]] void leave_png(png_structp png, png_const_charp message) {
  auto* decoding = static_cast<Decoding*>(png_get_error_ptr(png));
  std::snprintf(decoding->message, sizeof decoding->message, "%s", message);
  png_longjmp(png, 1);
}

void pass_png(png_structp, png_const_charp) {}  // of what is beside the pixels

// What the chunks before the pixels say.
void take_chunks(png_structp png, png_infop info, Stored& out) {
  png_bytep bytes = nullptr;
  png_charp name = nullptr;
  png_uint_32 size = 0;
  int method = 0, intent = 0;
  double gamma = kGamma;
  const bool profiled = png_get_iCCP(png, info, &name, &method, &bytes, &size) != 0;
  if (profiled) out.profile.assign(reinterpret_cast<const char*>(bytes), size);
  if (png_get_eXIf_1(png, info, &size, &bytes) != 0)
    take_exif(std::string_view(reinterpret_cast<const char*>(bytes), size), out);
  const bool named = profiled || png_get_sRGB(png, info, &intent) != 0;
  if (named) out.colors.clear();
  if (!named && png_get_gAMA(png, info, &gamma) != 0) out.gamma = std::abs(gamma / kGamma - 1) > kGammaTolerance;
  std::array<double, 8> xy{};  // white, red, green, blue
  if (!named && png_get_cHRM(png, info, &xy[0], &xy[1], &xy[2], &xy[3], &xy[4], &xy[5], &xy[6], &xy[7]) != 0) {
    for (std::size_t k = 0; k < kPrimaries.size(); ++k)
      if (std::abs(xy[2 + k] - kPrimaries[k]) > kPrimaryTolerance) out.colors = "primaries of cHRM";
  }
  png_unknown_chunkp chunks = nullptr;
  const int kept = png_get_unknown_chunks(png, info, &chunks);
  if (kept > 0 && chunks[0].size >= 2) {  // cICP, above all others
    out.profile.clear();
    out.colors = foreign_codes(chunks[0].data[0], chunks[0].data[1]);
  }
  out.deep = png_get_bit_depth(png, info) > 8;
  out.picture.width = static_cast<int>(png_get_image_width(png, info));
  out.picture.height = static_cast<int>(png_get_image_height(png, info));
}

// As decode_jpeg().
bool decode_png(std::FILE* file, std::vector<png_bytep>& rows, Stored& out, Decoding& decoding) {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &decoding, leave_png, pass_png);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  if (info == nullptr) throw std::bad_alloc();
  if (setjmp(png_jmpbuf(png)) != 0) {
    png_destroy_read_struct(&png, &info, nullptr);
    return false;
  }
  png_init_io(png, file);
  png_set_alpha_mode(png, PNG_ALPHA_PNG, PNG_DEFAULT_sRGB);  // of the picture, and of the file where it does not say
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_ALWAYS, reinterpret_cast<png_const_bytep>("cICP"), 1);
  png_read_info(png, info);
  take_chunks(png, info, out);
  if (!(*decoding.wanted)(out)) {
    decoding.message[0] = '\0';
    png_destroy_read_struct(&png, &info, nullptr);
    return false;
  }
  png_set_expand(png);
  png_set_scale_16(png);
  png_set_gray_to_rgb(png);
  const png_color_16 black{};
  png_set_background(png, &black, PNG_BACKGROUND_GAMMA_SCREEN, 0, 1);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  const std::size_t bytes = 3 * static_cast<std::size_t>(out.picture.width);
  if (png_get_rowbytes(png, info) != bytes) png_error(png, "its rows are not those of RGB");
  out.picture.data.resize(bytes * static_cast<std::size_t>(out.picture.height));
  for (std::size_t at = 0; at < out.picture.data.size(); at += bytes) rows.push_back(out.picture.data.data() + at);
  png_read_image(png, rows.data());
  png_read_end(png, nullptr);
  png_destroy_read_struct(&png, &info, nullptr);
  return true;
}

// How a picture of so many pixels fits a camera.
enum class Fit { kExactly, kOtherwise, kNot };

Fit fit(int width, int height, const Camera& camera) {
  if (width == camera.width && height == camera.height) return Fit::kExactly;
  const double x = static_cast<double>(width) / camera.width, y = static_cast<double>(height) / camera.height;
  // To whole pixels: a side is rounded.
  const bool same = std::abs(width - y * camera.width) < 1 || std::abs(height - x * camera.height) < 1;
  const bool near =
      std::max(x, y) <= kMostScale && std::min(x, y) >= 1 / kMostScale && std::int64_t{width} * height <= kMostPixels;
  return same && near ? Fit::kOtherwise : Fit::kNot;
}

bool is_turned(int orientation) { return orientation >= 5; }  // by a quarter

// What orientation to take: the stored one where it fits, so that a picture whose pixels were turned already stays.
std::optional<int> taken(const Stored& stored, const Camera& camera) {
  const int w = stored.picture.width, h = stored.picture.height;
  const bool quarter = is_turned(stored.orientation);
  for (const Fit wanted : {Fit::kExactly, Fit::kOtherwise}) {
    if (fit(w, h, camera) == wanted) return 1;
    if (quarter && fit(h, w, camera) == wanted) return stored.orientation;
  }
  return std::nullopt;
}

Rgb8 turned(const Rgb8& stored, int orientation) {
  const int w = stored.width, h = stored.height;
  Rgb8 out{h, w, {}};
  out.data.reserve(stored.data.size());
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      const int column = orientation == 5 || orientation == 6 ? y : w - 1 - y;
      const int row = orientation == 5 || orientation == 8 ? x : h - 1 - x;
      const std::uint8_t* pixel =
          stored.data.data() +
          3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(w) + static_cast<std::size_t>(column));
      out.data.insert(out.data.end(), pixel, pixel + 3);
    }
  }
  return out;
}

[[noreturn]] void refuse_size(const std::filesystem::path& path, const Stored& stored, const Camera& camera) {
  const int w = stored.picture.width, h = stored.picture.height;
  std::string what = fmt::format("found {}x{} pixels, expected {}x{}", w, h, camera.width, camera.height);
  if (is_turned(stored.orientation))
    what += fmt::format(" (its EXIF orientation {} turns it to {}x{})", stored.orientation, h, w);
  else if (w == camera.height && h == camera.width)
    what += ": it is turned by a quarter, and no EXIF orientation says which way; turn the pixels";
  throw InputError(path.string(), "", what);
}

Stored read_stored(const std::filesystem::path& path, const Camera& camera) {
  require_regular_file(path, "a photograph");
  std::string head(512, '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  const bool png = head.starts_with("\x89PNG");
  if (!png && !head.starts_with("\xff\xd8\xff")) {
    refuse_foreign(path.string(), head, "a PNG or a JPEG");
    throw InputError(path.string(), "", "found neither a PNG nor a JPEG, expected a photograph");
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) throw InputError(path.string(), "", "cannot open for reading");
  Stored stored;
  std::vector<JSAMPLE> inks;
  std::vector<png_bytep> rows;
  Decoding decoding;
  const std::function<bool(const Stored&)> wanted = [&](const Stored& found) {
    return taken(found, camera).has_value();
  };
  decoding.wanted = &wanted;
  if (png ? decode_png(file.get(), rows, stored, decoding) : decode_jpeg(file.get(), inks, stored, decoding))
    return stored;
  if (decoding.message[0] == '\0') refuse_size(path, stored, camera);
  throw InputError(path.string(), "", fmt::format("cannot read: {}", decoding.message));
}

struct Overlap {
  int first;
  std::vector<double> lengths;  // of the old pixels from the first on; their sum is 1
};

// What each of `to` pixels covers of `from`.
std::vector<Overlap> overlaps(int from, int to) {
  std::vector<Overlap> all;
  const double side = static_cast<double>(from) / to;
  for (int i = 0; i < to; ++i) {
    const double begin = i * side, end = (i + 1) * side;
    Overlap overlap{static_cast<int>(begin), {}};
    for (int k = overlap.first; k < from && k < end; ++k)
      overlap.lengths.push_back((std::min(end, k + 1.0) - std::max(begin, static_cast<double>(k))) / side);
    all.push_back(std::move(overlap));
  }
  return all;
}

}  // namespace

Photograph read_photograph(const std::filesystem::path& path, const Camera& camera) {
  Stored stored = read_stored(path, camera);
  const int orientation = *taken(stored, camera);
  Photograph photograph{.picture = std::move(stored.picture),
                        .camera = camera,
                        .turned = orientation != 1,
                        .unturned = orientation != stored.orientation,
                        .inks = stored.inks,
                        .deep = stored.deep,
                        .gamma = stored.gamma,
                        .profile = stored.profile.empty() ? stored.colors : foreign_profile(stored.profile)};
  const Rgb8& picture = photograph.picture;
  if (photograph.turned) photograph.picture = turned(picture, orientation);
  photograph.resized = picture.width != camera.width || picture.height != camera.height;
  if (photograph.resized) photograph.camera = stretched(camera, picture.width, picture.height);
  return photograph;
}

void PhotographFindings::add(const std::string& name, const Photograph& photograph) {
  ++photographs_;
  const auto found = [&](const char* key, bool is, const std::string& detail = "") {
    if (is && found_[key].count++ == 0) found_[key].first = name, found_[key].detail = detail;
  };
  found("turned_photographs", photograph.turned);
  found("unturned_photographs", photograph.unturned);
  found("resized_photographs", photograph.resized);
  found("converted_photographs", photograph.inks);
  found("deep_photographs", photograph.deep);
  found("gamma_photographs", photograph.gamma);
  found("profiled_photographs", !photograph.profile.empty(), photograph.profile);
}

Findings PhotographFindings::all() const {
  static const std::map<std::string, const char*> kTexts = {
      {"turned_photographs", "stored turned, and turned as their EXIF orientation says"},
      {"unturned_photographs", "read as stored, which fits, though their EXIF orientation turns or mirrors them"},
      {"resized_photographs", "of another size than their cameras, but of the same shape"},
      {"converted_photographs", "of CMYK, which becomes RGB"},
      {"deep_photographs", "of 16 bits a channel, of which 8 are kept"},
      {"gamma_photographs", "with a gAMA that is not sRGB's, which is undone"},
      {"profiled_photographs", "of colours that are not sRGB's, whose codes are taken as they are"}};
  Findings findings;
  for (const auto& [key, found] : found_) {
    findings.emplace_back(
        key, fmt::format("{}: {} of {} photographs, the first is {}{}", kTexts.at(key), found.count, photographs_,
                         quote(found.first), found.detail.empty() ? "" : fmt::format(" ({})", quote(found.detail))));
  }
  return findings;
}

Rgb8 shrunk(const Rgb8& picture, int width, int height) {
  if (width == picture.width && height == picture.height) return picture;
  const std::vector<Overlap> columns = overlaps(picture.width, width), rows = overlaps(picture.height, height);
  Rgb8 out{width, height, {}};
  out.data.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  std::vector<double> line(static_cast<std::size_t>(picture.width) * 3);
  for (const Overlap& row : rows) {
    std::fill(line.begin(), line.end(), 0.0);
    for (std::size_t k = 0; k < row.lengths.size(); ++k) {
      const std::uint8_t* old = picture.data.data() + (static_cast<std::size_t>(row.first) + k) * line.size();
      for (std::size_t i = 0; i < line.size(); ++i) line[i] += row.lengths[k] * old[i];
    }
    for (const Overlap& column : columns) {
      double sum[3] = {};
      for (std::size_t k = 0; k < column.lengths.size(); ++k) {
        for (std::size_t c = 0; c < 3; ++c)
          sum[c] += column.lengths[k] * line[(static_cast<std::size_t>(column.first) + k) * 3 + c];
      }
      for (const double value : sum) out.data.push_back(static_cast<std::uint8_t>(std::lround(std::min(value, 255.0))));
    }
  }
  return out;
}

}  // namespace pipegs
