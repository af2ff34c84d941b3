// SPDX-License-Identifier: Apache-2.0
// ply_header: the parser of ply_file.hpp.
//
// Idea    One keyword per line: ply, format, comment, obj_info, element, property, end_header.
//         Every line is checked for its number of words, every count and type by name; the first
//         thing that is wrong is reported as "line N".
#include "scenes/ply/ply_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "scenes/input_error.hpp"
#include "scenes/text/foreign.hpp"
#include "scenes/text/number.hpp"

namespace pipegs {
namespace {

struct TypeName {
  const char* name;
  PlyType type;
};
constexpr TypeName kTypeNames[] = {
    {"char", PlyType::kInt8},      {"int8", PlyType::kInt8},       {"uchar", PlyType::kUint8},
    {"uint8", PlyType::kUint8},    {"short", PlyType::kInt16},     {"int16", PlyType::kInt16},
    {"ushort", PlyType::kUint16},  {"uint16", PlyType::kUint16},   {"int", PlyType::kInt32},
    {"int32", PlyType::kInt32},    {"uint", PlyType::kUint32},     {"uint32", PlyType::kUint32},
    {"float", PlyType::kFloat32},  {"float32", PlyType::kFloat32}, {"double", PlyType::kFloat64},
    {"float64", PlyType::kFloat64}};

class Parser {
 public:
  explicit Parser(PlySource& source) : source_(source) {}

  PlyHeader parse() {
    next_line();
    if (words_ != std::vector<std::string>{"ply"} && without_mark(text_) != "ply")
      fail("magic", fmt::format("found {}, expected 'ply'", quote(text_)));
    while (true) {
      next_line();
      if (words_.empty()) continue;
      const std::string& keyword = words_[0];
      if (keyword == "end_header") {
        if (words_.size() != 1) fail("end_header", fmt::format("found {}, expected nothing behind it", quote(text_)));
        break;
      }
      if (keyword == "comment" || keyword == "obj_info") {
        header_.comments.push_back(text_.substr(text_.find(keyword) + keyword.size()));
      } else if (keyword == "format") {
        format();
      } else if (keyword == "element") {
        element();
      } else if (keyword == "property") {
        property();
      } else {
        fail("keyword",
             fmt::format("found {}, expected format, comment, element, property or end_header", quote(keyword)));
      }
    }
    if (!has_format_) fail("format", "missing, expected ascii, binary_little_endian or binary_big_endian");
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(const std::string& field, const std::string& what) const {
    throw InputError(source_.file(), fmt::format("line {}, {}", line_, field), what);
  }

  void next_line() {
    ++line_;
    const std::size_t limit = kMaxHeaderBytes - used_;
    const bool ends = source_.line(text_, limit);
    if (line_ == 1 && without_mark(text_).starts_with("ply\r"))
      fail("header", "its lines end in carriage returns alone, as on old Macs, expected line feeds");
    if (!ends) fail("header", "the header does not end, expected 'end_header' within the first megabyte");
    used_ = std::min(kMaxHeaderBytes, used_ + text_.size() + 1);
    words_.clear();
    std::istringstream stream(text_);
    for (std::string word; stream >> word;) words_.push_back(word);
  }

  void format() {
    if (has_format_) fail("format", "found a second format line, expected one");
    if (words_.size() != 3) fail("format", fmt::format("found {}, expected 'format <name> 1.0'", quote(text_)));
    if (words_[1] == "ascii") header_.format = PlyFormat::kAscii;
    else if (words_[1] == "binary_little_endian") header_.format = PlyFormat::kLittleEndian;
    else if (words_[1] == "binary_big_endian") header_.format = PlyFormat::kBigEndian;
    else
      fail("format",
           fmt::format("found {}, expected ascii, binary_little_endian or binary_big_endian", quote(words_[1])));
    if (words_[2] != "1.0") fail("format", fmt::format("found version {}, expected 1.0", quote(words_[2])));
    has_format_ = true;
  }

  void element() {
    if (words_.size() != 3) fail("element", fmt::format("found {}, expected 'element <name> <count>'", quote(text_)));
    PlyElement element{words_[1], 0, {}, line_};
    try {
      element.count = parse_integer<std::uint64_t>(words_[2]);
    } catch (const NumberError& error) { fail("count of element " + quote(element.name), error.what()); }
    for (const PlyElement& other : header_.elements) {
      if (other.name == element.name)
        fail("element", fmt::format("found a second {}, expected one", quote(element.name)));
    }
    if (header_.elements.size() >= kMaxElements)
      fail("element", fmt::format("found more than {} elements", kMaxElements));
    header_.elements.push_back(std::move(element));
  }

  PlyType type(const std::string& word) const {
    for (const TypeName& known : kTypeNames) {
      if (word == known.name) return known.type;
    }
    fail("property", fmt::format("found type {}, expected one such as float, double, uchar or int", quote(word)));
  }

  void property() {
    if (header_.elements.empty()) fail("property", "found before any element, expected 'element' first");
    const bool is_list = words_.size() > 1 && words_[1] == "list";
    if (words_.size() != (is_list ? 5u : 3u)) {
      fail("property", fmt::format("found {}, expected 'property <type> <name>'", quote(text_)));
    }
    PlyProperty property{words_.back(), type(words_[is_list ? 3 : 1]), is_list, {}, line_};
    if (is_list) {
      property.count_type = type(words_[2]);
      if (!is_integer(property.count_type))
        fail("property", "found a list with a fractional count type, expected an integer type");
    }
    auto& properties = header_.elements.back().properties;
    for (const PlyProperty& other : properties) {
      if (other.name == property.name)
        fail("property", fmt::format("found a second {}, expected one", quote(property.name)));
    }
    if (properties.size() >= kMaxProperties)
      fail("property", fmt::format("found more than {} properties", kMaxProperties));
    properties.push_back(std::move(property));
  }

  // Far beyond any real file, and they keep the searches for duplicates above from becoming a trap.
  static constexpr std::size_t kMaxElements = 64;
  static constexpr std::size_t kMaxProperties = 1024;

  PlySource& source_;
  PlyHeader header_;
  std::string text_;
  std::vector<std::string> words_;
  std::size_t used_ = 0;
  int line_ = 0;
  bool has_format_ = false;
};

}  // namespace

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8: return 1;
    case PlyType::kInt16:
    case PlyType::kUint16: return 2;
    case PlyType::kFloat64: return 8;
    default: return 4;
  }
}

bool is_integer(PlyType type) { return type != PlyType::kFloat32 && type != PlyType::kFloat64; }

PlyHeader read_ply_header(PlySource& source) { return Parser(source).parse(); }

}  // namespace pipegs
