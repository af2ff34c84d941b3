// SPDX-License-Identifier: Apache-2.0
// pu_compensate: lowers a Gaussian's opacity by what the dilation adds to its area (scenes trained with antialiasing).
//
// Paper   beyond it: the compensation of the mip variant of 3DGS.
// Idea    opacity' = opacity sqrt(max(2.5e-5, sharp / det)), in logarithms:
//           -log2(opacity) + (log2(det) - log2(sharp)) / 2        at most 7.644 more; sharp = 0 gets the most
//         Only built when Antialias is 1; a frame whose scene is not flagged passes unchanged.
// Stream  covariance in and out, in order; an end beat passes.
// Pace    A record is held for three cycles at least (table, product, sum), latency 4; its neighbours need 8 or 4.
// Model   cpp_model/pu/project/pu_compensate.hpp

module pu_compensate (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic                     antialias_i,  // of the frame, constant while it runs

  input  logic                     covariance_valid_i,
  output logic                     covariance_ready_o,
  input  pipegs_pkg::covariance_t  covariance_i,

  output logic                     compensated_valid_o,
  input  logic                     compensated_ready_i,
  output pipegs_pkg::covariance_t  compensated_o,

  output logic                     busy_o
);

  localparam int unsigned MantissaW = pipegs_pkg::MantissaW;
  localparam int unsigned SharpW    = pipegs_pkg::SharpW;
  localparam int unsigned FloatEW   = pipegs_pkg::FloatEW;
  localparam int unsigned OpacityW  = pipegs_pkg::OpacityW;
  localparam int unsigned LogF      = 16;
  localparam int unsigned ApartW    = FloatEW + LogF + 2;           // s(FloatEW+1).16
  localparam int unsigned FallW     = 20;                           // u4.16
  localparam int unsigned Drop      = LogF + 1 - pipegs_pkg::OpacityF;  // the half, rounded to OpacityF
  localparam int unsigned SumW      = OpacityW + 1;
  localparam logic [FallW-1:0] Most = FallW'(1001896);              // -log2(2.5e-5)
  localparam logic [1:0] Steps      = 2'd2;                         // cycles before the sum

  pipegs_pkg::covariance_t in_q, out_q;
  logic                    in_valid_q, out_valid_q;
  logic [1:0]              step_q;
  logic                    take, move;

  assign move = in_valid_q && step_q == Steps && (!out_valid_q || compensated_ready_i);
  assign take = covariance_valid_i && covariance_ready_o;
  assign covariance_ready_o  = !in_valid_q || move;
  assign compensated_valid_o = out_valid_q;
  assign compensated_o       = out_q;
  assign busy_o              = in_valid_q || out_valid_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      in_valid_q  <= 1'b0;
      out_valid_q <= 1'b0;
      step_q      <= '0;
    end else begin
      if (covariance_ready_o) in_valid_q <= covariance_valid_i;
      if (take) step_q <= '0;
      else if (in_valid_q && step_q != Steps) step_q <= step_q + 2'd1;
      if (move) out_valid_q <= 1'b1;
      else if (compensated_ready_i) out_valid_q <= 1'b0;
    end
  end

  // --- how far apart the two determinants are ------------------------------------------------------------------------
  logic [LogF-1:0]          log_det, log_sharp;
  logic signed [ApartW-1:0] apart;
  logic [FallW-1:0]         fall, halves;
  logic [SumW-1:0]          sum;

  pipegs_log2 u_det   (.clk_i, .enable_i(in_valid_q), .m_i(in_q.det_m[MantissaW-1:MantissaW-SharpW]), .log2_o(log_det));
  pipegs_log2 u_sharp (
    .clk_i,
    .enable_i(in_valid_q),
    .m_i(in_q.sharp_m),
    .log2_o(log_sharp)
  );

  assign apart = $signed({ApartW'(in_q.det_e) - ApartW'(in_q.sharp_e)}) * $signed(ApartW'(1) << LogF) +
                 $signed({{(ApartW - LogF){1'b0}}, log_det}) - $signed({{(ApartW - LogF){1'b0}}, log_sharp});
  always_comb begin
    if (in_q.sharp_m == '0) fall = Most;
    else if (apart[ApartW-1]) fall = '0;
    else if (apart > $signed({{(ApartW - FallW){1'b0}}, Most})) fall = Most;
    else fall = apart[FallW-1:0];
  end
  assign halves = (fall >> (Drop - 1)) + FallW'(1);  // adding one rounds to nearest; Most leaves room for it
  assign sum    = SumW'(in_q.opacity) + SumW'(halves[FallW-1:1]);

  always_ff @(posedge clk_i) begin
    if (take) in_q <= covariance_i;
    if (move) begin
      out_q <= in_q;
      if (antialias_i && in_q.kind == pipegs_pkg::KindData) out_q.opacity <= sum[SumW-1] ? '1 : sum[OpacityW-1:0];
    end
  end

  wire unused_bits = &{1'b0, halves[0]};

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits(compensated_o))) u_check_compensated (
    .clk_i,
    .rst_ni,
    .valid_i(compensated_valid_o),
    .ready_i(compensated_ready_i),
    .beat_i(compensated_o)
  );
`endif

endmodule
