// SPDX-License-Identifier: Apache-2.0
// foreign: see foreign.hpp.
#include "scenes/text/foreign.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

struct Signature {
  std::string_view bytes;
  const char* kind;
  std::size_t at = 0;
};
using namespace std::string_view_literals;

constexpr const char* kPage = "a web page (HTML), not the file itself: download it again, as raw data";

const Signature kSignatures[] = {
    {"version https://git-lfs"sv, "a Git LFS pointer, not the file itself: git lfs pull fetches it"},
    {"<!doctype html"sv, kPage},
    {"<!DOCTYPE html"sv, kPage},
    {"<html"sv, kPage},
    {"<HTML"sv, kPage},
    {"<?xml"sv, "XML"},
    {"7z\xbc\xaf\x27\x1c"sv, "an archive (7z): unpack it and name what is in it"},
    {"Rar!"sv, "an archive (RAR): unpack it and name what is in it"},
    {"\xfd"
     "7zXZ"sv,
     "an archive (xz): unpack it and name what is in it"},
    {"BZh"sv, "an archive (bzip2): unpack it and name what is in it"},
    {"\x28\xb5\x2f\xfd"sv, "an archive (zstd): unpack it and name what is in it"},
    {"PK\x03\x04"sv, "an archive (zip): unpack it and name what is in it"},
    {"\x1f\x8b"sv, "an archive (gzip): unpack it and name what is in it"},
    {"ustar"sv, "an archive (tar): unpack it and name what is in it", 257},
    {"\x89PNG"sv, "a picture (PNG)"},
    {"\xff\xd8\xff"sv, "a picture (JPEG)"},
    {"GIF8"sv, "a picture (GIF)"},
    {"II*\0"sv, "a picture (TIFF)"},
    {"MM\0*"sv, "a picture (TIFF)"},
    {"WEBP"sv, "a picture (WebP)", 8},
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
    {"solid "sv, "a mesh (STL), no Gaussian splats"},
    {"OFF\n"sv, "a mesh (OFF), no Gaussian splats"},
    {"# Camera list"sv, "cameras of COLMAP"},
    {"# Image list"sv, "images of COLMAP"},
    {"# 3D point list"sv, "points of COLMAP"},
    {"\x7f"
     "ELF"sv,
     "a program"},
};

}  // namespace

std::string foreign_kind(std::string_view begin) {
  if (begin.empty()) return "an empty file";
  const bool marked = begin.starts_with("\xef\xbb\xbf");  // UTF-8's mark
  const std::string_view text = begin.substr(marked ? 3 : 0);
  for (const Signature& signature : kSignatures) {
    if (text.size() > signature.at && text.substr(signature.at).starts_with(signature.bytes)) return signature.kind;
  }
  const std::string_view looked = begin.substr(0, 512);
  if (std::all_of(looked.begin(), looked.end(), [](char c) { return c == 0; })) return "a file of zeros";
  return "";
}

void refuse_foreign(const std::string& file, std::string_view begin, std::string_view expected) {
  if (const std::string kind = foreign_kind(begin); !kind.empty())
    throw InputError(file, "", fmt::format("found {}, expected {}", kind, expected));
}

}  // namespace pipegs
