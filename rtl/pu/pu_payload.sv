// SPDX-License-Identifier: Apache-2.0
// pu_payload: the payloads of the Gaussians that walk in pu_intersect, and of the one that it shows.
//
// Idea    Gaussians come out of the queue of payloads in order, but one without a box may leave it and die while those
//         before it still walk. So whoever begins to walk takes its payload along, into a ring of as many words as walk
//         at one time, and only these are kept until they leave, in order. So few words are flip-flops, no SRAM.
// Stream  walk_i: a Gaussian begins its walk, payload_i is its payload. leave_i: the oldest leaves; payload_o is its
//         payload from the next cycle to the next leave_i.
// Pace    One of each per cycle.
// Model   The payload stands beside the record in cpp_model/golden.cpp.

module pu_payload #(
  parameter int unsigned DataW  = 32,
  parameter int unsigned Places = 2  // Gaussians between walk_i and leave_i
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             walk_i,
  input  logic [DataW-1:0] payload_i,

  input  logic             leave_i,
  output logic [DataW-1:0] payload_o
);

  localparam int unsigned PtrW = Places > 1 ? $clog2(Places) : 1;
  localparam logic [PtrW-1:0] Last = PtrW'(Places - 1);

  logic [DataW-1:0] words_q [Places];
  logic [PtrW-1:0]  tail_q, head_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      tail_q <= '0;
      head_q <= '0;
    end else begin
      if (walk_i) tail_q <= tail_q == Last ? '0 : tail_q + 1'b1;
      if (leave_i) head_q <= head_q == Last ? '0 : head_q + 1'b1;
    end
  end

  always_ff @(posedge clk_i) begin
    if (walk_i) words_q[tail_q] <= payload_i;
    if (leave_i) payload_o <= words_q[head_q];
  end

`ifndef SYNTHESIS
  int unsigned count_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) count_q <= 0;
    else count_q <= count_q + 32'(walk_i) - 32'(leave_i);
  end
  always_ff @(posedge clk_i) if (rst_ni) assert (!walk_i || count_q < Places || leave_i)
    else $error("more Gaussians walk than there are places for their payloads");
  always_ff @(posedge clk_i) if (rst_ni) assert (!leave_i || count_q != 0)
    else $error("a Gaussian leaves that never walked");
`endif

endmodule
