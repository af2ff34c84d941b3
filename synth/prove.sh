#!/usr/bin/env bash
# prove.sh: formal proofs of the RTL with Yosys, and changed copies of the RTL that they must refute: prove.sh [NAME ...]
#
# Idea    synth/prove/table.sh names each proof. A checker (synth/prove/*_proof.svh) is put before the last line of
#         a copy of its module, where it sees every signal: Yosys 0.23 reads `bind` and ignores it. `sat -tempinduct` then proves
#         all assertions for every trace of any length: no step from a state that satisfies them leads to one that does not.
# Mutants A sed command changes the copy; from reset a trace must be found that breaks an assertion. A proof that fails
#         in its step only, an error, or a command that changes nothing does not count.
# Reading Any warning of Yosys (but that a small array becomes registers), a latch, an undriven or doubly driven signal, or no assertion at all, is a failure.
# Output  One line per proof and per mutant, with the processor's seconds; $BUILD/prove/NAME.log. Exits 1 when a proof fails or a mutant is proved.
#         Parameters "machine": every instance on every rung of the ladder, from $BUILD/cpp_model/package_sv.
set -uo pipefail
cd "$(dirname "$0")/.."
build=${BUILD:-build} here=synth/prove failed=0
out=$build/prove; mkdir -p "$out"
rungs=("" "antialias=1" "late=1" "order=1" "late=1 order=1" "late=1 order=1 quadratic=1" "late=1 order=2" "units=2" "units=1")

