#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# again.sh: scene.py and render.py give the committed scene and pictures again: the scene bit for bit, the pictures but
# for the last digits, in which numpy's exponential differs from machine to machine. Exits 77 (skipped) without numpy.
set -euo pipefail
cd "$(dirname "$0")"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
./with_numpy.sh scene.py "$scratch"
cmp scene.ply "$scratch/scene.ply"
diff cameras.json "$scratch/cameras.json"
for view in 0 1; do
  ./with_numpy.sh render.py scene.ply cameras.json $view "$scratch/view.pfm"
  ./with_numpy.sh - "view_$view.pfm" "$scratch/view.pfm" << 'PYTHON'
import sys
import numpy
old, new = (numpy.frombuffer(open(path, "rb").read()[-64 * 48 * 12 :], "<f4") for path in sys.argv[1:])
worst = abs(old - new).max()
print(f"{sys.argv[1]}: largest difference {worst:.1e}")
sys.exit(int(worst > 1e-6))
PYTHON
done
