#!/usr/bin/env bash
# package.sh: the committed rtl/pipegs_pkg.sv is what package_sv prints from config.def and records.def: package.sh PACKAGE_SV
set -euo pipefail
cd "$(dirname "$0")/../.."
diff -u rtl/pipegs_pkg.sv <("$1") || { echo "rtl/pipegs_pkg.sv is stale: run make package"; exit 1; }
