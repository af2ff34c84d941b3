#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# prove.sh [--daily] [NAME ...]: formal proofs of the RTL with Yosys, and mutants of the RTL that they must refute
#
# Idea    synth/prove/table.sh names each proof. A checker (synth/prove/*/*_proof.svh) is put before the last line of
#         a copy of its module, where it sees every signal: Yosys 0.23 reads `bind` and ignores it. `sat -tempinduct`
#         then proves all assertions for every trace of any length: no step from a state that satisfies them leads to
#         one that does not.
# Mutants A sed command changes the copy; from reset a trace must be found that breaks an assertion. A proof that fails
#         in its step only, an error, or a command that changes nothing does not count.
#         With --daily every change must apply, and a seventh of the mutants is run, another one each day of the week.
# Reading Any warning of Yosys (but that a small array becomes registers), a latch, an undriven or doubly driven signal,
#         or no assertion at all, is a failure.
# Output  One line per proof and per mutant, with the processor's seconds, of which a call of Yosys has at most 600;
#         $BUILD/prove/NAME.log. Exits 1 when a proof fails or a mutant is proved.
set -uo pipefail
cd "$(dirname "$0")/.." || exit
day=''
if [ "${1:-}" = --daily ]; then day=$(date +%u); shift; fi
build=${BUILD:-build} here=synth/prove wanted=" $* " proofs=0 mutants=0 failed=0
out=$build/prove; mkdir -p "$out"
# Machines with the instances to prove: the design points, one with pu_compensate, and fewer units.
mapfile -t machines < <(synth/design_points.py | sed 's/^[^ ]* *//')
machines+=("antialias=1" "units=2" "units=1")

