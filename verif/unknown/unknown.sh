#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# unknown.sh: one window on the machine as plain Verilog, in four states from power-up:
#   unknown.sh [key=value ...]
#
# Idea    Yosys writes pipegs_top of these settings as plain Verilog with operators on words, memories as instances of
#         pipegs_sram, everything else flat. An enable becomes a multiplexer and a small array registers, so that an X
#         spreads where Verilog's `if` and its write to an unknown address would hide it. Icarus runs it in
#         unknown_bench.v, on what $BUILD/verif/unknown/unknown_stimulus writes. Comparisons become bits
#         (compare_unknown.v): Verilog's own are X where gates are not.
# Watched By name every valid, the ready of each valid while that is 1, every enable of a clock; every register that has
#         a reset; the memories' ports (sram_unknown.v). Not the taps, which are not built.
# Finds   In a second run the valid of a line reader forgets whether there is a job at all: an X must show in a valid.
# Output  A line for the first run, what the second one finds; exits 1 when an X shows or a pixel differs in the first
#         one or no X in the second, 77 (skipped) when Icarus is not installed.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=$(realpath "${BUILD:-build}") here=$PWD/verif/unknown
command -v iverilog > /dev/null || { echo "skipped: iverilog is not installed (apt-get install iverilog)"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$build/cpp_model/package_sv" taps=0 "$@" > "$work/pipegs_pkg.sv"
"$build/verif/unknown/unknown_stimulus" "$work" taps=0 "$@"
mapfile -t files < <(find rtl -name '*.sv' ! -name pipegs_pkg.sv ! -name pipegs_sram.sv | sort)
passes="proc -noopt; check -assert; flatten; opt_clean; memory -nomap; memory_map; pmuxtree; dffunmap -ce-only
  chtype -set \$eq t:\$eqx; techmap -map $here/compare_unknown.v; opt_clean"
yosys -q -p "read_verilog -sv -lib rtl/lib/pipegs_sram.sv
  read_verilog -sv -defer -DSYNTHESIS $work/pipegs_pkg.sv ${files[*]}
  hierarchy -check -top pipegs_top; $passes; write_verilog -noattr $work/top.v
  design -reset; read_verilog -sv rtl/lib/pipegs_reset_sync.sv; $passes; write_verilog -noattr $work/reset.v" \
  > "$work/log" 2>&1 || { tail -n 5 "$work/log"; exit 1; }

# shellcheck disable=SC2016 # Verilog's own $signed
# Zeros stay zeros wherever they are moved.
sed -i -E 's/^(  assign .*) = (\$signed\(.*\) < 0 \? (.*) << - .*);$/\1 = |(\3) ? (\2) : 0;/' "$work/top.v"
# The fault of the second run; without +forgets it is not there.
sed -i -E 's/(valid(_o)? +=) ([^ ]*u_reader\.job_valid ) && /\1 (unknown_bench.forgets || \3) \&\& /' "$work/top.v"
grep -q 'unknown_bench\.forgets' "$work/top.v" || { echo "no valid of a line reader is found"; exit 1; }

# Lines NAME EXPRESSION, of a flat module: valids; readies, each while its valid is 1 (without a beat it may look at
# data that is not there); enables; then what an `always` resets.
{ sed -nE 's/^  (wire|reg) (\[[0-9:]+\] )?(\\?[^ ;]+) ?;$/\3/p' "$work/top.v" |
  grep -vE 'tap_|^.u_raster\.(alphas|pixels)_valid$' | awk '
    /(\.|_|^\\?)(valid|ready)(_[0-9])?(_[iqod])?$/ {seen[$1] = 1}
    /\.enable_q$/ {print $1, "dut." $1 " "}
    END {for (name in seen) {
      partner = name
      if (!sub(/ready/, "valid", partner)) {print name, "dut." name " "; continue}
      if (!sub(/_o$/, "_i", partner)) sub(/_i$/, "_o", partner)
      if (partner in seen) print name, "(dut." name " & dut." partner " )"
    }}'
  sed -nE 's/^    if \(![^)]*\) (\S+) .*<= .*/\1 dut.\1 /p' "$work/top.v" | tee "$work/reset"
} | sort -u > "$work/names"
count=$(wc -l < "$work/names")
[ "$count" -gt 100 ] || { echo "only $count signals to watch"; exit 1; }
awk -v count="$count" '
  {at = index($0, " "); name = substr($0, 1, at - 1); value[NR] = substr($0, at + 1)
   gsub(/\\/, "", name); checks = checks "    known(\"" name "\", ^" value[NR] ");\n"}
  END {
    print "  localparam integer Watched = " count ";\n  task watch; if (^{"
    for (i = 1; i <= NR; i++) print "    " value[i] (i < NR ? "," : "")
    print "  } === 1\047bx) begin\n" checks "  end endtask"
  }' "$work/names" > "$work/watched.vh"

# All that has a reset, in one word.
sort -u "$work/reset" | awk '
  {value[NR] = substr($0, index($0, " ") + 1)}
  END {
    print "  task take_reset_state; reset_state = {"
    for (i = 1; i <= NR; i++) print "    " value[i] (i < NR ? "," : "")
    print "  }; endtask"
  }' >> "$work/watched.vh"

cd "$work"
iverilog -g2012 -s unknown_bench -o bench.vvp "$here/unknown_bench.v" "$here/sram_unknown.v" top.v reset.v
vvp -n bench.vvp | tee out
grep -q 'no X$' out
if grep -q FAILED out; then exit 1; fi
echo "with a valid that forgets whether there is a job:"
vvp -n bench.vvp +forgets | tee out
grep -q 'X in .*valid' out && grep -qE '^FAILED: [0-9]+ faults' out