package() { if [ "$1" = default ]; then cat rtl/pipegs_pkg.sv; else "$build/cpp_model/package_sv" ${1//,/ }; fi; }
source_of() {  # the file of a module: the proof's own one, else the RTL
  if [ -e "$here/$1.sv" ]; then echo "$here/$1.sv"; else ls rtl/"$1".sv rtl/*/"$1".sv 2>/dev/null; fi
}

# instances MODULE: the parameters of its instances on all rungs, one set per line, from Yosys' log of the whole machine
instances() {
  local list=$out/instances.txt rung files
  if [ ! -e "$list" ] || [ -n "$(find rtl synth/prove.sh "$build/cpp_model/package_sv" -newer "$list" -name '*[^~]' -type f)" ]; then
    files=$(ls rtl/*.sv rtl/*/*.sv | grep -v pipegs_pkg | tr '\n' ' ')
    for rung in "${rungs[@]}"; do
      "$build/cpp_model/package_sv" $rung > "$list.$$.sv" &&
        yosys -p "read_verilog -sv -defer $list.$$.sv $files; hierarchy -check -top pipegs_top" || echo ERROR
    done | awk -F"[\`']" '/ERROR/ {print "ERROR"} /derive mode using pre-parsed AST for module/ {name = substr($2, 2); set = ""}
      /^Parameter / {split($0, part, /[\\ ]+/); set = set " " part[2] "=" part[4]}
      /^Generating RTLIL/ {if (set != "") print name set; set = ""}' | sort -u > "$list.$$"
    mv "$list.$$" "$list"; rm -f "$list.$$.sv"
  fi
  if grep -q ERROR "$list"; then rm "$list"; echo ERROR; else sed -n "s/^$1 //p" "$list"; fi
}

# run LOG FOLDER PROOF PARAMETERS SAT: one call of Yosys; modules may lie changed in FOLDER. Prints "proved", "refuted" or
# what went wrong.
run() {
  local log=$1 folder=$2 top=${top_of[$3]} modules=${modules_of[$3]} sources=() chparam="" token name
  : > "$log"
  for token in $4; do
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
    name=${token%%+*}
    [ -e "$folder/$name.sv" ] || cp "$(source_of "$name")" "$folder/$name.sv" || { echo "no $name"; return; }
    if [ "$name" != "$token" ]; then
      grep -q '^endmodule' "$folder/$name.sv" || { echo "no end of $name"; return; }
      sed -i "/^endmodule/i \`include \"${token#*+}.svh\"" "$folder/$name.sv"
    fi
    sources+=("$folder/$name.sv")
  done
  timeout 600 yosys -ql "$log" -p "read_verilog -sv -formal -DSYNTHESIS -I$here ${sources[*]} $here/proof_*.sv
    hierarchy -check -top $top$chparam; proc; flatten; opt_clean; check -assert
    select -assert-none t:\$*latch*; memory -nomap; memory_map; async2sync; opt_clean
    select -assert-min 1 t:\$assert; sat -prove-asserts -set-assumes $5" > /dev/null 2>&1
  local status=$?
  if name=$(grep -iE 'warning|implicitly|unsupported|ignoring' "$log" | grep -vEm1 '^Warnings: |Replacing memory .* with list of registers'); then echo "misread: $name"
  elif grep -q 'Induction step proven: SUCCESS!' "$log" && [ $status -eq 0 ]; then echo proved
  elif grep -q 'model found for base case: FAIL!' "$log"; then echo refuted
  elif grep -q 'proof failed\|did fail' "$log"; then echo "not proved: a step breaks it, or no trace from reset does"
  elif grep -q 'proved base case' "$log"; then echo "not refuted: no trace of so many steps breaks it"
  else echo "$(tail -n 1 "$log") ($status)"; fi
}

report() {  # NAME VERDICT WHAT FROM: the seconds are those that the processor spent in Yosys since line FROM of the log
  awk -v name="$1" -v verdict="$2" -v what="${3//\\/}" -v from="$4" \
    'NR > from && /CPU: user/ {sum += $(NF - 6) + $(NF - 4)} END {printf "%-28s %-8s %6.1f s  %s\n", name, verdict, sum, what}' "$log"
}

# The two words of the table.
proof() {  # NAME TOP MODULES PARAMETERS [STEPS]
  local name=$1 parameters=$4 sets set verdict folder log=$out/$1.log
  top_of[$1]=$2 modules_of[$1]=$3
  [[ $wanted = "  " || $wanted = *" $name "* ]] || return 0
  : > "$log"
  if [ "$parameters" = machine ]; then mapfile -t sets < <(instances "$2"); else IFS=';' read -ra sets <<< "$parameters"; fi
  [ ${#sets[@]} -gt 0 ] || sets=("no instances")
  proofs=$((proofs + 1))
  for set in "${sets[@]}"; do
    folder=$(mktemp -d)
    verdict=$(run "$folder/log" "$folder" "$name" "$set" "-tempinduct -initsteps ${5:-1} -maxsteps $((${5:-1} + 1)) -verify")
    { echo "== $name, $set: $verdict"; cat "$folder/log"; } >> "$log"
    rm -rf "$folder"
    if [ "$verdict" != proved ]; then report "$name" FAILED "$set: $verdict" 0; failed=$((failed + 1)); return; fi
  done
  report "$name" proved "${#sets[@]} sets of parameters" 0
}

mutant() {  # NAME MODULE CHANGE PARAMETERS STEPS WHAT
  local name=$1 source verdict folder log=$out/$1.log from
  [[ $wanted = "  " || $wanted = *" $name "* ]] || return 0
  mutants=$((mutants + 1)) from=$(wc -l < "$log")
  folder=$(mktemp -d) source=$(source_of "$2")
  sed -E "$3" "$source" > "$folder/$2.sv"
  if cmp -s "$folder/$2.sv" "$source"; then verdict="the change did not apply"
  else verdict=$(run "$folder/log" "$folder" "$name" "$4" "-tempinduct -tempinduct-baseonly -show-public -maxsteps $5"); fi
  { echo "== $name, changed: $6: $verdict"; cat "$folder/log"; } >> "$log" 2>/dev/null
  rm -rf "$folder"
  if [ "$verdict" = refuted ]; then report "  $name, changed" refuted "$6" "$from"
  else report "  $name, changed" FAILED "$6: $verdict" "$from"; failed=$((failed + 1)); fi
}

wanted=" $* " proofs=0 mutants=0
declare -A top_of modules_of
. "$here/table.sh"
[ $proofs -gt 0 ] || { echo "no such proof: $*"; exit 1; }
echo "$proofs proofs, $mutants changed copies, $failed failed"
[ $failed -eq 0 ]
