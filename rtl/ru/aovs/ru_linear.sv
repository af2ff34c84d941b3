// SPDX-License-Identifier: Apache-2.0
// ru_linear: the depth key of a Gaussian as a fraction of the frame's range of depths.
//
// Paper   None: its RUs give colours.
// Idea    A key is an exponent and a mantissa: the mantissa with its leading one, shifted by how far the exponent lies
//         below that of the range. What lies beyond the range has the largest depth.
// Stream  depth_i key; range_i: the range is 2^(range + 1) world units -> linear_o u0.LinearW of it. Combinational.
// Round   To nearest, ties up; of a mantissa wider than LinearW the lower bits are left out before.
// Model   ru_linear in cpp_model/ru/ru_aovs.hpp

module ru_linear #(
  localparam int unsigned DepthW  = pipegs_pkg::DepthW,
  localparam int unsigned RangeW  = pipegs_pkg::ExpW,
  localparam int unsigned LinearW = pipegs_pkg::LinearW
) (
  input  logic [DepthW-1:0]  depth_i,
  input  logic [RangeW-1:0]  range_i,
  output logic [LinearW-1:0] linear_o
);

  localparam int unsigned MantissaW = DepthW - RangeW;
  localparam int unsigned Up        = MantissaW > LinearW ? 0 : LinearW - MantissaW;
  localparam int unsigned Cut       = MantissaW > LinearW ? MantissaW - LinearW : 0;

  logic [RangeW-1:0]  exponent, down;
  logic [LinearW:0]   aligned, shifted;  // one bit of fraction below LinearW bits
  logic [LinearW+1:0] rounded;

  assign exponent = depth_i[DepthW-1:MantissaW];
  assign down     = range_i - exponent;
  assign aligned  = (LinearW + 1)'({1'b1, depth_i[MantissaW-1:Cut]}) << Up;
  assign shifted  = aligned >> down;
  assign rounded  = (LinearW + 2)'(shifted) + 1'b1;
  assign linear_o = exponent > range_i || rounded[LinearW+1] ? '1 : rounded[LinearW:1];

  logic unused_bits;
  assign unused_bits = &{1'b0, rounded[0], depth_i};

endmodule
