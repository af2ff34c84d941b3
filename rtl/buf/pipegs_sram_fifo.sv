// SPDX-License-Identifier: Apache-2.0
// pipegs_sram_fifo: a queue of many wide words, in an SRAM.
//
// Idea    A ring in a memory with one read and one write port. The memory's own output register is the head: it is
//         fetched as soon as the register is free, so the queue still moves a word in every cycle.
// Stream  in: one word per beat, refused only when Depth words are held. out: the same words in order.
// Pace    One beat per cycle in and out; a word put in is seen at the output two cycles later.
// Model   std::queue.

module pipegs_sram_fifo #(
  parameter int unsigned DataW = 32,
  parameter int unsigned Depth = 16,
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

  output logic [CountW-1:0] count_o  // words held now, the head included
);

  logic [PtrW-1:0]   head_q, tail_q;
  logic [CountW-1:0] stored_q;      // words in the memory that were not fetched yet
  logic              out_valid_q;   // the memory's output register holds the head
  logic [CountW-1:0] more, fewer;   // push and fetch come late in the cycle
  logic              push, fetch;

  assign count_o     = stored_q + CountW'(out_valid_q);
  assign in_ready_o  = count_o != CountW'(Depth);
  assign out_valid_o = out_valid_q;
  assign push        = in_valid_i && in_ready_o;
  assign more        = stored_q + 1'b1;
  assign fewer       = stored_q - 1'b1;
  assign fetch       = stored_q != '0 && (!out_valid_q || out_ready_i);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      head_q      <= '0;
      tail_q      <= '0;
      stored_q    <= '0;
      out_valid_q <= 1'b0;
    end else begin
      if (push) tail_q <= tail_q == PtrW'(Depth - 1) ? '0 : tail_q + 1'b1;
      if (fetch) head_q <= head_q == PtrW'(Depth - 1) ? '0 : head_q + 1'b1;
      if (push != fetch) stored_q <= push ? more : fewer;
      if (fetch) out_valid_q <= 1'b1;
      else if (out_ready_i) out_valid_q <= 1'b0;
    end
  end

  pipegs_sram #(.DataW(DataW), .Depth(Depth)) u_words (
    .clk_i,
    .write_i(push),
    .waddr_i(tail_q),
    .wdata_i(in_i),
    .read_i (fetch),
    .raddr_i(head_q),
    .rdata_o(out_o)
  );

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
