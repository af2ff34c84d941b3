// SPDX-License-Identifier: Apache-2.0
// ply_file: builds .ply files of any shape for the loader's tests, independent of write_ply.
//
// Idea    A column is a name, a type and its values; a file is columns in a format. The tests'
//         expectations are the values themselves, so reader and writer cannot be wrong together.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace pipegs {

struct Column {
  std::string name, type;
  std::vector<double> values;
};

inline void append_value(std::string& out, const std::string& type, double value, bool big) {
  const auto put = [&](auto v) {
    char bytes[sizeof(v)];
    std::memcpy(bytes, &v, sizeof(v));
    if (big) std::reverse(bytes, bytes + sizeof(v));
    out.append(bytes, sizeof(v));
  };
  if (type == "char" || type == "int8") put(static_cast<std::int8_t>(value));
  else if (type == "uchar" || type == "uint8") put(static_cast<std::uint8_t>(value));
  else if (type == "short" || type == "int16") put(static_cast<std::int16_t>(value));
  else if (type == "ushort" || type == "uint16") put(static_cast<std::uint16_t>(value));
  else if (type == "int" || type == "int32") put(static_cast<std::int32_t>(value));
  else if (type == "uint" || type == "uint32") put(static_cast<std::uint32_t>(value));
  else if (type == "double" || type == "float64") put(value);
  else put(static_cast<float>(value));
}

// The columns of a plain file: column j of Gaussian i holds 100*i + j, scaled to be exact in float.
inline std::vector<Column> plain_columns(std::size_t count, int rest, const std::string& type = "float") {
  std::vector<std::string> names = {"x", "y", "z", "nx", "ny", "nz", "f_dc_0", "f_dc_1", "f_dc_2"};
  for (int i = 0; i < rest; ++i) names.push_back("f_rest_" + std::to_string(i));
  for (const char* name : {"opacity", "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"})
    names.push_back(name);
  std::vector<Column> out;
  for (std::size_t j = 0; j < names.size(); ++j) {
    Column column{names[j], type, {}};
    for (std::size_t i = 0; i < count; ++i) column.values.push_back(static_cast<double>(3 * i + j + 1));
    out.push_back(column);
  }
  return out;
}

inline double value_of(const std::vector<Column>& columns, const std::string& name, std::size_t i) {
  for (const Column& column : columns) {
    if (column.name == name) return column.values[i];
  }
  return 0;
}

struct PlyText {
  std::string format = "binary_little_endian";
  std::string newline = "\n";
  std::vector<std::string> comments;
  std::string elements_before, body_before;  // raw
  std::string elements_after, body_after;

  std::string build(const std::vector<Column>& columns) const {
    const std::size_t count = columns.empty() ? 0 : columns[0].values.size();
    std::string out = "ply" + newline + "format " + format + " 1.0" + newline;
    for (const auto& comment : comments) out += "comment " + comment + newline;
    out += elements_before + fmt::format("element vertex {}", count) + newline;
    for (const Column& column : columns) out += "property " + column.type + " " + column.name + newline;
    out += elements_after + "end_header" + newline + body_before;
    for (std::size_t i = 0; i < count; ++i) {
      for (const Column& column : columns) {
        if (format == "ascii") out += fmt::format("{} ", column.values[i]);
        else append_value(out, column.type, column.values[i], format == "binary_big_endian");
      }
      if (format == "ascii") out += newline;
    }
    return out + body_after;
  }
};

}  // namespace pipegs
