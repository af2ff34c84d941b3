// SPDX-License-Identifier: Apache-2.0
// jpeg: see jpeg.hpp.
//
// Idea    libjpeg reports an error by a call that must not return. It jumps back into decode(), which holds nothing
//         that would have to be destroyed; what it writes to lies with its caller.
#include "sim/photos/jpeg.hpp"

#include <fmt/format.h>

#include <csetjmp>
#include <cstdio>
#include <memory>
#include <string>

// These need <cstdio>.
#include <jerror.h>
#include <jpeglib.h>

#include "scenes/input_error.hpp"
#include "scenes/text/text_file.hpp"

namespace pipegs {
namespace {

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

}  // namespace

Rgb8 read_jpeg(const std::filesystem::path& path, int width, int height) {
  require_regular_file(path, "a photograph");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) throw InputError(path.string(), "", "cannot open for reading");
  Rgb8 picture{width, height, {}};
  picture.data.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  Decoding decoding;
  if (!decode(file.get(), width, height, picture.data.data(), decoding))
    throw InputError(path.string(), "", decoding.message);
  return picture;
}

}  // namespace pipegs
