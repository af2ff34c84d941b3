// SPDX-License-Identifier: Apache-2.0
// unpack: see unpack.hpp.
//
// Idea    minizip asks for the bytes of its archive by functions that it is given: they read memory.
#include "scenes/packed/unpack.hpp"

#include <fmt/format.h>
#include <minizip/unzip.h>
#include <webp/decode.h>
#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>

#include "scenes/input_error.hpp"
#include "scenes/text/foreign.hpp"

namespace pipegs {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 16;

std::uint64_t most_unpacked(std::uint64_t packed) { return packed * kMostUnpacked + kUnpackedFree; }

struct Reading {
  std::string_view bytes;
  std::uint64_t at = 0;
};

zlib_filefunc64_def memory_functions(Reading& reading) {
  zlib_filefunc64_def functions{};
  functions.opaque = &reading;
  functions.zopen64_file = [](voidpf opaque, const void*, int) { return opaque; };
  functions.zread_file = [](voidpf, voidpf stream, void* to, uLong size) {
    auto& from = *static_cast<Reading*>(stream);
    const std::string_view part = from.bytes.substr(from.at, size);
    std::copy(part.begin(), part.end(), static_cast<char*>(to));
    from.at += part.size();
    return static_cast<uLong>(part.size());
  };
  functions.ztell64_file = [](voidpf, voidpf stream) -> ZPOS64_T { return static_cast<Reading*>(stream)->at; };
  functions.zseek64_file = [](voidpf, voidpf stream, ZPOS64_T offset, int origin) -> long {
    auto& from = *static_cast<Reading*>(stream);
    const std::uint64_t base = origin == ZLIB_FILEFUNC_SEEK_CUR   ? from.at
                               : origin == ZLIB_FILEFUNC_SEEK_END ? from.bytes.size()
                                                                  : 0;
    if (offset > from.bytes.size() - base) return -1;
    from.at = base + offset;
    return 0;
  };
  functions.zclose_file = [](voidpf, voidpf) { return 0; };
  functions.zerror_file = [](voidpf, voidpf) { return 0; };
  return functions;
}

using Zip = std::unique_ptr<void, int (*)(unzFile)>;

Zip open_zip(const InputFile& archive, Reading& reading) {
  zlib_filefunc64_def functions = memory_functions(reading);
  Zip zip(unzOpen2_64(archive.name().c_str(), &functions), unzClose);
  if (zip == nullptr) throw InputError(archive.name(), "", "found a zip archive without a directory: it is truncated");
  return zip;
}

// The members of an archive by their names with slashes, as Windows may not have written them. Each is sought once: a
// streamed scene has thousands.
struct Archive {
  InputFile file;
  std::map<std::string, unz64_file_pos> places = {};
};

std::string plain(std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  return std::filesystem::path(name).lexically_normal().string();
}

// Calls visit(name) with the archive at each of its members.
template <typename Visit>
void for_each_member(const unzFile zip, Visit&& visit) {
  for (int state = unzGoToFirstFile(zip); state == UNZ_OK; state = unzGoToNextFile(zip)) {
    unz_file_info64 info{};
    char name[1024] = {};
    if (unzGetCurrentFileInfo64(zip, &info, name, sizeof name - 1, nullptr, 0, nullptr, 0) != UNZ_OK) return;
    visit(plain(name));
  }
}

std::shared_ptr<const Archive> archive_of(const InputFile& file) {
  auto archive = std::make_shared<Archive>(Archive{file});
  Reading reading{archive->file.text()};
  const Zip zip = open_zip(file, reading);
  for_each_member(zip.get(), [&](const std::string& name) {
    unz64_file_pos place{};
    if (unzGetFilePos64(zip.get(), &place) == UNZ_OK) archive->places.emplace(name, place);
  });
  return archive;
}

// Its bytes, and how many they are in the archive.
std::pair<std::string, std::uint64_t> read_member(const Archive& members, const std::string& name) {
  const InputFile& archive = members.file;
  Reading reading{archive.text()};
  const Zip zip = open_zip(archive, reading);
  unz_file_info64 info{};
  const auto place = members.places.find(plain(name));
  if (place == members.places.end() || unzGoToFilePos64(zip.get(), &place->second) != UNZ_OK ||
      unzGetCurrentFileInfo64(zip.get(), &info, nullptr, 0, nullptr, 0, nullptr, 0) != UNZ_OK)
    throw InputError(archive.name(), "", fmt::format("found no {} in the zip archive", quote(name)));
  if (info.compressed_size > archive.size())
    throw InputError(archive.name(), quote(name),
                     fmt::format("found {} packed bytes, expected at most those of the archive", info.compressed_size));
  check_unpacked(archive.name(), quote(name), info.compressed_size, info.uncompressed_size);
  if (info.compression_method != 0 && info.compression_method != Z_DEFLATED)
    throw InputError(
        archive.name(), quote(name),
        fmt::format("found compression method {}, expected 0 (stored) or 8 (deflate)", info.compression_method));
  if ((info.flag & 1) != 0)
    throw InputError(archive.name(), quote(name), "found an encrypted file, expected an open one");
  std::string bytes(static_cast<std::size_t>(info.uncompressed_size), '\0');
  bool good = unzOpenCurrentFile(zip.get()) == UNZ_OK;
  for (std::size_t done = 0; good && done < bytes.size();) {
    const auto wanted = static_cast<unsigned>(std::min(bytes.size() - done, std::size_t{1} << 30));
    const int got = unzReadCurrentFile(zip.get(), bytes.data() + done, wanted);
    good = got > 0;
    done += good ? static_cast<std::size_t>(got) : 0;
  }
  if (!good || unzCloseCurrentFile(zip.get()) != UNZ_OK)
    throw InputError(archive.name(), quote(name), "the bytes in the zip archive are damaged");
  return {std::move(bytes), info.compressed_size};
}

InputFile member_of(const std::shared_ptr<const Archive>& archive, const std::string& name) {
  const std::string folder = plain(name).substr(0, plain(name).rfind('/') + 1);
  const auto other = [archive, folder](const std::string& wanted) { return member_of(archive, folder + wanted); };
  auto [bytes, packed] = read_member(*archive, name);
  return {archive->file.name() + "/" + name, std::move(bytes), other, packed};
}

}  // namespace

