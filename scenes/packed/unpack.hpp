// SPDX-License-Identifier: Apache-2.0
// unpack: gzip, zstd and zip by their libraries, within limits.
//
// Rule    What is unpacked has at most kMostUnpacked times the bytes that it had packed, and a megabyte more. The
//         formats of scenes reach 5; deflate alone could make 1000, zstd and WebP any number. The limit is held
//         before memory is taken where the size is known, and while it grows where it is not.
// Errors  InputError, also of what the libraries find: a checksum that is wrong, a stream that ends early.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/packed/input_file.hpp"

namespace pipegs {

inline constexpr std::uint64_t kMostUnpacked = 32, kUnpackedFree = std::uint64_t{1} << 20;

// InputError unless `packed` bytes may hold `unpacked` ones.
void check_unpacked(const std::string& file, std::string_view where, std::uint64_t packed, std::uint64_t unpacked);

// The bytes of a file that is one gzip member, under its name. `behind` gets how many bytes follow it; without it there
// must be none.
InputFile unpack_gzip(const InputFile& file, std::uint64_t* behind = nullptr);
// One zstd frame of a known unpacked size, which the caller has held against the file.
std::string unpack_zstd(const std::string& file, std::string_view where, std::span<const std::uint8_t> packed,
                        std::uint64_t unpacked);
// A file of a zip archive, and beside it the others of its folder there.
InputFile unpack_zip(const InputFile& archive, const std::string& name);
// The files of a zip archive, at most kMostNames of them; backslashes in their names are slashes.
inline constexpr std::size_t kMostNames = 65536;
std::vector<std::string> zip_names(const InputFile& archive);

// Texels of a WebP picture as RGBA, row by row, or an InputError. More texels than `most` are not decoded.
struct Texture {
  int width = 0, height = 0;
  bool lossy = false;
  std::string rgba;

  const std::uint8_t* texel(std::uint64_t i) const {
    return reinterpret_cast<const std::uint8_t*>(rgba.data()) + 4 * i;
  }
};
Texture unpack_webp(const InputFile& file, std::uint64_t most);

}  // namespace pipegs
