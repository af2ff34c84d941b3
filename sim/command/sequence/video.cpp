// SPDX-License-Identifier: Apache-2.0
// video.cpp: see video.hpp.
#include "sim/command/sequence/video.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <vector>

#include "cpp_model/config.hpp"
#include "scenes/own_failure.hpp"
#include "scenes/text/quote.hpp"
#include "sim/command/outputs.hpp"

namespace pipegs {
namespace {

bool is_on_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::string folders = path == nullptr ? "" : path;
  for (std::size_t begin = 0; begin <= folders.size();) {
    const std::size_t end = std::min(folders.find(':', begin), folders.size());
    const std::filesystem::path file = std::filesystem::path(folders.substr(begin, end - begin)) / program;
    std::error_code ignored;
    if (std::filesystem::is_regular_file(file, ignored) && access(file.c_str(), X_OK) == 0) return true;
    begin = end + 1;
  }
  return false;
}

std::vector<std::string> command_line(int width, int height, int frames_per_second, const std::string& file) {
  const std::string colors = "bt709";
  return {"ffmpeg", "-hide_banner", "-loglevel", "error", "-y",
          // what comes
          "-f", "rawvideo", "-pixel_format", "rgb24", "-video_size", fmt::format("{}x{}", width, height), "-framerate",
          fmt::to_string(frames_per_second), "-i", "pipe:0",
          // what becomes of it
          "-an", "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=" + colors + ":out_range=tv", "-c:v",
          "libx264", "-crf", "16", "-pix_fmt", "yuv420p", "-colorspace", colors, "-color_primaries", colors,
          "-color_trc", colors, "-color_range", "tv", "-movflags", "+faststart", "-f", "mp4", "file:" + file};
}

}  // namespace

void try_video(const std::string& option, const std::filesystem::path& file) {
  if (file.empty()) return;
  if (file.extension() != ".mp4")
    throw ConfigError(fmt::format("{}: found {}, expected a name that ends in .mp4", option, quote(file.string())));
  try_file(option, file);
  if (!is_on_path("ffmpeg"))
    throw ConfigError(option +
                      ": found no ffmpeg on the PATH, expected it (Debian's package ffmpeg); the frames in "
                      "--out are numbered for any other encoder");
}

Video::Video(const std::filesystem::path& file, int frames_per_second)
    : file_(file), frames_per_second_(frames_per_second) {
  make_folder_of(file);
  aside_.emplace(file);
}

Video::~Video() {
  if (ffmpeg_ < 0) return;
  kill(ffmpeg_, SIGKILL);
  wait();
}

void Video::start(int width, int height) {
  int ends[2];
  said_.reset(std::tmpfile());
  if (!said_ || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw OwnFailure(file_.string() + ": no socket or temporary file for ffmpeg");
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, ends[1], STDIN_FILENO);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, fileno(said_.get()), STDERR_FILENO);
  posix_spawnattr_t attributes;  // an interrupt of the terminal is ours alone: it is the destructor that ends ffmpeg
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  std::vector<std::string> words = command_line(width, height, frames_per_second_, aside_->temporary().string());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const int error = posix_spawnp(&ffmpeg_, "ffmpeg", &files, &attributes, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&attributes);
  close(ends[1]);
  socket_ = ends[0];
  if (error == 0) return;
  ffmpeg_ = -1;
  close(socket_);
  throw OwnFailure(fmt::format("{}: ffmpeg does not start: error {}", file_.string(), error));
}

int Video::wait() {
  close(socket_);
  int status = 0;
  while (waitpid(ffmpeg_, &status, 0) < 0 && errno == EINTR) {}
  ffmpeg_ = -1;
  return status;
}

void Video::fail(int status) {
  char line[300] = "";
  std::rewind(said_.get());
  std::string said = std::fgets(line, sizeof line, said_.get()) == nullptr ? "" : line;
  while (!said.empty() && said.back() == '\n') said.pop_back();
  if (said.empty())
    said = WIFSIGNALED(status) ? fmt::format("signal {}", WTERMSIG(status))
                               : fmt::format("exit code {}", WEXITSTATUS(status));
  throw OwnFailure(fmt::format("{}: ffmpeg failed: {}", file_.string(), said));
}

void Video::add(const Rgb8& picture) {
  if (ffmpeg_ < 0) start(picture.width, picture.height);
  for (std::size_t sent = 0; sent < picture.data.size();) {
    const ssize_t more = send(socket_, picture.data.data() + sent, picture.data.size() - sent, MSG_NOSIGNAL);
    if (more < 0 && errno == EINTR) continue;
    if (more < 0) fail(wait());
    sent += static_cast<std::size_t>(more);
  }
}

void Video::finish() {
  const int status = wait();
  if (status != 0 || !std::filesystem::exists(aside_->temporary())) fail(status);
  aside_->commit();
}

}  // namespace pipegs
