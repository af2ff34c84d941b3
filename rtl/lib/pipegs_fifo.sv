// SPDX-License-Identifier: Apache-2.0
// pipegs_fifo: a queue of registers whose first word falls through.
//
// Idea    A ring of Depth words with a read and a write pointer and a count; the head is always visible.
// Stream  in: one word per beat, refused only when full. out: the same words in order.
// Pace    One beat per cycle in and out; a word put in is seen at the output in the next cycle.
// Model   std::queue.

module pipegs_fifo #(
  parameter int unsigned DataW = 32,
  parameter int unsigned Depth = 4,
  localparam int unsigned CountW = $clog2(Depth + 1),
  localparam int unsigned PtrW = Depth > 1 ? $clog2(Depth) : 1
) (
  input  logic              clk_i,
  input  logic              rst_ni,

  input  logic              in_valid_i,
  output logic              in_ready_o,
  input  logic [DataW-1:0]  in_i,

  output logic              out_valid_o,
  input  logic              out_ready_i,
  output logic [DataW-1:0]  out_o,

  output logic [CountW-1:0] count_o  // words held now
);

  logic [DataW-1:0]  words_q [Depth];
  logic [PtrW-1:0]   head_q, tail_q;
  logic [CountW-1:0] count_q;
  logic              push, pop;

  assign in_ready_o  = count_q != CountW'(Depth);
  assign out_valid_o = count_q != '0;
  assign out_o       = words_q[head_q];
  assign count_o     = count_q;
  assign push        = in_valid_i && in_ready_o;
  assign pop         = out_valid_o && out_ready_i;

  always_ff @(posedge clk_i) begin
    if (push) words_q[tail_q] <= in_i;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      head_q  <= '0;
      tail_q  <= '0;
      count_q <= '0;
    end else begin
      if (push) tail_q <= tail_q == PtrW'(Depth - 1) ? '0 : tail_q + 1'b1;
      if (pop) head_q <= head_q == PtrW'(Depth - 1) ? '0 : head_q + 1'b1;
      if (push && !pop) count_q <= count_q + 1'b1;
      if (pop && !push) count_q <= count_q - 1'b1;
    end
  end

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits(out_o)), .Proven(1)) u_check_out (
    .clk_i,
    .rst_ni,
    .valid_i(out_valid_o),
    .ready_i(out_ready_i),
    .beat_i(out_o)
  );
`endif

endmodule
