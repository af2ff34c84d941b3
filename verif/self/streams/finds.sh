#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# finds.sh BUILD: checkers.py and ready.py find what they are for: in copies of rtl/ with one fault each they name it.
set -uo pipefail
cd "$(dirname "$0")/../../.." || exit
build=$1 status=0 scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
try() {  # WHAT FILE SED WANTED COMMAND...: after the edit the command fails and names what is wanted
  local what=$1 file=$2 edit=$3 wanted=$4 said
  shift 4
  rm -rf "$scratch/rtl"
  cp -r rtl "$scratch/rtl"
  sed -E -i "$edit" "$scratch/rtl/$file"
  if cmp -s "rtl/$file" "$scratch/rtl/$file"; then echo "$what: the edit changes nothing"; status=1; fi
  said=$("$@" "$scratch") && { echo "$what: not found"; status=1; }
  grep -qF "$wanted" <<< "$said" || { echo "$what: '$wanted' is not said, but: $said"; status=1; }
}
# shellcheck disable=SC2317  # try calls it
on_one_machine() { verif/self/streams/ready.py "$build" "$1" units=1; }
try "a giver without a checker" dopu/dopu_origin.sv '/pipegs_stream_check/,/\);/d' \
  "dopu_origin: chunk_valid_o has no pipegs_stream_check" verif/self/streams/checkers.py
try "one of two givers without a checker" pu/rows/pu_allocate.sv '/ u_check_row_job /,/\);/d' \
  "pu_allocate: row_job_valid_o has no pipegs_stream_check" verif/self/streams/checkers.py
try "logic that feeds a stream" ru/pipegs_ru.sv \
  's/write_valid_i\(write_valid\)/write_valid_i(write_valid \&\& !idle_o)/' \
  "pipegs_ru: write_valid_i of ru_memory is fed by write_valid && !idle_o" verif/self/streams/checkers.py
try "a valid that waits for ready" dopu/dopu_origin.sv 's/(chunk_valid_o = )/\1chunk_ready_i \&\& /' \
  "dopu_origin: chunk_valid_o depends on chunk_ready_i" on_one_machine
exit $status
