// SPDX-License-Identifier: Apache-2.0
// terminal.cpp: see terminal.hpp.
#include "sim/command/terminal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "scenes/text/quote.hpp"
#include "sim/progress.hpp"

namespace pipegs {
namespace {

struct Stream {
  int file;
  std::string begun;  // the bytes of a character that is not complete yet
};
Stream g_out{STDOUT_FILENO, {}}, g_err{STDERR_FILENO, {}};

bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(file, text.data(), text.size());
    if (written <= 0) return false;
    text.remove_prefix(static_cast<size_t>(written));
  }
  return true;
}

ssize_t pass(void* cookie, const char* bytes, size_t count) {
  Stream& stream = *static_cast<Stream*>(cookie);
  std::string text = stream.begun + std::string(bytes, count);
  const size_t whole = text.size() - quote_detail::begun(text);
  stream.begun = text.substr(whole);
  Progress::hide();
  const bool written = write_all(stream.file, shown(std::string_view(text).substr(0, whole), true));
  return written || stream.file == STDERR_FILENO ? static_cast<ssize_t>(count) : 0;
}

FILE* guarded(Stream& stream, int buffering) {
  FILE* file = fopencookie(&stream, "w", {.read = nullptr, .write = pass, .seek = nullptr, .close = nullptr});
  if (file != nullptr) std::setvbuf(file, nullptr, buffering, BUFSIZ);
  return file;
}

}  // namespace

void guard_terminal() {
  // What is closed would be the number of the next file that is opened. Nothing can be written to this one, either.
  for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(file, F_GETFD) < 0) open("/dev/null", file == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
  if (FILE* out = guarded(g_out, isatty(STDOUT_FILENO) != 0 ? _IOLBF : _IOFBF)) stdout = out;
  if (FILE* err = guarded(g_err, _IONBF)) stderr = err;
}

}  // namespace pipegs
