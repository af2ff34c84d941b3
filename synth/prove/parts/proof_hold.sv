// SPDX-License-Identifier: Apache-2.0
// proof_hold: the stream contract at one port: valid, once up, stays up with the same beat until it is taken.
//
// Idea    Remembers what was shown and not taken in the cycle before, of the beat one bit of the solver's choice: what
//         holds for every choice holds for the beat. Assumed = 1 makes it a promise of the surroundings.

module proof_hold #(
  parameter int unsigned DataW = 1,
  parameter bit          Assumed = 1'b0,
  localparam int unsigned BitW = DataW > 1 ? $clog2(DataW) : 1
) (
  input logic             clk_i,
  input logic             rst_ni,
  input logic             valid_i,
  input logic             ready_i,
  input logic [DataW-1:0] beat_i
);

  logic             waits_q;
  logic [DataW-1:0] beat_q;
  logic             kept, same;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) waits_q <= 1'b0;
    else waits_q <= valid_i && !ready_i;
  end
  always_ff @(posedge clk_i) beat_q <= beat_i;

  assign kept = !rst_ni || !waits_q || (valid_i && same);
  if (Assumed) begin : gen_assumed
    assign same = beat_i == beat_q;
    always_comb assume (kept);
  end else begin : gen_proven
    (* anyconst *) logic [BitW-1:0] place;
    assign same = beat_i[place] == beat_q[place];
    always_comb begin
      assume ({1'b0, place} < (BitW+1)'(DataW));
      assert (kept);
    end
  end

endmodule
