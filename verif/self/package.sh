#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# package.sh PACKAGE_SV: the committed rtl/pipegs_pkg.sv is what package_sv prints from config.def and records.def
set -euo pipefail
cd "$(dirname "$0")/../.."
diff -u rtl/pipegs_pkg.sv <("$1") || { echo "rtl/pipegs_pkg.sv is stale: run make package"; exit 1; }
