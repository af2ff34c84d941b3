// SPDX-License-Identifier: Apache-2.0
// atomic_file: a file that appears under its name only when it is complete.
//
// Idea    Write to a temporary name in the same folder, then rename: rename is atomic within a
//         file system, so a reader sees the old file or the whole new one, never a half.
// Rule    The temporary file is made anew under a name that nobody can guess: a link that lies there is not followed.
// Use     AtomicFile out(path);  ... write to out.temporary() ...;  out.commit();
//         Without commit() (an exception, a full disk) the destructor removes the temporary file.
// Errors  InputError naming the file the caller asked for, not the temporary one; OwnFailure of a full disk.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace pipegs {

class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  const std::filesystem::path& temporary() const { return temporary_; }
  // The writer makes another file beside the temporary one, whose name has this behind it, and takes it away.
  void beside(const char* end);
  void commit();

 private:
  void forget();

  std::filesystem::path path_, temporary_, beside_;
  bool committed_ = false;
};

// A file of this text.
void write_whole(const std::filesystem::path& path, const std::string& text);

// A new empty file in the folder; an empty path and the error where none can be made.
std::filesystem::path make_temporary_file(const std::filesystem::path& folder, std::error_code& error);

// Makes a folder and those above it that are missing.
void make_folders(const std::filesystem::path& folder);

// For a program that ends in between: removes all temporary files, and folders that were made and hold nothing. A
// signal's handler may call it.
void abandon_files();

}  // namespace pipegs
