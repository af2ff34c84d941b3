// SPDX-License-Identifier: Apache-2.0
// outputs.cpp: see outputs.hpp.
#include "sim/command/outputs.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "scenes/atomic_file.hpp"
#include "scenes/input_error.hpp"
#include "sim/progress.hpp"

namespace pipegs {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 255;  // of a file or folder, in all file systems that matter

[[noreturn]] void refuse(const std::string& option, const fs::path& path, const std::string& what) {
  throw InputError(fmt::format("{} {}", option, quote(path.string())), "", "cannot be written: " + what);
}

fs::file_status status_of(const std::string& option, const fs::path& asked, const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::none) refuse(option, asked, error.message());
  return status;
}

// Whether folders below `folder`, and files in them, can be made.
void try_to_write(const std::string& option, const fs::path& asked, fs::path folder) {
  if (folder.empty()) folder = ".";
  for (const fs::path& part : folder) {
    if (part.string().size() > kLongestName)
      refuse(option, asked,
             fmt::format("found a name of {} bytes, expected at most {}", part.string().size(), kLongestName));
  }
  std::error_code error;
  while (!fs::exists(status_of(option, asked, folder))) {
    if (fs::is_symlink(fs::symlink_status(folder, error)))
      refuse(option, asked, quote(folder.string()) + " is a link to nothing, expected a folder");
    const fs::path above = folder.parent_path();
    folder = above.empty() ? fs::path(".") : above;
  }
  if (!fs::is_directory(status_of(option, asked, folder)))
    refuse(option, asked, quote(folder.string()) + " is a file, expected a folder");
  const fs::path probe = make_temporary_file(folder, error);
  if (probe.empty()) refuse(option, asked, "nothing can be made in the folder " + quote(folder.string()));
  fs::remove(probe, error);
}

void try_name(const std::string& option, const fs::path& asked, const fs::path& file) {
  const fs::file_status status = status_of(option, asked, file);
  if (fs::is_directory(status) || !file.has_filename())
    refuse(option, asked, quote(file.string()) + " is a folder, expected a file");
  if (fs::exists(status) && !fs::is_regular_file(status))
    refuse(option, asked, quote(file.string()) + " is no regular file");
}

}  // namespace

void try_folder(const std::string& option, const fs::path& folder, std::initializer_list<const char*> files) {
  if (folder.empty()) refuse(option, folder, "expected a folder");
  try_to_write(option, folder, folder);
  for (const char* file : files) try_name(option, folder, folder / file);
}

void try_file(const std::string& option, const fs::path& file) {
  if (file.empty()) return;
  try_name(option, file, file);
  try_to_write(option, file, file.parent_path());
}

void make_folder_of(const fs::path& file) {
  if (interrupted()) throw std::runtime_error("interrupted");
  const fs::path folder = file.parent_path();
  if (!folder.empty()) make_folders(folder);
}

void write_images(const std::string& folder, const Image& image, const std::optional<Rgb8>& picture) {
  make_folder_of(folder + "/frame.png");
  write_exr(fs::path(folder) / "frame.exr", image);
  write_png8(fs::path(folder) / "frame.png", picture ? *picture : to_rgb8(image, glm::dvec3(0)));
}

void write_text(const fs::path& path, const std::string& text) {
  make_folder_of(path);
  write_whole(path, text);
}

}  // namespace pipegs
