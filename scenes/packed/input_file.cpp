// SPDX-License-Identifier: Apache-2.0
// input_file: see input_file.hpp.
#include "scenes/packed/input_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "scenes/input_error.hpp"
#include "scenes/text/text_file.hpp"

namespace pipegs {
namespace {

void check_name(const std::string& file, const std::string& name) {
  const std::filesystem::path path(name);
  const bool upwards = std::find(path.begin(), path.end(), "..") != path.end();
  if (name.empty() || upwards || path.is_absolute() || name.find(':') != std::string::npos ||
      name.find('\0') != std::string::npos) {
    throw InputError(file, "", fmt::format("found the file name {}, expected one below the same folder", quote(name)));
  }
}

}  // namespace

InputFile::InputFile(const std::filesystem::path& path)
    : InputFile(path.string(), read_text_file(path, "a scene", UINT64_MAX),
                [folder = path.parent_path()](const std::string& name) { return InputFile(folder / name); }) {}

InputFile::InputFile(std::string name, std::string bytes, Beside beside, std::uint64_t packed)
    : name_(std::move(name)),
      bytes_(std::make_shared<const std::string>(std::move(bytes))),
      beside_(std::move(beside)),
      packed_(packed) {}

InputFile::InputFile(std::string name, std::string bytes, Beside beside)
    : InputFile(std::move(name), std::move(bytes), std::move(beside), 0) {
  packed_ = size();
}

void PackedBytes::add(const InputFile& file) {
  if (contents_.emplace(file.text().size(), std::hash<std::string>{}(file.text())).second) sum_ += file.packed();
}

const std::uint8_t* InputFile::rows(std::uint64_t offset, std::uint64_t count, std::uint64_t stride,
                                    std::string_view what) const {
  const std::uint64_t left = offset <= size() ? size() - offset : 0;
  if (offset > size() || count > left / stride) {
    throw InputError(name_, what,
                     fmt::format("found {} x {} bytes at byte {}, but only {} bytes are left: the file is truncated or "
                                 "the count wrong",
                                 count, stride, offset, left));
  }
  return reinterpret_cast<const std::uint8_t*>(bytes_->data()) + offset;
}

InputFile InputFile::beside(std::string name) const {
  std::replace(name.begin(), name.end(), '\\', '/');  // as Windows writes it
  check_name(name_, name);
  if (beside_ == nullptr)
    throw InputError(name_, "", fmt::format("names {}, which does not lie beside it", quote(name)));
  return beside_(name);
}

}  // namespace pipegs
