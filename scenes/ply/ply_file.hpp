// SPDX-License-Identifier: Apache-2.0
// ply_file: a .ply with nothing Gaussian in it: bytes in order, the header, rows of numbers.
//
// Source  take(n) hands out n contiguous bytes or throws; so a truncated file cannot be read past, and the memory used
//         does not depend on what the header promises. One buffer, refilled a megabyte at a time.
// Header  A list of elements, an element a count and a list of properties. The parser keeps the line number of each, so
//         that later errors can still point at the header. kMaxHeaderBytes bounds what a file without "end_header"
//         makes us read.
// Rows    The caller says where in its own row each property goes (kSkip: nowhere); the reader hides the format, the
//         byte order, the types and the lists. Rows without lists have a fixed size, so whole blocks are taken from the
//         source and floats are copied unseen.
// Rule    check_fits() first: an element that cannot fit what is left of the file is refused before anyone reserves
//         memory for it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <istream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace pipegs {

class PlySource {
 public:
  explicit PlySource(const std::filesystem::path& path);
  // Bytes in memory; `file` is their name in errors.
  PlySource(std::string file, const std::string& bytes);

  const std::string& file() const { return file_; }
  std::uint64_t remaining() const { return remaining_; }  // bytes not yet taken

  // The next n bytes; valid until the next call. The caller has made sure that n <= remaining().
  const std::uint8_t* take(std::size_t n);
  // The next line without its LF or CRLF; false, and how it begins, if the file ends or `limit` bytes hold no LF.
  bool line(std::string& out, std::size_t limit);
  // The next word of this line; empty at its end. InputError for one that is longer than any number.
  std::string_view word();
  // To the next line that holds a word; false when there is none.
  bool next_line();

 private:
  void fill(std::size_t wanted);  // at least `wanted` bytes in the buffer, or all there are

  std::string file_;
  std::unique_ptr<std::istream> stream_;
  std::vector<std::uint8_t> buffer_;
  std::size_t begin_ = 0, end_ = 0;
  std::uint64_t remaining_ = 0;
};

enum class PlyFormat { kAscii, kLittleEndian, kBigEndian };
enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

inline constexpr std::size_t kMaxHeaderBytes = std::size_t{1} << 20;

// Of a scalar: type. Of a list: count_type, then that many of type.
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

inline constexpr int kSkip = -1;
inline constexpr int kWide = -2;  // kWide - k: place k of the caller's doubles

// InputError "truncated" if `element` needs more bytes than the source has left.
void check_fits(const PlySource& source, PlyFormat format, const PlyElement& element);

// Reads all rows; slots[p] is the place of property p in `row`. A list has no place, only kSkip.
void read_rows(PlySource& source, PlyFormat format, const PlyElement& element, const std::vector<int>& slots,
               std::vector<float>& row, const std::function<void(std::size_t)>& on_row, double* wide = nullptr);

// The bytes behind the last element, without blanks of an ASCII file.
std::uint64_t rest_of_file(PlySource& source, const PlyHeader& header);

}  // namespace pipegs