void check_unpacked(const std::string& file, std::string_view where, std::uint64_t packed, std::uint64_t unpacked) {
  if (unpacked <= most_unpacked(packed)) return;
  throw InputError(
      file, where,
      fmt::format("found {} bytes packed in {}, expected at most {} times as many", unpacked, packed, kMostUnpacked));
}

InputFile unpack_gzip(const InputFile& file, std::uint64_t* behind) {
  z_stream stream{};
  if (inflateInit2(&stream, 16 + MAX_WBITS) != Z_OK) throw std::bad_alloc();  // 16: gzip, and nothing else
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&stream, inflateEnd);
  const std::string& packed = file.text();
  std::string bytes, block(kBlock, '\0');
  std::size_t taken = 0;
  for (int state = Z_OK; state != Z_STREAM_END;) {
    if (stream.avail_in == 0) {
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + taken));
      stream.avail_in = static_cast<uInt>(std::min(packed.size() - taken, std::size_t{1} << 30));
      taken += stream.avail_in;
    }
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = static_cast<uInt>(block.size());
    state = inflate(&stream, Z_NO_FLUSH);
    if (state != Z_OK && state != Z_STREAM_END)
      throw InputError(file.name(), "gzip", "the packed bytes are truncated or damaged");
    bytes.append(block, 0, block.size() - stream.avail_out);
    check_unpacked(file.name(), "gzip", file.packed(), bytes.size());
  }
  const std::size_t left = packed.size() - taken + stream.avail_in;
  if (behind != nullptr) *behind = left;
  else if (left > 0)
    throw InputError(file.name(), "behind gzip", fmt::format("found {} bytes, expected the end of the file", left));
  return {file.name(), std::move(bytes), nullptr, file.packed()};
}

std::string unpack_zstd(const std::string& file, std::string_view where, std::span<const std::uint8_t> packed,
                        std::uint64_t unpacked) {
  std::string bytes(static_cast<std::size_t>(unpacked), '\0');
  const std::size_t got = ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
  if (ZSTD_isError(got) != 0) throw InputError(file, where, fmt::format("zstd: {}", ZSTD_getErrorName(got)));
  if (got != unpacked)
    throw InputError(file, where, fmt::format("found {} bytes packed by zstd, expected {}", got, unpacked));
  return bytes;
}

InputFile unpack_zip(const InputFile& archive, const std::string& name) { return member_of(archive_of(archive), name); }

std::vector<std::string> zip_names(const InputFile& archive) {
  Reading reading{archive.text()};
  const Zip zip = open_zip(archive, reading);
  std::vector<std::string> names;
  for_each_member(zip.get(), [&](const std::string& name) {
    if (names.size() < kMostNames) names.push_back(name);
  });
  return names;
}

Texture unpack_webp(const InputFile& file, std::uint64_t most) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(file.text().data());
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(bytes, file.text().size(), &features) != VP8_STATUS_OK) {
    refuse_foreign(file.name(), file.text(), "a WebP picture");
    throw InputError(file.name(), "", "found no WebP picture");
  }
  if (features.has_animation != 0) throw InputError(file.name(), "", "found an animated WebP, expected one picture");
  Texture texture{.width = features.width, .height = features.height, .lossy = features.format == 1, .rgba = {}};
  const auto texels = static_cast<std::uint64_t>(texture.width) * static_cast<std::uint64_t>(texture.height);
  if (texels > most) {
    throw InputError(file.name(), "",
                     fmt::format("found {} x {} texels, expected at most {}", texture.width, texture.height, most));
  }
  texture.rgba.resize(4 * static_cast<std::size_t>(texels));
  if (WebPDecodeRGBAInto(bytes, file.text().size(), reinterpret_cast<std::uint8_t*>(texture.rgba.data()),
                         texture.rgba.size(), 4 * texture.width) == nullptr)
    throw InputError(file.name(), "", "the WebP picture is truncated or damaged");
  return texture;
}

}  // namespace pipegs
