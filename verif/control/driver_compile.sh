#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# driver_compile.sh: cpp_model/driver as a program without an operating system compiles it.
#
# Each C file is compiled by gcc and by clang as strict C99 without a hosted library, every warning an error, and calls
# nothing but the driver's own functions and what a compiler itself may call. The headers are C++, too.
set -euo pipefail
cd "$(dirname "$0")/../../cpp_model/driver"
status=0 folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
# Stands for what `pipegs pack` prints; the test `example` has the real one.
cat > "$folder/scene.h" << 'END'
#include "pipegs_frame.h"
static const struct pipegs_scene pipegs_packed_scene = {.exponent = 0};
static const struct pipegs_camera pipegs_packed_camera = {.near_plane = PIPEGS_NEAR_PLANE};
#define PIPEGS_PACKED_HALF {{1, 0}, {0, 0}}
END
for compiler in gcc clang; do
  command -v "$compiler" > /dev/null || { echo "not run: $compiler is not installed"; continue; }
  for file in *.c; do
    "$compiler" -std=c99 -ffreestanding -Wall -Wextra -pedantic -Wconversion -Wshadow -Werror -O2 -I"$folder" -I. \
      -c "$file" -o "$folder/${file%.c}.$compiler.o" || status=1
  done
  for object in "$folder"/*."$compiler".o; do
    other=$(nm -u "$object" | awk '{print $2}' |
      grep -vE '^(_GLOBAL_OFFSET_TABLE_|mem(cpy|set|move|cmp)|pipegs_\w+)$' || true)
    [ -z "$other" ] || { echo "$(basename "$object") calls" $other; status=1; }
  done
  for header in *.h; do
    "$compiler" -x c++ -std=c++11 -Wall -Wextra -pedantic -Werror -fsyntax-only - <<< "#include \"$PWD/$header\"" ||
      status=1
  done
done
exit $status
