// SPDX-License-Identifier: Apache-2.0
// wave_disk.cpp: the writer of waves (GTKWave's, which comes with Verilator) does not look whether the disk took what
// it wrote: the linker sends its calls through these (build_rtl.sh), which note the first error for WaveFile. It also
// maps files that it wrote into memory. An access to what the disk did not take would be a SIGBUS: such a map is of no
// file.
#include <sys/mman.h>

#include <cerrno>
#include <cstdio>

#include "sim/rtl/wave_file.hpp"

namespace {

template <class Result>
Result noted(Result result, bool good) {
  if (!good && pipegs::wave_error == 0) pipegs::wave_error = errno != 0 ? errno : EIO;
  return result;
}

}  // namespace

extern "C" {

size_t __real_fwrite(const void* from, size_t size, size_t count, FILE* file);
int __real_fputc(int byte, FILE* file);
int __real_fflush(FILE* file);
int __real_fclose(FILE* file);
void* __real_mmap(void* at, size_t length, int access, int flags, int file, off_t offset);

size_t __wrap_fwrite(const void* from, size_t size, size_t count, FILE* file) {
  const size_t written = __real_fwrite(from, size, count, file);
  return noted(written, written == count || size == 0);
}
int __wrap_fputc(int byte, FILE* file) {
  const int written = __real_fputc(byte, file);
  return noted(written, written != EOF);
}
int __wrap_fflush(FILE* file) {
  const int flushed = __real_fflush(file);
  return noted(flushed, flushed == 0);
}
int __wrap_fclose(FILE* file) {
  const int closed = __real_fclose(file);
  return noted(closed, closed == 0);
}
void* __wrap_mmap(void* at, size_t length, int access, int flags, int file, off_t offset) {
  if (pipegs::wave_error == 0) return __real_mmap(at, length, access, flags, file, offset);
  return __real_mmap(at, length, access, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
}

}  // extern "C"
