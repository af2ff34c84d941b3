// SPDX-License-Identifier: Apache-2.0
// dopu_hull: which box of a node meets the planes of a window, and grown by which scale.
//
// Paper   None.
// Idea    Seen from far away a Gaussian reaches no further than the box around its ellipsoid says, but for a share
//         K / z of its largest reach K, z its depth. Where K < z that box counts, grown by scale_max K / z, else the
//         box of the means, grown by scale_max. Products and quotients are sums of logarithms: exponent and first six
//         bits of the mantissa, with what that cuts off given back.
// Stream  None: a node, the near plane's step of depth and the bucket of the node's parent in, the choice and the scale
//         out. Only built when TightBoxes is 1.
// Pace    Combinational.
// Model   cpp_model/dopu/dopu_hull.hpp

module dopu_hull #(
  localparam int unsigned ScaleW  = pipegs_pkg::ScaleW,
  localparam int unsigned StepW   = pipegs_pkg::StepW,
  localparam int unsigned BucketW = pipegs_pkg::BucketW
) (
  input  pipegs_pkg::node_t  node_i,
  input  logic [StepW-1:0]   near_step_i,
  input  logic [BucketW-1:0] parent_i,
  output logic               tight_o,  // the box around the ellipsoids counts
  output logic [ScaleW-1:0]  scale_o
);

  localparam int unsigned LogF   = 6;
  localparam int unsigned Cut    = pipegs_pkg::ScaleMW - LogF;
  localparam int unsigned FieldW = ScaleW - Cut;                   // a logarithm in 1/64, biased as the scale is
  localparam int unsigned RatioW = pipegs_pkg::ExpW + LogF + 3;    // with a sign, sums of three
  localparam int unsigned Bits   = pipegs_pkg::BucketBits;         // fraction of a step
  localparam logic signed [RatioW-1:0] Bias = RatioW'(pipegs_pkg::HullLog) - RatioW'((8 << LogF) - 1);

  localparam logic signed [RatioW-1:0] Least = RatioW'(-6);  // from which on the scale would not be smaller

  logic [StepW:0]           edge_step;  // of the bucket: what can be seen of the node is not nearer
  logic signed [RatioW-1:0] scale, depth, ratio, smaller;
  assign edge_step = (StepW+1)'(near_step_i) + (StepW+1)'(parent_i);
  assign scale     = $signed(RatioW'(node_i.scale_max[ScaleW-1:Cut]));
  if (Bits > LogF) begin : gen_fine
    assign depth = $signed(RatioW'(edge_step[StepW:Bits-LogF]));
    logic unused_fine;
    assign unused_fine = ^edge_step[Bits-LogF-1:0];
  end else begin : gen_coarse
    assign depth = $signed(RatioW'(edge_step) << (LogF - Bits));
  end
  assign ratio   = scale - depth + Bias;             // at least 64 log2(K / z)
  assign smaller = scale + scale - depth + (Bias + RatioW'(7));
  assign tight_o = ratio < Least;
  always_comb begin
    if (!tight_o) scale_o = node_i.scale_max;
    else if (node_i.scale_max[ScaleW-1:pipegs_pkg::ScaleMW] == '0) scale_o = '0;
    else if (smaller < $signed(RatioW'(1 << LogF))) scale_o = ScaleW'(1) << pipegs_pkg::ScaleMW;
    else scale_o = {smaller[FieldW-1:0], {Cut{1'b0}}};
  end

  logic unused;  // tight: no bit is set there; the box itself
  assign unused = ^{smaller[RatioW-1:FieldW], node_i};

endmodule
