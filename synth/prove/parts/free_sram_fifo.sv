// SPDX-License-Identifier: Apache-2.0
// free_sram_fifo: stands for rtl/buf/pipegs_sram_fifo.sv in proofs of its users: any words that a queue may show.
//
// Idea    Of the real one the proof `sram_fifo` says: as many words inside as came and did not leave, at most Depth;
//         ready exactly while there is room; what is shown came before and stays until taken. Of the words inside only
//         those are counted that have one value, of the solver's choice; their order is left out.

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

  (* anyseq *)   logic             valid;
  (* anyseq *)   logic [DataW-1:0] any;
  (* anyconst *) logic [DataW-1:0] value;
  logic [CountW-1:0] held_q, watched_q;  // words inside; of these, with this value
  logic              push, pop;

  assign in_ready_o  = held_q != CountW'(Depth);
  assign out_valid_o = valid;
  assign out_o       = any;
  assign count_o     = held_q;
  assign push        = in_valid_i && in_ready_o;
  assign pop         = out_valid_o && out_ready_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      held_q    <= '0;
      watched_q <= '0;
    end else begin
      held_q    <= held_q + CountW'(push) - CountW'(pop);
      watched_q <= watched_q + CountW'(push && in_i == value) - CountW'(pop && out_o == value);
    end
  end

  always_comb begin
    assume (!rst_ni || !valid || held_q != '0);
    assume (!rst_ni || !valid || (any == value ? watched_q != '0 : watched_q != held_q));
    if (rst_ni) assert (held_q <= CountW'(Depth) && watched_q <= held_q);
  end
  proof_hold #(.DataW(DataW), .Assumed(1'b1)) u_hold (
    .clk_i, .rst_ni, .valid_i(out_valid_o), .ready_i(out_ready_i), .beat_i(out_o)
  );

endmodule
