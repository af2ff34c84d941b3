// su_slots: the free slots of an SU's pool.
//
// Idea    Slots that were never used are handed out by counting; those that came back wait in a queue. How many are in use
//         is counted too: a slot that came back two cycles ago may not be at the queue's head yet, but it is free.
// Stream  slot: a free slot. free_i: a slot comes back.
// Pace    One slot per cycle out and in.
// Model   Plumbing; the whole SU is tested against cpp_model/su/su.hpp.

module su_slots (
  input  logic                           clk_i,
  input  logic                           rst_ni,

  output logic                           slot_valid_o,
  input  logic                           slot_ready_i,
  output logic [pipegs_pkg::RecordW-1:0] slot_o,

  input  logic                           free_i,
  input  logic [pipegs_pkg::RecordW-1:0] free_slot_i,

  output logic                           full_o,   // all slots are in use
  output logic                           empty_o,  // none is
  output logic                           active_o
);

  localparam int unsigned SlotW = pipegs_pkg::RecordW;
  localparam int unsigned Records = pipegs_pkg::Records;

  logic [SlotW:0]   fresh_q;  // slots handed out for the first time
  logic [SlotW:0]   used_q;
  logic [SlotW-1:0] back;
  logic             fresh, back_valid, take, unused_ready;
  logic [$clog2(Records+1)-1:0] waiting;

  assign fresh        = fresh_q != (SlotW+1)'(Records);
  assign slot_valid_o = fresh || back_valid;
  assign slot_o       = fresh ? fresh_q[SlotW-1:0] : back;
  assign take         = slot_valid_o && slot_ready_i;
  assign full_o       = used_q == (SlotW+1)'(Records);
  assign empty_o      = used_q == '0;
  assign active_o     = take || free_i || (waiting != '0 && !back_valid);

  sram_fifo #(.DataW(SlotW), .Depth(Records)) u_back (
    .clk_i, .rst_ni, .in_valid_i(free_i), .in_ready_o(unused_ready), .in_i(free_slot_i),
    .out_valid_o(back_valid), .out_ready_i(slot_ready_i && !fresh), .out_o(back), .count_o(waiting)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      fresh_q <= '0;
      used_q  <= '0;
    end else begin
      if (take && fresh) fresh_q <= fresh_q + 1'b1;
      if (take && !free_i) used_q <= used_q + 1'b1;
      if (free_i && !take) used_q <= used_q - 1'b1;
    end
  end

`ifndef SYNTHESIS
  assert property (@(posedge clk_i) disable iff (!rst_ni) free_i |-> unused_ready && !empty_o);
`endif

endmodule
