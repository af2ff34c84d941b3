// SPDX-License-Identifier: Apache-2.0
// foreign: see foreign.hpp.
#include "scenes/text/foreign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

struct Signature {
  std::string_view bytes;
  const char* kind;
  std::size_t at = 0;
};
using namespace std::string_view_literals;

const Signature kSignatures[] = {
    {"version https://git-lfs"sv, "a Git LFS pointer, not the file itself: git lfs pull fetches it"},
    {"version https://hawser"sv, "a Git LFS pointer, not the file itself: git lfs pull fetches it"},
    {"7z\xbc\xaf\x27\x1c"sv, "an archive (7z): unpack it and name what is in it"},
    {"Rar!"sv, "an archive (RAR): unpack it and name what is in it"},
    {"\xfd"
     "7zXZ"sv,
     "an archive (xz): unpack it and name what is in it"},
    {"BZh"sv, "an archive (bzip2): unpack it and name what is in it"},
    {"\x28\xb5\x2f\xfd"sv, "an archive (zstd): unpack it and name what is in it"},
    {"PK\x03\x04"sv, "an archive (zip): unpack it and name what is in it"},
    {"\x1f\x8b\x08"sv, "an archive (gzip): unpack it and name what is in it"},
    {"\x04\"M\x18"sv, "an archive (lz4): unpack it and name what is in it"},
    {"MSCF"sv, "an archive (cab): unpack it and name what is in it"},
    {"ustar"sv, "an archive (tar): unpack it and name what is in it", 257},
    {"\x89PNG"sv, "a picture (PNG)"},
    {"\xff\xd8\xff"sv, "a picture (JPEG)"},
    {"GIF8"sv, "a picture (GIF)"},
    {"II*\0"sv, "a picture (TIFF): convert it to JPEG or PNG"},
    {"MM\0*"sv, "a picture (TIFF): convert it to JPEG or PNG"},
    {"WEBP"sv, "a picture (WebP): convert it to JPEG or PNG", 8},
    {"JXL "sv, "a picture (JPEG XL): convert it to JPEG or PNG", 4},
    {"jP  "sv, "a picture (JPEG 2000): convert it to JPEG or PNG", 4},
    {"ftyphei"sv, "a picture (HEIC): convert it to JPEG or PNG", 4},
    {"ftypmif"sv, "a picture (HEIC): convert it to JPEG or PNG", 4},
    {"ftypavif"sv, "a picture (AVIF): convert it to JPEG or PNG", 4},
    {"ftyp"sv, "a video or a picture (ISO media)", 4},
    {"v/1\x01"sv, "a picture (OpenEXR)"},
    {"%PDF"sv, "a PDF document"},
    {"\x93NUMPY"sv, "an array of NumPy"},
    {"PAR1"sv, "a table of Parquet: export a .ply"},
    {"SQLite format 3"sv, "COLMAP's database; its model is in sparse/0"},
    {"# .PCD"sv, "a point cloud (PCD), no Gaussian splats"},
    {"LASF"sv, "a point cloud (LAS), no Gaussian splats"},
    {"ASTM-E57"sv, "a point cloud (E57), no Gaussian splats"},
    {"PXR-USDC"sv, "USD: export a .ply"},
    {"#usda"sv, "USD: export a .ply"},
    {"b3dm"sv, "a tile of 3D Tiles: name the .glb that is in it"},
    {"\x89HDF"sv, "HDF5: export a .ply"},
    {"\x80\x02\x8a\x0a"sv, "a checkpoint of PyTorch: export a .ply of it"},
    {"\x80\x04\x95"sv, "a pickle of Python: export a .ply of it"},
    {"BLENDER"sv, "a file of Blender: export a .ply"},
    {"Kaydara FBX"sv, "a mesh (FBX), no Gaussian splats"},
    {"mtllib "sv, "a mesh (OBJ), no Gaussian splats"},
    {"# Blender"sv, "a mesh (OBJ), no Gaussian splats"},
    {"\x1a\x45\xdf\xa3"sv, "a video (Matroska)"},
    {"solid "sv, "a mesh (STL), no Gaussian splats"},
    {"OFF\n"sv, "a mesh (OFF), no Gaussian splats"},
    {"# Camera list"sv, "cameras of COLMAP"},
    {"# Image list"sv, "images of COLMAP"},
    {"# 3D point list"sv, "points of COLMAP"},
    {"\x7f"
     "ELF"sv,
     "a program"},
    {"MZ\x90\0"sv, "a program"},
};

// Of text in ASCII, whatever its letters' case and its first blanks.
std::string markup_kind(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  const std::string_view looked = text.substr(0, 64);
  if (!looked.starts_with('<') || !std::all_of(looked.begin(), looked.end(), is_printable)) return "";
  std::string lower(looked);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const char* page : {"<!doctype html", "<html", "<head", "<body", "<!--", "<div", "<script", "<meta"}) {
    if (lower.starts_with(page)) return "a web page (HTML), not the file itself: download it again, as raw data";
  }
  return "XML, as servers send for an error and some programs for cameras";
}

// Letters of 16 bits, each with a zero byte.
bool is_utf16(std::string_view text) {
  if (text.size() < 6) return false;
  if (text[2] == 0 && text[3] == 0) return false;
  const bool little = text.starts_with("\xff\xfe"), big = text.starts_with("\xfe\xff");
  return (little && text[3] == 0 && text[5] == 0) || (big && text[2] == 0 && text[4] == 0);
}

}  // namespace

std::string foreign_kind(std::string_view begin) {
  if (begin.empty()) return "an empty file";
  const std::string_view text = without_mark(begin);
  for (const Signature& signature : kSignatures) {
    if (text.size() > signature.at && text.substr(signature.at).starts_with(signature.bytes)) return signature.kind;
  }
  if (std::string kind = markup_kind(text); !kind.empty()) return kind;
  if (is_utf16(text)) return "a text in UTF-16: save it as UTF-8";
  if (text.starts_with("BM") && text.size() > 10 && text.substr(6, 4) == "\0\0\0\0"sv)
    return "a picture (BMP): convert it to JPEG or PNG";
  const std::string_view looked = begin.substr(0, 512);
  if (std::all_of(looked.begin(), looked.end(), [](char c) { return c == 0; })) return "a file of zeros";
  return "";
}

void refuse_foreign(const std::string& file, std::string_view begin, std::string_view expected) {
  if (const std::string kind = foreign_kind(begin); !kind.empty())
    throw InputError(file, "", fmt::format("found {}, expected {}", kind, expected));
}

}  // namespace pipegs
