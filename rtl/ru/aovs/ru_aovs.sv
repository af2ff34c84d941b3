// SPDX-License-Identifier: Apache-2.0
// ru_aovs: what a lane keeps of its pixel beside the colour: how many Gaussians, how deep, which one weighs most.
//
// Paper   None: its RUs give colours.
// Idea    All follows from what ru_blend knows. blended counts; expected sums weight * depth; median is the depth of
//         the Gaussian with which T falls below one half; best is the largest weight, index whose it is: the first one
//         with it, so of equal ones the nearest. What the machine has not (AovCoverage ...) has no bits.
// Stream  cycle 1 (enable_i): T before and after, the weight, whether the Gaussian is blended, its depth. cycle 2: its
//         depth and index, the pixel in and out: pixel_aovs_t. T, weight u1.(TW-1), depth u0.LinearW of the range.
// Round   weight * depth to nearest, ties up; sum and count stay at the top.
// Pace    One pixel per cycle; registers hold while enable_i is low.
// Model   ru_add_aovs in cpp_model/ru/ru_aovs.hpp

module ru_aovs #(
  localparam int unsigned TW     = pipegs_pkg::TW,
  localparam int unsigned IndexW = pipegs_pkg::ShownIndexW,
  localparam int unsigned DepthW = pipegs_pkg::HasDepths ? pipegs_pkg::LinearW : 1,
  localparam int unsigned AovW   = pipegs_pkg::HasAovs ? pipegs_pkg::AovBits : 1
) (
  input  logic              clk_i,
  input  logic              enable_i,

  input  logic              taken_i,
  input  logic [TW-1:0]     before_i,
  input  logic [TW-1:0]     after_i,
  input  logic [TW-1:0]     weight_i,
  input  logic [DepthW-1:0] depth_1_i,

  input  logic [DepthW-1:0] depth_2_i,  // the same a cycle later
  input  logic [IndexW-1:0] index_2_i,
  input  logic [AovW-1:0]   aovs_i,
  output logic [AovW-1:0]   aovs_o
);

  localparam int unsigned BlendedW  = pipegs_pkg::BlendedW;
  localparam int unsigned ExpectedW = pipegs_pkg::ExpectedW;
  localparam int unsigned MedianW   = pipegs_pkg::MedianW;
  localparam int unsigned BestW     = pipegs_pkg::BestW;
  localparam int unsigned FirstBest = BlendedW + ExpectedW + MedianW;

  if (pipegs_pkg::AovCoverage != 0) begin : gen_coverage
    logic [BlendedW-1:0] blended;
    logic                taken_q;
    always_ff @(posedge clk_i) if (enable_i) taken_q <= taken_i;
    assign blended              = aovs_i[BlendedW-1:0];
    assign aovs_o[BlendedW-1:0] = taken_q && blended != '1 ? blended + 1'b1 : blended;
  end

  if (pipegs_pkg::AovDepth != 0) begin : gen_depth
    localparam int unsigned ProductW = TW + DepthW;
    localparam logic [ProductW-1:0] Half = ProductW'(1) << (TW - 2);  // half of the last bit
    logic [ProductW-1:0] product;
    logic [DepthW-1:0]   add_q;  // the weight is at most one
    logic [DepthW:0]     total;
    assign product = ProductW'(weight_i) * ProductW'(depth_1_i) + Half;
    always_ff @(posedge clk_i) if (enable_i) add_q <= taken_i ? DepthW'(product >> (TW - 1)) : '0;
    assign total = {1'b0, aovs_i[BlendedW +: ExpectedW]} + {1'b0, add_q};
    assign aovs_o[BlendedW +: ExpectedW] = total[DepthW] ? '1 : total[DepthW-1:0];
  end

  if (pipegs_pkg::AovMedian != 0) begin : gen_median
    logic falls_q;  // T falls below one half
    always_ff @(posedge clk_i) begin
      if (enable_i) falls_q <= taken_i && before_i[TW-1:TW-2] != '0 && after_i[TW-1:TW-2] == '0;
    end
    assign aovs_o[BlendedW+ExpectedW +: MedianW] = falls_q ? depth_2_i : aovs_i[BlendedW+ExpectedW +: MedianW];
  end

  if (pipegs_pkg::AovIndex != 0) begin : gen_index
    logic [BestW-1:0] weight_q;
    always_ff @(posedge clk_i) if (enable_i) weight_q <= taken_i ? weight_i : '0;
    assign aovs_o[AovW-1:FirstBest] = weight_q > aovs_i[FirstBest +: BestW] ? {index_2_i, weight_q}
                                                                           : aovs_i[AovW-1:FirstBest];
  end

  logic unused_inputs;  // of what the machine has not
  assign unused_inputs = &{1'b0, before_i, after_i, weight_i, depth_1_i, depth_2_i, index_2_i};

endmodule
