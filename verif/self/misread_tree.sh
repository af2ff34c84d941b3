#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# misread_tree.sh FOLDER: these sources in FOLDER, which is empty, with an element of an array in a concatenation on an
# output port once more.
#
# Yosys 0.23 reads the depth of a chunk there as a memory that nobody writes (docs/trust/trust.md#the-netlist). It is
# written over two lines, so synth/misread.sh does not find it. rtl/ and synth/ are copies, all else are links.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd) tree=$1
cp -r "$root/rtl" "$root/synth" "$tree"
for other in cpp_model scenes sim verif; do ln -s "$root/$other" "$tree/$other"; done
place=$tree/rtl/dopu/nearest/dopu_nearest.sv
sed -i -e '/^ *logic \[BucketW-1:0\] *bucket;$/d' -e '/^ *assign held_bucket\[l\] = bucket;$/d' \
  -e 's/\(\.out_o({held_last\[l\], held_pass\[l\],\) bucket,/\1\n          held_bucket[l],/' "$place"
if [ "$(diff "$root/${place#"$tree/"}" "$place" | sed -n 's/^\([<>]\).*/\1/p' | tr -d '\n')" != "<<>><" ]; then
  echo "misread_tree.sh: $place has another text" >&2
  exit 3
fi
