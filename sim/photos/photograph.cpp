// SPDX-License-Identifier: Apache-2.0
// photograph: see photograph.hpp.
//
// Idea    libjpeg reports an error by a call that must not return. It jumps back into decode(), which holds nothing
//         that would have to be destroyed; what it writes to lies with its caller.
//         To fewer pixels by rows first, then columns: a new pixel is a sum of old ones, each with the length of its
//         overlap.
#include "sim/photos/photograph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <fstream>
#include <memory>
#include <vector>

// These need <cstdio>.
#include <jerror.h>
#include <jpeglib.h>

#include "scenes/input_error.hpp"
#include "scenes/text/text_file.hpp"

namespace pipegs {
namespace {

constexpr std::size_t kDepthOfPng = 24;  // the byte of the header that holds the bits of a channel

struct Decoding {
  jpeg_error_mgr errors;  // the first, so that libjpeg's pointer to it is one to all of this
  std::jmp_buf back;
  char message[JMSG_LENGTH_MAX];
};

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

// Whether the picture was decoded into `out`; if not, the message says why.
bool decode(std::FILE* file, int width, int height, std::uint8_t* out, Decoding& decoding) {
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
  jpeg_read_header(&jpeg, TRUE);
  if (jpeg.image_width != static_cast<JDIMENSION>(width) || jpeg.image_height != static_cast<JDIMENSION>(height)) {
    std::snprintf(decoding.message, sizeof decoding.message, "found %ux%u pixels, expected %dx%d", jpeg.image_width,
                  jpeg.image_height, width, height);
    jpeg_destroy_decompress(&jpeg);
    return false;
  }
  jpeg.out_color_space = JCS_RGB;
  jpeg_start_decompress(&jpeg);
  while (jpeg.output_scanline < jpeg.output_height) {
    JSAMPROW row = out + std::size_t{jpeg.output_scanline} * static_cast<std::size_t>(width) * 3;
    jpeg_read_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_decompress(&jpeg);
  jpeg_destroy_decompress(&jpeg);
  return true;
}

Rgb8 read_jpeg(const std::filesystem::path& path, int width, int height) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) throw InputError(path.string(), "", "cannot open for reading");
  Rgb8 picture{width, height, {}};
  picture.data.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  Decoding decoding;
  if (!decode(file.get(), width, height, picture.data.data(), decoding))
    throw InputError(path.string(), "", decoding.message);
  return picture;
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

Rgb8 read_photograph(const std::filesystem::path& path, const Camera& camera) {
  require_regular_file(path, "a photograph");
  unsigned char head[kDepthOfPng + 1] = {};
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(head), sizeof head);
  if (head[0] == 0xff && head[1] == 0xd8 && head[2] == 0xff) return read_jpeg(path, camera.width, camera.height);
  if (!(head[0] == 0x89 && head[1] == 'P' && head[2] == 'N' && head[3] == 'G'))
    throw InputError(path.string(), "", "found neither a PNG nor a JPEG, expected a photograph");
  if (head[kDepthOfPng] > 8)
    throw InputError(path.string(), "", fmt::format("found {} bits for a channel, expected 8", head[kDepthOfPng]));
  Rgb8 picture = read_png8(path);
  if (picture.width == camera.width && picture.height == camera.height) return picture;
  throw InputError(
      path.string(), "",
      fmt::format("found {}x{} pixels, expected {}x{}", picture.width, picture.height, camera.width, camera.height));
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
