// SPDX-License-Identifier: Apache-2.0
// free_queue: stands for rtl/buf/pipegs_sram_fifo.sv in proofs of its users that need to know a word and its place.
//
// Idea    Of the real one the proof `sram_fifo` says: as many words inside as came and did not leave, at most Depth;
//         ready exactly while there is room; a word leaves behind exactly those that were ahead of it, unchanged; what
//         is shown stays until taken. One word of the solver's choice is remembered, with the words ahead of it; its
//         user sees it by (* hierconn *) wires. Other words show as anything.

module pipegs_sram_fifo #(
  parameter int unsigned DataW = 8,
  parameter int unsigned Depth = 4,
  localparam int unsigned CountW = $clog2(Depth + 1)
) (
  input  logic              clk_i,
  input  logic              rst_ni,

  input  logic              in_valid_i,
  output logic              in_ready_o,
  input  logic [DataW-1:0]  in_i,

  output logic              out_valid_o,
  input  logic              out_ready_i,
  output logic [DataW-1:0]  out_o,

  output logic [CountW-1:0] count_o
);

  (* anyseq *) logic             valid, pick;
  (* anyseq *) logic [DataW-1:0] any;
  logic [CountW-1:0] held_q, ahead_q;  // words inside; of these, ahead of the remembered one
  logic [DataW-1:0]  word_q;
  logic              tracked_q, push, pop, picks, heads;

  assign in_ready_o  = held_q != CountW'(Depth);
  assign out_valid_o = valid;
  assign out_o       = any;
  assign count_o     = held_q;
  assign push        = in_valid_i && in_ready_o;
  assign pop         = out_valid_o && out_ready_i;
  assign picks       = push && pick && !tracked_q;
  assign heads       = tracked_q && ahead_q == '0;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      held_q    <= '0;
      tracked_q <= 1'b0;
    end else begin
      held_q <= held_q + CountW'(push) - CountW'(pop);
      if (picks) tracked_q <= 1'b1;
      else if (pop && heads) tracked_q <= 1'b0;
    end
  end
  always_ff @(posedge clk_i) begin
    if (!tracked_q) ahead_q <= held_q - CountW'(pop);
    else if (pop) ahead_q <= ahead_q - 1'b1;
    if (!tracked_q) word_q <= in_i;
  end

  always_comb begin
    assume (!rst_ni || !valid || held_q != '0);
    assume (!rst_ni || !valid || !heads || any == word_q);
    if (rst_ni) assert (held_q <= CountW'(Depth) && (!tracked_q || ahead_q < held_q));
  end
  proof_hold #(.DataW(DataW), .Assumed(1'b1)) u_hold (
    .clk_i, .rst_ni, .valid_i(out_valid_o), .ready_i(out_ready_i), .beat_i(out_o)
  );

endmodule
