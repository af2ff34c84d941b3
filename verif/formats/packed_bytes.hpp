// SPDX-License-Identifier: Apache-2.0
// packed_bytes: small files of the formats that tests write themselves: numbers as bytes, gzip, WebP, zip, base64.
#pragma once

#include <webp/encode.h>
#include <zlib.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace pipegs {

template <typename T>
void put(std::string& out, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  out.append(bytes, sizeof(T));
}

// Compressed by zlib at a level of 0 to 9: a window of 31 is gzip, -15 the bare stream that a zip holds.
inline std::string deflated(const std::string& bytes, int window, int level = 6) {
  z_stream stream{};
  deflateInit2(&stream, level, Z_DEFLATED, window, 8, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&stream, bytes.size()) + 32, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

inline std::string gzip(const std::string& bytes) { return deflated(bytes, 31); }

// A picture of these texels, R G B A, lossless and exact.
inline std::string webp(int width, int height, const std::vector<std::uint8_t>& rgba, bool lossless = true) {
  WebPConfig config;
  WebPConfigInit(&config);
  config.lossless = lossless ? 1 : 0;
  config.exact = 1;
  WebPPicture picture;
  WebPPictureInit(&picture);
  picture.use_argb = 1;
  picture.width = width;
  picture.height = height;
  WebPPictureImportRGBA(&picture, rgba.data(), 4 * width);
  WebPMemoryWriter writer;
  WebPMemoryWriterInit(&writer);
  picture.writer = WebPMemoryWrite;
  picture.custom_ptr = &writer;
  WebPEncode(&config, &picture);
  std::string out(reinterpret_cast<const char*>(writer.mem), writer.size);
  WebPPictureFree(&picture);
  WebPMemoryWriterClear(&writer);
  return out;
}

// A zip archive; deflated or stored.
inline std::string zip(const std::vector<std::pair<std::string, std::string>>& files, bool packed = false) {
  std::string out, directory;
  for (const auto& [name, bytes] : files) {
    const std::string body = packed ? deflated(bytes, -15) : bytes;
    std::string entry;  // what both headers have in common
    put<std::uint16_t>(entry, 20), put<std::uint16_t>(entry, 0), put<std::uint16_t>(entry, packed ? 8 : 0);
    put<std::uint32_t>(entry, 0x21);
    put<std::uint32_t>(entry, static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(bytes.data()),
                                                               static_cast<uInt>(bytes.size()))));
    put(entry, static_cast<std::uint32_t>(body.size())), put(entry, static_cast<std::uint32_t>(bytes.size()));
    put(entry, static_cast<std::uint16_t>(name.size())), put<std::uint16_t>(entry, 0);
    put<std::uint32_t>(directory, 0x02014b50), put<std::uint16_t>(directory, 20);
    directory += entry + std::string(10, '\0');
    put(directory, static_cast<std::uint32_t>(out.size()));
    directory += name;
    put<std::uint32_t>(out, 0x04034b50);
    out += entry + name + body;
  }
  const std::size_t start = out.size();
  out += directory;
  put<std::uint32_t>(out, 0x06054b50), put<std::uint32_t>(out, 0);
  put(out, static_cast<std::uint16_t>(files.size())), put(out, static_cast<std::uint16_t>(files.size()));
  put(out, static_cast<std::uint32_t>(directory.size())), put(out, static_cast<std::uint32_t>(start));
  put<std::uint16_t>(out, 0);
  return out;
}

inline std::string base64(const std::string& bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

}  // namespace pipegs
