// SPDX-License-Identifier: Apache-2.0
// video.hpp: pictures, one after the other, through ffmpeg into a .mp4 file.
//
// Idea    ffmpeg reads raw pictures from a socket, which unlike a pipe tells of a reader that is gone without a signal.
//         It writes aside; the file appears when all pictures are in it and ffmpeg has ended well (AtomicFile).
// Format  H.264 with 4:2:0 colours (BT.709), which every player takes; a side of an odd number of pixels gets a black
//         one more.
// Errors  ConfigError: the name does not end in .mp4, no ffmpeg is on the PATH. OwnFailure: ffmpeg fails, with what it
//         says.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "cpp_model/float/image.hpp"
#include "scenes/atomic_file.hpp"

namespace pipegs {

// Whether a video of this name can be made; asked before anything is computed.
void try_video(const std::string& option, const std::filesystem::path& file);

class Video {
 public:
  Video(const std::filesystem::path& file, int frames_per_second);
  ~Video();  // without finish() nothing is left
  Video(const Video&) = delete;

  void add(const Rgb8& picture);  // all of one size
  void finish();

 private:
  void start(int width, int height);
  int wait();  // for ffmpeg's end: its status
  [[noreturn]] void fail(int status);

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::filesystem::path file_;
  int frames_per_second_;
  std::optional<AtomicFile> aside_;
  std::unique_ptr<std::FILE, Close> said_;  // what ffmpeg says
  int socket_ = -1;
  pid_t ffmpeg_ = -1;
};

}  // namespace pipegs
