// SPDX-License-Identifier: Apache-2.0
// pu_hold: keeps a covariance for a cycle, so that no path goes from pu_covariance to the stage behind.
//
// Idea    One register at the input, one at the output. A record is handed on unchanged.
// Stream  covariance in and out, in order; an end beat passes.
// Pace    One record a cycle, latency 2; its neighbours need eight.
// Model   none: it changes no record. Test: pu_shape

module pu_hold (
  input  logic                     clk_i,
  input  logic                     rst_ni,

  input  logic                     covariance_valid_i,
  output logic                     covariance_ready_o,
  input  pipegs_pkg::covariance_t  covariance_i,

  output logic                     held_valid_o,
  input  logic                     held_ready_i,
  output pipegs_pkg::covariance_t  held_o,

  output logic                     busy_o
);

  pipegs_pkg::covariance_t in_q, out_q;
  logic                    in_valid_q, out_valid_q, move;

  assign move               = in_valid_q && (!out_valid_q || held_ready_i);
  assign covariance_ready_o = !in_valid_q || move;
  assign held_valid_o       = out_valid_q;
  assign held_o             = out_q;
  assign busy_o             = in_valid_q || out_valid_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      in_valid_q  <= 1'b0;
      out_valid_q <= 1'b0;
    end else begin
      if (covariance_ready_o) in_valid_q <= covariance_valid_i;
      if (move) out_valid_q <= 1'b1;
      else if (held_ready_i) out_valid_q <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (covariance_valid_i && covariance_ready_o) in_q <= covariance_i;
    if (move) out_q <= in_q;
  end

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits(held_o))) u_check_held (
    .clk_i,
    .rst_ni,
    .valid_i(held_valid_o),
    .ready_i(held_ready_i),
    .beat_i(held_o)
  );
`endif

endmodule
