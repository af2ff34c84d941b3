#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# style.sh: what a program can say about how the tree is written: style.py (columns, SPDX, Markdown, folders, includes),
# clang-format and black (nothing to change), shellcheck (no warning), codespell (no misspelling).
#
# A tool that is not installed is named as not run; `make test` installs them all. `make format` applies the formats.
set -uo pipefail
cd "$(dirname "$0")/../.." || exit
status=0
listed() { git ls-files -co --exclude-standard -- "$@"; }
run() {  # TOOL COMMAND ...: its finds are printed and fail the check
  local tool=$1 log
  if ! command -v "$tool" > /dev/null; then echo "not run: $tool is not installed"; return; fi
  if ! log=$("${@:2}" 2>&1); then echo "$tool:"; head -n 40 <<< "$log"; status=1; fi
}
git rev-parse --git-dir > /dev/null 2>&1 || { echo "not run: this is no clone, so its files are not known"; exit 0; }
mapfile -t cpp < <(listed '*.cpp' '*.hpp')
mapfile -t python < <(listed '*.py')
mapfile -t shell < <(listed '*.sh' .ci/run)
mapfile -t prose < <(listed '*.md' '*.cpp' '*.hpp' '*.sv' '*.svh' '*.def' '*.py' '*.sh' '*.txt' \
  '*.cmake' '*.cff' Makefile)

verif/self/style.py || status=1
run clang-format clang-format --dry-run --Werror "${cpp[@]}"
run black black --quiet --check --diff "${python[@]}"
run shellcheck shellcheck --severity=warning "${shell[@]}"
run codespell codespell --ignore-words verif/self/words.txt "${prose[@]}"
exit "$status"
