#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# style_finds.sh: style.py finds each thing that it looks for in a planted tree, one line each, and nothing in a tree
# without them.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd) failed=0
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
mkdir -p "$tree/docs" "$tree/scenes" "$tree/sim/memory"
finds() { "$here/style.py" "$tree" | grep -v 'files read'; }
plant() {  # FILE TEXT FIND: the file with the text gives the one find
  local path=$tree/$1 found
  printf '%b' "$2" > "$path"
  found=$(finds)
  if [[ $(wc -l <<< "$found") -ne 1 || $found != "$1:"*"$3"* ]]; then
    echo "planted '$3' in $1, found: $found"; failed=1
  fi
  rm "$path"
}
spdx='// SPDX-License-Identifier: Apache-2.0\n'
printf '%b' '# Page\n\nA paragraph on one line with a [link](#page).\n\n- an item\n- another\n' > "$tree/docs/good.md"
printf '%b' "$spdx" > "$tree/scenes/low.hpp"
[ -z "$(finds)" ] || { echo "found where nothing is: $(finds)"; failed=1; }
plant scenes/a.cpp 'int a;\n' "no SPDX"
plant scenes/a.cpp "${spdx}int a; \n" "blanks at the end"
plant scenes/a.cpp "${spdx}int a;" "one newline"
plant scenes/a.cpp "$spdx// $(printf 'x%.0s' $(seq 120))\n" "123 columns"
plant scenes/a.cpp "$spdx#include \"sim/memory/b.hpp\"\n" "a layer above"
plant sim/memory/a.cpp "$spdx#include \"sim/command/b.hpp\"\n" "a layer above"
plant scenes/a.cpp "${spdx}std::normal_distribution<double> any;\n" "a distribution of the library"
plant docs/a.md 'A paragraph\nthat is broken.\n' "a line break"
plant docs/a.md '- an item\n  that is broken\n' "a line break"
plant docs/a.md 'See [there](gone.md).\n' "dead link: gone.md"
plant docs/a.md 'See [there](good.md#gone).\n' "no heading #gone"
[ -z "$(finds)" ] || { echo "found where nothing is: $(finds)"; failed=1; }
exit "$failed"
