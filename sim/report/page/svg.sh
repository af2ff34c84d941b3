#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# svg.sh: charts of a command as one SVG file:
#   pipegs ladder --json | svg.sh OUT > ladder.svg
#
# OUT is the folder of build.sh, which it brings up to date; svg.mjs says what may stand on stdin. Exit code 4: npm has
# not brought the libraries.
set -euo pipefail
"$(dirname "$0")/build.sh" "$1" >&2
exec node "$1/svg.mjs"
