// SPDX-License-Identifier: Apache-2.0
// input_file: the bytes of a whole file, and the files beside it that it names.
//
// Idea    A reader asks for bytes by offset and size, or for rows of a size, and gets a pointer to as many bytes as it
//         asked for, or an InputError that says what is missing. So no count of a file is believed before it is held
//         against the file's size. A file that was packed in another one looks the same as one on disk.
// Rule    A file names others by a path below its own folder: one that is absolute, leads upwards or is a URL is
//         refused, and only regular files are opened.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace pipegs {

static_assert(std::endian::native == std::endian::little, "the formats are little-endian, and read as they lie");

template <typename T>
T load(const std::uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

class InputFile {
 public:
  using Beside = std::function<InputFile(const std::string& name)>;

  explicit InputFile(const std::filesystem::path& path);
  // Bytes in memory; `name` is what errors call them. Without `beside` no file lies beside them.
  InputFile(std::string name, std::string bytes, Beside beside = nullptr);
  InputFile(std::string name, std::string bytes, Beside beside, std::uint64_t packed);

  const std::string& name() const { return name_; }
  std::uint64_t size() const { return bytes_->size(); }
  std::uint64_t packed() const { return packed_; }  // bytes on disk that it came of
  const std::string& text() const { return *bytes_; }
  bool starts_with(std::string_view signature) const { return text().starts_with(signature); }

  // `count` rows of `stride` bytes at `offset`; `what` names them in the InputError when they are not there.
  const std::uint8_t* rows(std::uint64_t offset, std::uint64_t count, std::uint64_t stride,
                           std::string_view what) const;
  std::span<const std::uint8_t> part(std::uint64_t offset, std::uint64_t size, std::string_view what) const {
    return {rows(offset, size, 1, what), static_cast<std::size_t>(size)};
  }
  template <typename T>
  T at(std::uint64_t offset, std::string_view what) const {
    return load<T>(rows(offset, 1, sizeof(T), what));
  }
  // How many bytes follow `end`.
  std::uint64_t behind(std::uint64_t end) const { return size() - std::min(end, size()); }

  InputFile beside(std::string name) const;

 private:
  std::string name_;
  std::shared_ptr<const std::string> bytes_;
  Beside beside_;
  std::uint64_t packed_;
};

// Adds up the bytes on disk of files, those of each content once: a name for it more makes them no more.
class PackedBytes {
 public:
  void add(const InputFile& file);
  std::uint64_t sum() const { return sum_; }

 private:
  std::set<std::pair<std::size_t, std::size_t>> contents_;  // size and hash
  std::uint64_t sum_ = 0;
};

}  // namespace pipegs