package() { local settings=${1#default}; "$build/cpp_model/package_sv" ${settings//,/ }; }
source_of() {  # the file of a module: the proof's own one, else the RTL
  if [ -e "$here/parts/$1.sv" ]; then echo "$here/parts/$1.sv"; else find rtl -name "$1.sv" | grep .; fi
}

# instances MODULE: the parameters of its instances in all machines, one set per line, from Yosys' log of each
instances() {
  local list=$out/instances.txt machine files
  if [ ! -e "$list" ] || [ -n "$(find rtl "$build/cpp_model/package_sv" -newer "$list" -name '*[^~]' -type f)" ]; then
    files=$(find rtl -name '*.sv' ! -name pipegs_pkg.sv | sort | tr '\n' ' ')
    for machine in "${machines[@]}"; do
      "$build/cpp_model/package_sv" $machine > "$list.$$.sv" &&
        yosys -p "read_verilog -sv -defer $list.$$.sv $files; hierarchy -check -top pipegs_axi" || echo ERROR
    done | awk -F"[\`']" '/ERROR/ {print "ERROR"}
        /derive mode using pre-parsed AST for module/ {name = substr($2, 2); set = ""}
      /^Parameter / {split($0, part, /[\\ ]+/); set = set " " part[2] "=" part[4]}
      /^Generating RTLIL/ {if (set != "") print name set; set = ""}' | sort -u > "$list.$$"
    mv "$list.$$" "$list"; rm -f "$list.$$.sv"
  fi
  if grep -q ERROR "$list"; then rm "$list"; echo ERROR; else sed -n "s/^$1 //p" "$list"; fi
}

# sets_of PARAMETERS: one set per line; "machine Name=value": every instance of the top in every machine, with this
# changed
sets_of() {
  if [ "${1%% *}" != machine ]; then tr '\n' ' ' <<< "$1" | sed 's/; */\n/g'; return; fi
  local change sets; sets=$(instances "$top")
  for change in ${1#machine}; do sets=$(sed -E "s/\b${change%=*}=[0-9]+/$change/" <<< "$sets"); done
  sort -u <<< "$sets"
}

# run FOLDER PARAMETERS SAT: one call of Yosys with the proof's modules, some of which may lie changed in FOLDER. Prints
# "proved", "refuted" or what went wrong.
run() {
  local folder=$1 log=$1/log sources=() chparam="" token name checker
  for token in $2; do
    case $token in
      @*) package "${token#@}" > "$folder/pipegs_pkg.sv" || { echo "no package"; return; }
          sources+=("$folder/pipegs_pkg.sv") ;;
      %*) name=${token#%}
          grep -q " ${name%=*} *= " "$folder/pipegs_pkg.sv" || { echo "no constant $name"; return; }
          sed -i "s/ ${name%=*} *= [^;]*;/ ${name/=/ = };/" "$folder/pipegs_pkg.sv" ;;
      *) chparam+=" -chparam ${token/=/ }" ;;
    esac
  done
  for token in $modules; do
    name=${token%%+*} checker=${token#*+}
    [ -e "$folder/$name.sv" ] || cp "$(source_of "$name")" "$folder/$name.sv" || { echo "no $name"; return; }
    if [ "$name" != "$token" ]; then
      grep -q '^endmodule' "$folder/$name.sv" || { echo "no end of $name"; return; }
      checker=$(find "$here" -name "${checker:-${name#pipegs_}}_proof.svh")
      sed -i "/^endmodule/i \`include \"${checker#"$here/"}\"" "$folder/$name.sv"
    fi
    sources+=("$folder/$name.sv")
  done
  (ulimit -t 600; exec yosys -ql "$log" -p "read_verilog -sv -defer -formal -DSYNTHESIS -I$here ${sources[*]} \
      $here/parts/proof_*.sv
    hierarchy -check -top $top$chparam; proc; flatten; opt_clean; check -assert
    select -assert-none t:\$*latch*; memory -nomap; memory_map; async2sync; opt_clean
    select -assert-min 1 t:\$assert; sat -prove-asserts -set-assumes $3") > /dev/null 2>&1
  local status=$?
  if name=$(grep -iE 'warning|implicitly|unsupported|ignoring' "$log" |
      grep -vEm1 '^Warnings: |Replacing memory .* with list of registers'); then echo "misread: $name"
  elif grep -q 'Induction step proven: SUCCESS!' "$log" && [ $status -eq 0 ]; then echo proved
  elif grep -q 'model found for base case: FAIL!' "$log"; then echo refuted
  elif grep -q 'proof failed\|did fail' "$log"; then echo "not proved: a step breaks it, or no trace from reset does"
  elif grep -q 'proved base case' "$log"; then echo "not refuted: no trace of so many steps breaks it"
  else echo "$(tail -n 1 "$log") ($status)"; fi
}

# attempt WHAT PARAMETERS SAT [CHANGED MODULE]: a run in a folder of its own, its log behind that of the proof;
# prints the verdict
attempt() {
  local folder verdict; folder=$(mktemp -d)
  [ $# -lt 4 ] || mv "$4" "$folder/$top.sv"
  verdict=$(run "$folder" "$2" "$3")
  { echo "== $1, $2: $verdict"; cat "$folder/log"; } >> "$log" 2>/dev/null
  rm -rf "$folder"
  echo "$verdict"
}

report() {  # NAME VERDICT WHAT FROM: the seconds are those that the processor spent in Yosys since line FROM of the log
  awk -v name="$1" -v verdict="$2" -v what="${3//\\/}" -v from="$4" \
    'NR > from && /CPU: user/ {sum += $(NF - 6) + $(NF - 4)}
     END {printf "%-20s %-8s %5.1f s  %s\n", name, verdict, sum, what}' "$log"
  if [ "$2" = FAILED ]; then failed=$((failed + 1)); fi
}

# --- the two words of the table ---------------------------------------------------------------------------------------
proof() {  # NAME MODULES PARAMETERS
  local sets set verdict
  name=$1 modules=$2 top=${2%%[ +]*} log=$out/$1.log skipped=1
  [[ $wanted = "  " || $wanted = *" $name "* ]] || return 0
  : > "$log"
  skipped="" proofs=$((proofs + 1))
  mapfile -t sets < <(sets_of "$3")
  first=${sets[0]}
  for set in "${sets[@]}"; do
    verdict=$(attempt "$name" "$set" "-tempinduct -initsteps 1 -maxsteps 2 -verify")
    if [ "$verdict" != proved ]; then report "$name" FAILED "$set: $verdict" 0; return; fi
  done
  report "$name" proved "${#sets[@]} sets of parameters" 0
}

mutant() {  # WHAT CHANGE [PARAMETERS]: of the proof above
  local source changed verdict from
  [ -z "$skipped" ] || return 0
  mutants=$((mutants + 1)) from=$(wc -l < "$log") source=$(source_of "$top") changed=$(mktemp)
  sed -E "$2" "$source" > "$changed"
  if cmp -s "$changed" "$source"; then verdict="the change did not apply"
  elif [ -n "$day" ] && [ $(((mutants + day) % 7)) != 0 ]; then verdict=applies
  else
    verdict=$(attempt "$name, changed: $1" "${3:-$first}" "-tempinduct -tempinduct-baseonly -maxsteps 16" "$changed")
  fi
  rm -f "$changed"
  case $verdict in
    refuted | applies) report "" "$verdict" "$1" "$from" ;;
    *) report "" FAILED "$1: $verdict" "$from" ;;
  esac
}

. "$here/table.sh"
[ $proofs -gt 0 ] || { echo "no such proof: $*"; exit 1; }
echo "$proofs proofs, $mutants mutants, $failed failed"
[ $failed -eq 0 ]
