#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""declared_test.py: synth/declared.py finds each kind of name used too early, and nothing in a file in order."""
import subprocess
import sys
import tempfile
from pathlib import Path

CHECK = Path(__file__).parents[2] / "synth/declared.py"
PLANTED = {  # body of a module: the name that is used in its first line and declared in its last
    "assign y = early;\nlogic early;": "early",
    "always_comb begin\n  if (late_q[2]) x = a;\nend\nlogic [3:0] other, late_q [4];": "late_q",
    "logic [Wide-1:0] x;\nlocalparam int unsigned Wide = 3;": "Wide",
    "assign y = twice(a);\nfunction automatic logic [3:0] twice(input a);\n  twice = a;\nendfunction": "twice",
    "word_t x;\ntypedef logic [3:0] word_t;": "word_t",
    "assign y = state == Last;\ntypedef enum logic [1:0] {First, Last} state_e;": "Last",
    "for (i = 0; i < 2; i += 1) begin : gen_one\nend\ngenvar i;": "i",
    "sub u_sub (.clk_i, .early);\nlogic early;": "early",
    "pair_t p;\ntypedef struct packed {\n  logic a;\n} pair_t;": "pair_t",
    "if (1) begin : gen_a\n  logic inner;\nend\nassign y = inner;\nlogic inner;": "inner",
}
GOOD = """package some_pkg;
  localparam int unsigned W = 3;
endpackage
module good #(
  parameter int unsigned N = 2,
  localparam int unsigned ListW = $clog2(N)
) (
  input  logic             clk_i,
  input  some_pkg::word_t  word_i,   // later: not this one
  output logic [ListW-1:0] word_o
);
  typedef enum logic [1:0] {Idle, Busy} state_e;
  typedef struct packed {logic later; logic [2:0] first;} pair_t;
  state_e state_q;
  pair_t  pair;
  logic [some_pkg::later-1:0] taken;
  sub u_sub (.clk_i, .later(pair.later), .state_i(state_q == Busy));
  for (genvar g = 0; g < 2; g += 1) begin : later_gen
    logic one;
    assign one = g == 0;
  end
  function automatic logic [3:0] same(input logic [3:0] v);
    logic one;
    one = v[0];
    same = {v[3:1], one};
  endfunction
  logic later, one;
  assign later = one, one = pair.first[0] && same(4'd1) == "later";
endmodule
"""


def finds(folder, text):
    path = folder / "planted.sv"
    path.write_text(text)
    done = subprocess.run([CHECK, path], capture_output=True, text=True, check=False)
    lines = done.stdout.splitlines()
    if done.returncode != (1 if lines else 0):
        sys.exit(f"exit code {done.returncode} with {len(lines)} finds: {done.stderr}")
    return [line.removeprefix(f"{path}:") for line in lines]


def main():
    wrong = []
    with tempfile.TemporaryDirectory() as name:
        for body, early in PLANTED.items():
            found = finds(Path(name), f"module planted;\n{body}\nendmodule\n")
            if len(found) != 1 or f": {early} is used before its declaration in line " not in found[0]:
                wrong.append(f"planted {early}, found: {found}")
        if found := finds(Path(name), GOOD):
            wrong.append(f"found where all is in order: {found}")
    print(*wrong, f"{len(PLANTED)} planted", sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
