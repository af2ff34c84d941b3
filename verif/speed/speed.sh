#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# speed.sh: kHz of the Verilated machine, with every beat compared and with nothing looked at, in variants side by side.
#
#   speed.sh [POINT [CONFIG [VARIANT ...]]]     else fast, no CONFIG, and the variants of docs/cycles/timing_model.md
#
# A VARIANT is what sim/rtl/build_rtl.sh takes before the settings, without blanks between: +noasserts, or
# +apart+noasserts; `+` alone is the machine of `pipegs sim`. @COMMIT before it is the RTL of another commit, with
# today's package of the configuration. Their machines lie in the build folder under speed/. Other work on the computer
# slows all of them alike; the ratios hold. Exit code 3 when something does not build.
set -euo pipefail
cd "$(dirname "$0")/../.." || exit 3
build=$(realpath "${BUILD:-build}")
point=${1:-fast} config=${2-}
variants=("${@:3}")
if [ ${#variants[@]} = 0 ]; then
  any=cxx=-march=x86-64
  variants=("@70124d4+apart+$any" "+apart+$any" "+$any" + "+apart+noasserts+$any" +noasserts)
fi
log=$(mktemp)
trap 'rm -f "$log"' EXIT
quietly() { "$@" > "$log" 2>&1 || { tail -n 5 "$log" >&2; echo "speed.sh: $* failed" >&2; exit 3; }; }

quietly cmake --build "$build" --target machine_speed package_sv verilated_runtime
program=$build/verif/speed/machine_speed
settings=$("$program" "$point" "$config")
[ "$settings" != default ] || settings=
libraries=()
for variant in "${variants[@]}"; do
  folder=$build/speed/$point,${config//\//.}/$variant
  mkdir -p "$folder"
  source=. options=$variant
  if [[ $variant == @* ]]; then
    commit=${variant%%+*}
    options=${variant#"$commit"} source=$build/speed/source/$commit
    mkdir -p "$source"
    quietly git archive -o "$source.tar" "${commit#@}"
    quietly tar -x -f "$source.tar" -C "$source"
  fi
  words=()
  if [ "$options" != + ]; then read -ra words <<< "${options//+/ +}"; fi
  # shellcheck disable=SC2086  # the settings are words
  quietly "$source/sim/rtl/build_rtl.sh" "$build" "$folder" "${words[@]}" ${settings//,/ }
  libraries+=("$folder/librtl.so")
done
"$program" "$point" "$config" "${ROUNDS:-3}" "${WINDOWS:-2}" "${libraries[@]}"
