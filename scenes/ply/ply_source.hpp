// SPDX-License-Identifier: Apache-2.0
// ply_source: bytes of a file in order, through one buffer, never beyond its end.
//
// Idea    take(n) hands out n contiguous bytes or throws; so a truncated file cannot be read past,
//         and the memory used does not depend on what the header promises.
// Pace    Refills of kBufferBytes, one memmove of the rest each.
#pragma once

#include <cstdint>
#include <filesystem>
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
  // The next line without its LF or CRLF; false if the file ends or `limit` bytes hold no LF.
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

}  // namespace pipegs
