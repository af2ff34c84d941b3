// SPDX-License-Identifier: Apache-2.0
// run_program.cpp: see run_program.hpp.
#include "sim/run_program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <stdexcept>
#include <thread>

#include "sim/progress.hpp"

namespace pipegs {
namespace {

using namespace std::chrono_literals;

std::array<std::atomic<pid_t>, 64> running;  // 0: none

pid_t spawn(const std::vector<std::string>& words, const std::filesystem::path& log) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setsigmask(&attributes, &none);
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t program = 0;
  if (posix_spawnp(&program, arguments[0], &files, &attributes, arguments.data(), environ) != 0) program = -1;
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return program;
}

}  // namespace

int run_program(const std::vector<std::string>& words, const std::filesystem::path& log) {
  const pid_t program = spawn(words, log);
  if (program < 0) return -1;
  std::atomic<pid_t>* place = nullptr;
  for (std::atomic<pid_t>& one : running) {
    pid_t none = 0;
    if (place == nullptr && one.compare_exchange_strong(none, program)) place = &one;
  }
  bool told = false;
  int status = 0;
  for (auto pause = 1ms; waitpid(program, &status, WNOHANG) == 0; pause = std::min(2 * pause, 20ms)) {
    if (!told && interrupted()) {
      told = true;
      kill(-program, SIGTERM);
    }
    std::this_thread::sleep_for(pause);
  }
  if (told) kill(-program, SIGKILL);  // what it has left
  if (place != nullptr) *place = 0;
  if (told || interrupted()) throw std::runtime_error("interrupted");
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void kill_programs() {
  for (const std::atomic<pid_t>& one : running) {
    if (one != 0) kill(-one, SIGKILL);
  }
}

}  // namespace pipegs
