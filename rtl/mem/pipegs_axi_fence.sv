// SPDX-License-Identifier: Apache-2.0
// pipegs_axi_fence: holds reads back until the writes that came before them are in memory.
//
// Idea    AXI orders no read behind a write: a read may be asked for only when every write that the core gave before it
//         has been answered. A read that must see writes waits in a queue with a stamp, the number of writes accepted
//         before it. All writes have one ID, so their answers come in order, and the oldest read is due when at least
//         as many writes were accepted since its stamp as are unanswered now: those unanswered are then all younger.
//         Stamps wrap. A read that was not at the head for 2^StampW writes may look as if it were not due; it is due
//         a few writes later, or when no write is unanswered, and it never goes too early.
// Stream  in: a read and whether it must see earlier writes. out: the same, of those that must in their order. Others
//         pass those that wait. Writes are accepted at the same port of the core, so never in the cycle of a read.
// Pace    One read per cycle. A read that need not wait passes in the same cycle; one that waited leaves two cycles
//         after it came, or one cycle after the last answer that it waited for.
// Model   The test compares every line that is read with an array to which writes go when they are accepted.

module pipegs_axi_fence #(
  parameter int unsigned DataW  = 47,
  parameter int unsigned Fenced = 64,  // reads that may wait
  parameter int unsigned Writes = 64,  // writes that may be unanswered
  localparam int unsigned WritesW = $clog2(Writes + 1)
) (
  input  logic               clk_i,
  input  logic               rst_ni,

  input  logic               in_valid_i,
  output logic               in_ready_o,
  input  logic               in_fenced_i,  // must see earlier writes
  input  logic [DataW-1:0]   in_i,

  input  logic               write_i,      // a write is accepted in this cycle
  input  logic [WritesW-1:0] writes_i,     // accepted before it and not answered

  output logic               out_valid_o,
  input  logic               out_ready_i,
  output logic [DataW-1:0]   out_o
);

  localparam int unsigned StampW = WritesW + 2;

  logic [StampW-1:0]           stamp_q;  // writes accepted until now
  logic [StampW-1:0]           head_stamp, since;
  logic [DataW-1:0]            head;
  logic                        head_valid, queue_ready, passes, due;
  logic                        passing_q, leaving_q;  // shown and not taken, so it stays: a read that passes, the head
  logic [$clog2(Fenced+1)-1:0] waiting;

  assign passes      = !in_fenced_i || (waiting == '0 && writes_i == '0);
  assign since       = stamp_q - head_stamp;
  assign due         = head_valid && (leaving_q || since >= StampW'(writes_i)) && !passing_q;
  assign out_valid_o = due || (in_valid_i && passes);
  assign out_o       = due ? head : in_i;
  assign in_ready_o  = passes ? out_ready_i && !due : queue_ready;

  pipegs_sram_fifo #(.DataW(StampW + DataW), .Depth(Fenced)) u_waiting (
    .clk_i,
    .rst_ni,
    .in_valid_i(in_valid_i && !passes),
    .in_ready_o(queue_ready),
    .in_i({stamp_q, in_i}),
    .out_valid_o(head_valid),
    .out_ready_i(out_ready_i && due),
    .out_o({head_stamp, head}),
    .count_o(waiting)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      stamp_q   <= '0;
      passing_q <= 1'b0;
      leaving_q <= 1'b0;
    end else begin
      if (write_i) stamp_q <= stamp_q + 1'b1;
      passing_q <= out_valid_o && !out_ready_i && !due;
      leaving_q <= due && !out_ready_i;
    end
  end

`ifndef SYNTHESIS
  // A read that passes is taken back when the core is reset.
  pipegs_stream_check #(.DataW($bits(out_o))) u_check_out (
    .clk_i,
    .rst_ni(rst_ni && (in_valid_i || !passing_q)),
    .valid_i(out_valid_o),
    .ready_i(out_ready_i),
    .beat_i(out_o)
  );
`endif

endmodule
