#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# with_numpy.sh SCRIPT.py ARGUMENT...: a Python that has numpy runs it. Exits 77 (skipped) where there is none.
for python in python3 /usr/bin/python3; do
  if "$python" -c 'import numpy' 2> /dev/null; then exec "$python" -B "$@"; fi
done
echo "skipped: no python3 with numpy (apt install python3-numpy)"
exit 77
