// SPDX-License-Identifier: Apache-2.0
// ply_header: the text part of a .ply file, parsed and checked, with nothing Gaussian in it.
//
// Idea    A header is a list of elements, an element a count and a list of properties. The parser
//         keeps the line number of each, so that later errors can still point at the header.
// Limits  kMaxHeaderBytes bounds what a file without "end_header" makes us read.
// Layout  Of a scalar property: type. Of a list property: count_type, then that many of type.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenes/ply/ply_source.hpp"

namespace pipegs {

enum class PlyFormat { kAscii, kLittleEndian, kBigEndian };
enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

inline constexpr std::size_t kMaxHeaderBytes = std::size_t{1} << 20;

struct PlyProperty {
  std::string name;
  PlyType type{};
  bool is_list = false;
  PlyType count_type{};
  int line = 0;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  int line = 0;
};

struct PlyHeader {
  PlyFormat format{};
  std::vector<PlyElement> elements;
  std::vector<std::string> comments;
};

std::size_t size_of(PlyType type);
bool is_integer(PlyType type);
PlyHeader read_ply_header(PlySource& source);

}  // namespace pipegs
