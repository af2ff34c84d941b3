// ply_source: buffered reading; see ply_source.hpp.
//
// Idea    Valid bytes are buffer_[begin_, end_). fill() moves them to the front and reads on; the
//         buffer grows only for a single take() larger than itself.
#include "scenes/ply_source.hpp"

#include <algorithm>
#include <cstring>

#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 20;
constexpr std::size_t kLongestWord = 512;  // of an ASCII body; no number needs more

bool is_space(std::uint8_t c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

}  // namespace

PlySource::PlySource(const std::filesystem::path& path) : file_(path.string()), buffer_(kBufferBytes) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) throw InputError(file_, "", "cannot open, expected a .ply file");
  remaining_ = std::filesystem::file_size(path, error);
  stream_.open(path, std::ios::binary);
  if (error || !stream_) throw InputError(file_, "", "cannot open for reading");
}

void PlySource::fill(std::size_t wanted) {
  if (end_ - begin_ >= wanted) return;
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  if (buffer_.size() < wanted) buffer_.resize(wanted);
  while (end_ < wanted && stream_) {
    stream_.read(reinterpret_cast<char*>(buffer_.data() + end_), static_cast<std::streamsize>(buffer_.size() - end_));
    end_ += static_cast<std::size_t>(stream_.gcount());
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
  if (found == nullptr) return false;
  const auto n = static_cast<std::size_t>(static_cast<const std::uint8_t*>(found) - start);
  out.assign(reinterpret_cast<const char*>(start), n);
  if (!out.empty() && out.back() == '\r') out.pop_back();
  take(n + 1);
  return true;
}

std::string_view PlySource::word() {
  for (;;) {
    fill(1);
    if (begin_ == end_) return {};
    if (!is_space(buffer_[begin_])) break;
    take(1);
  }
  fill(kLongestWord);
  const std::size_t most = std::min(kLongestWord, end_ - begin_);
  std::size_t n = 0;
  while (n < most && !is_space(buffer_[begin_ + n])) ++n;
  return {reinterpret_cast<const char*>(take(n)), n};
}

}  // namespace pipegs
