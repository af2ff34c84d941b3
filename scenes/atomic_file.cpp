// SPDX-License-Identifier: Apache-2.0
// atomic_file: write aside, then rename; see atomic_file.hpp.
//
// Idea    A list knows what lies aside, so that the handler of a signal can take it away, whatever this program does
//         just then: it is memory that is always there, and a place of it is read only while it is in use.
#include "scenes/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstring>
#include <fstream>
#include <random>
#include <string>
#include <system_error>
#include <vector>

#include "scenes/input_error.hpp"
#include "scenes/own_failure.hpp"

namespace pipegs {
namespace {

namespace fs = std::filesystem;

// Paths, as many as fit: what is more is not taken away.
template <std::size_t count>
class PathList {
 public:
  void add(const fs::path& path) {
    const std::string& text = path.native();
    for (Place& place : places_) {
      State free = State::kFree;
      if (text.size() >= sizeof place.path || !place.state.compare_exchange_strong(free, State::kFilled)) continue;
      std::memcpy(place.path, text.c_str(), text.size() + 1);
      place.state = State::kUsed;
      return;
    }
  }
  void remove(const fs::path& path) {
    for (Place& place : places_) {
      if (place.state == State::kUsed && path.native() == place.path) place.state = State::kFree;
    }
  }
  template <typename Remove>
  void remove_all(const Remove& remove) const {
    for (auto place = places_.rbegin(); place != places_.rend(); ++place) {
      if (place->state == State::kUsed) remove(place->path);
    }
  }

 private:
  enum class State { kFree, kFilled, kUsed };
  struct Place {
    std::atomic<State> state{State::kFree};
    char path[PATH_MAX];
  };
  std::array<Place, count> places_;
};

PathList<64> g_files;
PathList<16> g_folders;  // that were made, the outer ones first

fs::path random_name() {
  static constexpr char kDigits[] = "0123456789abcdefghijklmnopqrstuv";
  std::random_device random;
  std::string name = ".pipegs.";
  for (int i = 0; i < 16; ++i) name += kDigits[random() & 31];
  return name;
}

}  // namespace

fs::path make_temporary_file(const fs::path& folder, std::error_code& error) {
  for (int tries = 0; tries < 10; ++tries) {
    const fs::path path = folder / random_name();
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (file >= 0) {
      close(file);
      error.clear();
      return path;
    }
    error.assign(errno, std::system_category());
    if (errno != EEXIST) break;
  }
  return {};
}

void make_folders(const fs::path& folder) {
  std::vector<fs::path> missing;
  std::error_code ignored;
  for (fs::path one = folder; !one.empty() && !fs::exists(one, ignored); one = one.parent_path())
    missing.push_back(one);
  fs::create_directories(folder);
  for (auto one = missing.rbegin(); one != missing.rend(); ++one) g_folders.add(*one);
}

void abandon_files() {
  g_files.remove_all(unlink);
  g_folders.remove_all(rmdir);
}

AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)) {
  const fs::path folder = path_.parent_path();
  std::error_code error;
  if (!folder.empty() && !fs::is_directory(folder, error)) {
    throw InputError(path_.string(), "", "cannot write: the folder " + quote(folder.string()) + " does not exist");
  }
  if (fs::is_directory(path_, error)) {
    throw InputError(path_.string(), "", "cannot write: a folder bears this name");
  }
  temporary_ = make_temporary_file(folder, error);
  if (temporary_.empty()) throw OwnFailure(path_.string() + ": cannot write: " + error.message());
  g_files.add(temporary_);
}

AtomicFile::~AtomicFile() {
  if (committed_) return;
  std::error_code ignored;
  fs::remove(temporary_, ignored);
  forget();
}

void AtomicFile::beside(const char* end) {
  beside_ = temporary_;
  beside_ += end;
  g_files.add(beside_);
}

void AtomicFile::forget() {
  g_files.remove(temporary_);
  if (beside_.empty()) return;
  std::error_code ignored;
  fs::remove(beside_, ignored);
  g_files.remove(beside_);
}

void AtomicFile::commit() {
  std::error_code error;
  fs::rename(temporary_, path_, error);
  if (error) throw OwnFailure(path_.string() + ": cannot write: " + error.message());
  forget();
  committed_ = true;
}

void write_whole(const std::filesystem::path& path, const std::string& text) {
  AtomicFile file(path);
  std::ofstream out(file.temporary(), std::ios::binary);
  out << text;
  out.close();
  if (!out) throw OwnFailure(path.string() + ": cannot write");
  file.commit();
}

}  // namespace pipegs
