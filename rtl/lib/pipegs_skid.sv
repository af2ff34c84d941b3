// SPDX-License-Identifier: Apache-2.0
// pipegs_skid: a register stage for a stream that cuts both the valid and the ready path.
//
// Idea    The ready it gives is a register, so one beat may still arrive after the output stalls; a second register
//         catches it ("skids") and is emptied first.
// Stream  in: one beat. out: the same beat one cycle later.
// Pace    One beat per cycle, latency one cycle, whatever the pattern of ready.
// Model   std::queue of two.

module pipegs_skid #(
  parameter int unsigned DataW = 32
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             in_valid_i,
  output logic             in_ready_o,
  input  logic [DataW-1:0] in_i,

  output logic             out_valid_o,
  input  logic             out_ready_i,
  output logic [DataW-1:0] out_o
);

  logic             out_valid_q, spare_valid_q;
  logic [DataW-1:0] out_q, spare_q;
  logic             out_free;

  assign in_ready_o  = !spare_valid_q;
  assign out_valid_o = out_valid_q;
  assign out_o       = out_q;
  assign out_free    = !out_valid_q || out_ready_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      out_valid_q   <= 1'b0;
      spare_valid_q <= 1'b0;
    end else begin
      if (out_free) out_valid_q <= spare_valid_q || in_valid_i;
      spare_valid_q <= !out_free && (spare_valid_q || in_valid_i);
    end
  end

  always_ff @(posedge clk_i) begin
    if (out_free && (spare_valid_q || in_valid_i)) out_q <= spare_valid_q ? spare_q : in_i;
    if (in_ready_o && in_valid_i) spare_q <= in_i;
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
