// SPDX-License-Identifier: Apache-2.0
// ply_source: buffered reading; see ply_file.hpp.
//
// Idea    Valid bytes are buffer_[begin_, end_). fill() moves them to the front and reads on; the
//         buffer grows only for a single take() larger than itself, and never beyond the file.
#include "scenes/ply/ply_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <sstream>

#include "scenes/input_error.hpp"
#include "scenes/text/text_file.hpp"

namespace pipegs {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 20;
constexpr std::size_t kLongestWord = 512;  // of an ASCII body; no number needs more

bool is_blank(std::uint8_t c) { return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n'); }

}  // namespace

PlySource::PlySource(const std::filesystem::path& path) : file_(path.string()) {
  require_regular_file(path, "a .ply file");
  std::error_code error;
  remaining_ = std::filesystem::file_size(path, error);
  stream_ = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (error || !*stream_) throw InputError(file_, "", "cannot open for reading");
}

PlySource::PlySource(std::string file, const std::string& bytes)
    : file_(std::move(file)), stream_(std::make_unique<std::istringstream>(bytes)), remaining_(bytes.size()) {}

void PlySource::fill(std::size_t wanted) {
  wanted = static_cast<std::size_t>(std::min<std::uint64_t>(wanted, remaining_));
  if (end_ - begin_ >= wanted) return;
  if (begin_ < end_) std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  const auto whole = static_cast<std::size_t>(std::min<std::uint64_t>(kBufferBytes, remaining_));
  if (buffer_.size() < std::max(wanted, whole)) buffer_.resize(std::max(wanted, whole));
  while (end_ < wanted && *stream_) {
    stream_->read(reinterpret_cast<char*>(buffer_.data() + end_), static_cast<std::streamsize>(buffer_.size() - end_));
    end_ += static_cast<std::size_t>(stream_->gcount());
  }
}

const std::uint8_t* PlySource::take(std::size_t n) {
  fill(n);
  // The size said otherwise: the file shrank while being read, or the disk failed.
  if (end_ - begin_ < n || remaining_ < n) throw InputError(file_, "", "the file ended while being read");
  const std::uint8_t* bytes = buffer_.data() + begin_;
  begin_ += n;
  remaining_ -= n;
  return bytes;
}

bool PlySource::line(std::string& out, std::size_t limit) {
  fill(std::min(limit, kBufferBytes));
  const std::size_t length = std::min(limit, end_ - begin_);
  const auto* start = buffer_.data() + begin_;
  const void* found = length == 0 ? nullptr : std::memchr(start, '\n', length);
  if (found == nullptr) {
    out.assign(reinterpret_cast<const char*>(start), std::min<std::size_t>(length, 8));
    return false;
  }
  const auto n = static_cast<std::size_t>(static_cast<const std::uint8_t*>(found) - start);
  out.assign(reinterpret_cast<const char*>(start), n);
  if (!out.empty() && out.back() == '\r') out.pop_back();
  take(n + 1);
  return true;
}

std::string_view PlySource::word() {
  for (;;) {
    fill(1);
    if (begin_ == end_ || buffer_[begin_] == '\n') return {};
    if (!is_blank(buffer_[begin_])) break;
    take(1);
  }
  fill(kLongestWord + 1);
  const std::size_t most = std::min(kLongestWord + 1, end_ - begin_);
  std::size_t n = 0;
  while (n < most && !is_blank(buffer_[begin_ + n]) && buffer_[begin_ + n] != '\n') ++n;
  const std::string_view word(reinterpret_cast<const char*>(take(n)), n);
  if (n > kLongestWord) throw InputError(file_, "", fmt::format("found the word {}, expected a number", quote(word)));
  return word;
}

bool PlySource::next_line() {
  for (;;) {
    fill(1);
    if (begin_ == end_) return false;
    if (buffer_[begin_] != '\n' && !is_blank(buffer_[begin_])) return true;
    take(1);
  }
}

}  // namespace pipegs
