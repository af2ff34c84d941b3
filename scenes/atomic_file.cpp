// SPDX-License-Identifier: Apache-2.0
// atomic_file: write aside, then rename; see atomic_file.hpp.
//
// Idea    The temporary name holds the process id and a counter, so two processes (or threads)
//         that write the same file do not write into each other; the last rename wins whole.
#include "scenes/atomic_file.hpp"

#include <unistd.h>

#include <atomic>
#include <system_error>

#include "scenes/input_error.hpp"
#include "scenes/own_failure.hpp"

namespace pipegs {

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path)) {
  static std::atomic<unsigned> counter{0};
  temporary_ = path_;
  temporary_ += ".tmp." + std::to_string(getpid()) + "." + std::to_string(counter++);
  const auto folder = path_.parent_path();
  std::error_code ignored;
  if (!folder.empty() && !std::filesystem::is_directory(folder, ignored)) {
    throw InputError(path_.string(), "", "cannot write: the folder " + quote(folder.string()) + " does not exist");
  }
  if (std::filesystem::is_directory(path_, ignored)) {
    throw InputError(path_.string(), "", "cannot write: a folder bears this name");
  }
}

AtomicFile::~AtomicFile() {
  if (committed_) return;
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

void AtomicFile::commit() {
  std::error_code error;
  std::filesystem::rename(temporary_, path_, error);
  if (error) throw OwnFailure(path_.string() + ": cannot write: " + error.message());
  committed_ = true;
}

}  // namespace pipegs
