// SPDX-License-Identifier: Apache-2.0
// ru_blend: one lane (the paper's Rendering Unit): blends one Gaussian into one pixel, front to back.
//
// Paper   Eq. 2: C += c * alpha * T,  T *= 1 - alpha.
// Idea    One product serves weight and update: w = T * alpha, T' = T - w, so T plus the sum of all weights stays 1.
//         INRIA's stop rule: when T' would fall below 1/TCut (1e-4) the pixel is done and this Gaussian is not blended
//         (EarlyStop 0: never; done says only that the pixel lies outside the image). With rest_i: of a pixel whose T
//         is below it the next Gaussian takes all. That is known from T alone, beside the product.
// Stream  cycle 0 (enable_1_i): alpha code, T and done. cycle 1 (enable_2_i): colour. cycle 2: accumulated colour in,
//         new T, done and colour out. T u1.(TW-1), alpha u0.AlphaW, colour u2.(ColorW-2), accumulated u2.(RgbW-2).
// Round   w and w * colour to nearest, ties up; the accumulated colour saturates at the top (wraps if Saturation is 0).
// Pace    One pixel per cycle; one multiplication per stage. Registers hold while their enable is low.
// Model   cpp_model/ru/ru_blend.hpp

module ru_blend (
  input  logic                                    clk_i,
  input  logic [pipegs_pkg::TW-1:0]               rest_i,  // T, of the frame; 0: INRIA's rule

  input  logic                                    enable_1_i,
  input  logic [pipegs_pkg::AlphaW-1:0]           code_i,
  input  logic [pipegs_pkg::TW-1:0]               t_i,
  input  logic                                    done_i,

  input  logic                                    enable_2_i,
  input  logic [pipegs_pkg::ColorW-1:0]           red_i,
  input  logic [pipegs_pkg::ColorW-1:0]           green_i,
  input  logic [pipegs_pkg::ColorW-1:0]           blue_i,

  input  logic [3*pipegs_pkg::RgbW-1:0]           rgb_i,  // blue, green, red; red lowest
  output logic [3*pipegs_pkg::RgbW-1:0]           rgb_o,
  output logic [pipegs_pkg::TW-1:0]               t_o,
  output logic                                    done_o
);

  localparam int unsigned TW = pipegs_pkg::TW;
  localparam int unsigned RgbW = pipegs_pkg::RgbW;
  localparam int unsigned AlphaW = pipegs_pkg::AlphaW;
  localparam int unsigned ProductW = TW + AlphaW;
  localparam int unsigned ColorProductW = TW + pipegs_pkg::ColorW;
  localparam int unsigned AddW = RgbW + 1;                    // a rounded product may just reach 4.0
  localparam int unsigned ColorShift = ColorProductW - AddW;  // fraction bits that the rounding removes

  localparam logic [ColorProductW-1:0] ColorHalf = ColorProductW'(1) << (ColorShift - 1);  // half of the last bit
  localparam logic [ProductW-1:0] Half = ProductW'(1) << (AlphaW - 1);

  // w * colour with the fraction of the accumulated colour.
  function automatic logic [AddW-1:0] scaled(input logic [TW-1:0] weight, input logic [pipegs_pkg::ColorW-1:0] color);
    scaled = AddW'((ColorProductW'(weight) * ColorProductW'(color) + ColorHalf) >> ColorShift);
  endfunction

  function automatic logic [RgbW-1:0] added(input logic [RgbW-1:0] sum, input logic [AddW-1:0] add);
    logic [AddW:0] total;
    total = (AddW + 1)'(sum) + (AddW + 1)'(add);
    added = pipegs_pkg::Saturation != 0 && total[AddW:RgbW] != '0 ? '1 : total[RgbW-1:0];
  endfunction

  logic [TW-1:0]   weight_1_q, t_1_q, t_2_q;
  logic            done_1_q, done_2_q;
  logic [AddW-1:0] red_2_q, green_2_q, blue_2_q;
  logic [TW-1:0]   remain, weight;
  logic            last_1_q;  // the Gaussian takes all
  logic            over;      // it would leave too little
  logic            hold;      // it is not blended

  assign remain = t_1_q - weight_1_q;
  assign over   = pipegs_pkg::EarlyStop != 0 && rest_i == '0 && remain < TW'(pipegs_pkg::TStop);
  assign hold   = done_1_q || over;
  assign weight = last_1_q ? t_1_q : weight_1_q;

  always_ff @(posedge clk_i) begin
    if (enable_1_i) begin
      weight_1_q <= TW'((ProductW'(t_i) * ProductW'(code_i) + Half) >> AlphaW);
      t_1_q      <= t_i;
      done_1_q   <= done_i;
      last_1_q   <= t_i < rest_i && code_i != '0;
    end
    if (enable_2_i) begin
      t_2_q     <= hold ? t_1_q : last_1_q ? '0 : remain;
      done_2_q  <= hold || last_1_q;
      red_2_q   <= hold ? '0 : scaled(weight, red_i);
      green_2_q <= hold ? '0 : scaled(weight, green_i);
      blue_2_q  <= hold ? '0 : scaled(weight, blue_i);
    end
  end

  assign t_o    = t_2_q;
  assign done_o = done_2_q;
  assign rgb_o  = {added(rgb_i[2*RgbW +: RgbW], blue_2_q), added(rgb_i[RgbW +: RgbW], green_2_q),
                   added(rgb_i[RgbW-1:0], red_2_q)};

endmodule
