// SPDX-License-Identifier: Apache-2.0
// atomic_file: a file that appears under its name only when it is complete.
//
// Idea    Write to a temporary name in the same folder, then rename: rename is atomic within a
//         file system, so a reader sees the old file or the whole new one, never a half.
// Use     AtomicFile out(path);  ... write to out.temporary() ...;  out.commit();
//         Without commit() (an exception, a full disk) the destructor removes the temporary file.
// Errors  InputError naming the file the caller asked for, not the temporary one.
#pragma once

#include <filesystem>

namespace pipegs {

class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  const std::filesystem::path& temporary() const { return temporary_; }
  void commit();

 private:
  std::filesystem::path path_, temporary_;
  bool committed_ = false;
};

}  // namespace pipegs
