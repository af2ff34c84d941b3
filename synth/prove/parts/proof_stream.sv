// SPDX-License-Identifier: Apache-2.0
// proof_stream: what a queue of beats promises, seen from its two ports.
//
// Idea    A scoreboard of one beat. In a cycle of the solver's choice (pick_i) the beat that goes in is remembered,
//         with the number of beats ahead of it; each beat that leaves takes one off. Since the choice is free, what
//         holds for this beat holds for all. Of its bits one is remembered, chosen likewise: what holds for it holds
//         for all.
// Rule    Never more than Capacity beats inside; none leaves that did not come; the remembered beat leaves behind
//         exactly those that were ahead of it, and unchanged; valid and beat stay until taken.

module proof_stream #(
  parameter int unsigned DataW = 1,
  parameter int unsigned Capacity = 2,
  localparam int unsigned CountW = $clog2(Capacity + 1),
  localparam int unsigned BitW = DataW > 1 ? $clog2(DataW) : 1
) (
  input  logic              clk_i,
  input  logic              rst_ni,

  input  logic              in_valid_i,
  input  logic              in_ready_i,
  input  logic [DataW-1:0]  in_i,
  input  logic              out_valid_i,
  input  logic              out_ready_i,
  input  logic [DataW-1:0]  out_i,

  input  logic              pick_i,
  output logic              tracked_o,  // the remembered beat is inside
  output logic [CountW-1:0] ahead_o,
  output logic [BitW-1:0]   place_o,    // the bit that is remembered
  output logic              bit_o,      // its value
  output logic [CountW-1:0] held_o      // beats inside
);

  logic              tracked_q, bit_q;
  logic [CountW-1:0] ahead_q, held_q;
  logic              take, give;
  (* anyconst *) logic [BitW-1:0] place;

  assign take = in_valid_i && in_ready_i;
  assign give = out_valid_i && out_ready_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      tracked_q <= 1'b0;
      held_q    <= '0;
    end else begin
      held_q <= held_q + CountW'(take) - CountW'(give);
      if (tracked_q && give && ahead_q == '0) tracked_q <= 1'b0;
      if (!tracked_q && take && pick_i) tracked_q <= 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (!tracked_q) ahead_q <= held_q - CountW'(give);
    else if (give) ahead_q <= ahead_q - 1'b1;
    if (!tracked_q) bit_q <= in_i[place];
  end

  assign tracked_o = tracked_q;
  assign ahead_o   = ahead_q;
  assign place_o   = place;
  assign bit_o     = bit_q;
  assign held_o    = held_q;

  always_comb begin
    assume ({1'b0, place} < (BitW+1)'(DataW));
    if (rst_ni) begin
      assert (held_q <= CountW'(Capacity));
      assert (!(take && !give) || held_q < CountW'(Capacity));
      assert (!out_valid_i || held_q != '0);
      assert (!tracked_q || ahead_q < held_q);
      assert (!(tracked_q && out_valid_i && ahead_q == '0) || out_i[place] == bit_q);
    end
  end

  proof_hold #(.DataW(DataW)) u_hold (.clk_i, .rst_ni, .valid_i(out_valid_i), .ready_i(out_ready_i), .beat_i(out_i));

endmodule
