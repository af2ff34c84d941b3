// SPDX-License-Identifier: Apache-2.0
// pipegs_slot_pool: the free slots of a store: it hands each out once and takes it back.
//
// Idea    Slots that were never used are handed out by counting; those that came back wait in a queue. How many are in
//         use is counted too: a slot that came back two cycles ago may not be at the queue's head yet, but it is free.
//         renew_i makes them count from 0 again: the queue is emptied, a slot a cycle.
// Stream  slot: a free slot. free_i: a slot comes back. renew_i: while none is in use, until the queue is empty.
// Pace    One slot per cycle out and in.
// Model   A set of the slots in use, in its proof.

module pipegs_slot_pool #(
  parameter int unsigned Slots = 16,  // at least 2
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

  output logic [SlotW:0]   used_o,   // slots in use
  output logic             active_o
);

  logic [SlotW:0]             fresh_q;  // slots handed out for the first time
  logic [SlotW:0]             used_q, more, fewer;
  logic [SlotW-1:0]           back;
  logic                       fresh, back_valid, take, unused_ready;
  logic [$clog2(Slots+1)-1:0] waiting;

  assign fresh        = fresh_q != (SlotW+1)'(Slots);
  assign slot_valid_o = fresh || back_valid;
  assign slot_o       = fresh ? fresh_q[SlotW-1:0] : back;
  assign take         = slot_valid_o && slot_ready_i;
  assign used_o       = used_q;
  assign more         = used_q + 1'b1;  // take and free_i come late
  assign fewer        = used_q - 1'b1;
  assign active_o     = take || free_i || (waiting != '0 && !back_valid);

  pipegs_sram_fifo #(.DataW(SlotW), .Depth(Slots)) u_back (
    .clk_i,
    .rst_ni,
    .in_valid_i(free_i),
    .in_ready_o(unused_ready),
    .in_i(free_slot_i),
    .out_valid_o(back_valid),
    .out_ready_i(renew_i || (slot_ready_i && !fresh)),
    .out_o(back),
    .count_o(waiting)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      fresh_q <= '0;
      used_q  <= '0;
    end else begin
      if (renew_i) fresh_q <= '0;
      else if (take && fresh) fresh_q <= fresh_q + 1'b1;
      if (take != free_i) used_q <= take ? more : fewer;
    end
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!free_i || (unused_ready && used_q != '0));
  logic renew_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) renew_q <= 1'b0;
    else renew_q <= renew_i;
  end
  always_ff @(posedge clk_i) if (rst_ni) assert (!renew_i || (used_q == '0 && !take));
  always_ff @(posedge clk_i) if (rst_ni) assert (!renew_q || renew_i || waiting == '0);
  pipegs_stream_check #(.DataW($bits(slot_o)), .Proven(1)) u_check_slot (
    .clk_i,
    .rst_ni(rst_ni && !renew_i),
    .valid_i(slot_valid_o),
    .ready_i(slot_ready_i),
    .beat_i(slot_o)
  );
`endif

endmodule
