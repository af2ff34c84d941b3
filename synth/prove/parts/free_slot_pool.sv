// SPDX-License-Identifier: Apache-2.0
// free_slot_pool: stands for rtl/buf/pipegs_slot_pool.sv in proofs of its users: any slot that is not in use.
//
// Idea    What the proof `slot_pool` says of the real one: a slot in use is not handed out, and what is shown stays
//         until it is taken. What that proof assumes is proven here: only a slot in use comes back.

module pipegs_slot_pool #(
  parameter int unsigned Slots = 16,
  localparam int unsigned SlotW = $clog2(Slots)
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             renew_i,

  output logic             slot_valid_o,
  input  logic             slot_ready_i,
  output logic [SlotW-1:0] slot_o,

  input  logic             free_i,
  input  logic [SlotW-1:0] free_slot_i,

  output logic [SlotW:0]   used_o,
  output logic             active_o
);

  (* anyseq *) logic             valid, active;
  (* anyseq *) logic [SlotW-1:0] slot;
  logic [Slots-1:0] in_use_q, taken, returned;

  assign slot_valid_o = valid;
  assign slot_o       = slot;
  assign active_o     = active;
  assign used_o       = (SlotW+1)'($countones(in_use_q));
  assign taken        = valid && slot_ready_i ? Slots'(1) << slot : '0;
  assign returned     = free_i ? Slots'(1) << free_slot_i : '0;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) in_use_q <= '0;
    else in_use_q <= (in_use_q | taken) & ~returned;
  end

  always_comb begin
    assume ((SlotW+1)'(slot) < (SlotW+1)'(Slots));
    assume (!rst_ni || !valid || !in_use_q[slot]);
    if (rst_ni) assert (!free_i || in_use_q[free_slot_i]);
    if (rst_ni) assert (!renew_i);  // no user does
  end
  proof_hold #(.DataW(SlotW), .Assumed(1'b1)) u_hold (
    .clk_i, .rst_ni, .valid_i(slot_valid_o), .ready_i(slot_ready_i), .beat_i(slot_o)
  );

endmodule
