#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# package.sh [--write] PACKAGE_SV REGISTERS_PRINT: the committed files that programs print are what they print now.
#
# Compares each; with --write, writes it.
set -euo pipefail
cd "$(dirname "$0")/../.."
write=""
if [ "$1" = --write ]; then write=1; shift; fi
package_sv=$1 registers=$2 status=0
printed() {  # FILE COMMAND ...
  local text; text=$(mktemp)
  "${@:2}" > "$text"
  if [ -n "$write" ]; then cp "$text" "$1"
  elif ! diff -u "$1" "$text"; then echo "$1 is stale: run make package"; status=1; fi
  rm -f "$text"
}
printed rtl/pipegs_pkg.sv "$package_sv"
printed sim/driver/pipegs_registers.h "$registers" header
printed docs/units/registers.md "$registers" page
printed package/pipegs_registers.rdl "$registers" rdl
printed package/pipegs_registers.xml "$registers" ipxact
exit $status
